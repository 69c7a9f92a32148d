// STAFF ONLY. H7's hidden cases: their trees of links that move, sizes for the bounds of errors, and a
// student's passes, asked for through the pipe and compared.
#pragma once

#include <string>
#include <vector>

#include "grader/judge/cases/trial.h"
#include "hair/rigid_links/tree_motion.h"

namespace grader::h7 {

using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::JointType, hair::Link, hair::LinkPass;

inline const std::vector<JointType> kRevolute = {JointType::revolute};
inline const std::vector<JointType> kRequired = {JointType::revolute, JointType::prismatic};
inline const std::vector<JointType> kSpherical = {JointType::spherical, JointType::revolute,
                                                  JointType::prismatic};

struct Tree {
  std::vector<Link> links;
  std::vector<LinkPass> passes;  // passes[0] has the base's v and a
  VectorXd rates, Q;
};

// chain: each link hangs from the one before. branches: each hangs from any link before, but the last one not
// from the one right before it. strands: three chains hang from link 1, and their links take turns. star: all
// links hang from the base, with their centres of mass at its own.
enum class Form { chain, branches, strands, star };

struct TreeKind {
  int links;  // without the base
  const std::vector<JointType>& types;
  bool moves = true;  // joints and base; otherwise all is at rest
  Form form = Form::chain;
  bool stiffens = false;
};

// Links of about 1 kg, half a metre long, with different moments of inertia of about 0.1 kg m^2, joints at
// any place of them, and forces and torques of about 10 N and N m. The first joints are of each type in turn.
Tree random_tree(Random& random, const TreeKind& kind);

// The first of `chosen` as the base, and the others as links; all of their parents are among them.
Tree part_of(const Tree& tree, const std::vector<int>& chosen);
std::vector<LinkPass> part_of(const std::vector<LinkPass>& passes, const std::vector<int>& chosen);
// The part of the whole tree's rates, Q or accelerations.
VectorXd part_of(const Tree& tree, const VectorXd& numbers, const std::vector<int>& chosen);

// The same tree in other units of mass, length and time, with its passes. Powers of 2 change no digit.
struct Units {
  double mass = 1, length = 1, time = 1;
};
Tree in_units(const Tree& tree, const Units& units);

// The spatial joint axis s^ of a revolute or prismatic joint.
hair::SpatialMotion axis_of(const Link& link);

// Makes the reference's passes up to pass 1, 2 or 3, and returns its accelerations.
VectorXd reference_passes(Tree& tree, int up_to);

// The size of 100 roundings a link.
double roundings(const Tree& tree);

// Sizes that no number of the tree exceeds by much, for any point and order in a right formula: the greatest
// distance between links, the greatest angular and linear velocity, the total mass.
struct Sizes {
  double length, turn, speed, mass;
  double acceleration() const { return turn * (turn * length + speed); }
};
Sizes sizes_of(const Tree& tree);

// The sum of sizes of all accelerations of a tree after pass 3, of links and of `joints`.
double accelerations_size(const Tree& tree, const Sizes& sizes, const VectorXd& joints);

// The greatest force through a joint of a tree after pass 1: the sum of all forces on links, of those that
// their c^ needs, and of Q over a joint's shortest arm.
double force_size(const Tree& tree);

// ---- Answers

// The student's results of pass `pass` (1, 2 or 3) from tree.passes; pass 3 also gives accelerations.
struct Answered {
  std::vector<LinkPass> passes;
  VectorXd accelerations;
};
Answered ask(Trial& trial, int pass, const Tree& tree);
Answered part_of(const Tree& tree, const Answered& answered, const std::vector<int>& chosen);

// The largest difference of one member of a pass, over all links from `first` on. `length` converts the
// second half of a motion and of a force to the unit of the first, and blocks of an inertia to kg. NaN if a
// number is NaN.
using Of = std::vector<LinkPass>;
double motion_error(const Of& a, const Of& b, hair::SpatialMotion LinkPass::*member, double length);
double force_error(const Of& a, const Of& b, double length, std::size_t first);
double inertia_error(const Of& a, const Of& b, double length);

// No such difference is larger than `bound`.
void expect_motions(Trial& trial, const Of& actual, const Of& expected, hair::SpatialMotion LinkPass::*member,
                    double length, double bound, const std::string& what);
void expect_forces(Trial& trial, const Of& actual, const Of& expected, double length, std::size_t first,
                   double bound, const std::string& what);
void expect_inertias(Trial& trial, const Of& actual, const Of& expected, double length, double bound,
                     const std::string& what);

// A link's numbers in one unit: N, and kg.
VectorXd bias_of(const LinkPass& pass, double length);
VectorXd inertia_of(const LinkPass& pass, double length);

// True if one number may stand for another one: it is between a millionth and a million times as large.
bool comparable(double own, double ours);

// "4 links, revolute prismatic ..., moving".
std::string in_words(const Tree& tree);

}  // namespace grader::h7
