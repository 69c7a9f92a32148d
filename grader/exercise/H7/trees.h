// STAFF ONLY. Inputs of H7's hidden cases: trees of links that move, and the sizes of what is calculated of them.
#pragma once

#include <vector>

#include "grader/suite/random.h"
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

struct TreeKind {
  int links;  // without the base
  const std::vector<JointType>& types;
  bool moves = true;      // joints and base; otherwise all is at rest
  bool branches = false;  // any link before is a parent; otherwise the one before
  bool stiffens = false;
  double lightest = 1;  // of the links' masses: every third is so much lighter
  double speed = 2;     // of the joints, rad/s and m/s
};

// Links of about 1 kg, half a metre long, with moments of inertia of about 0.1 kg m^2 that differ; joints anywhere at
// them, forces and torques on all, of about 10 N and N m. The first joints are of each type in turn.
Tree random_tree(Random& random, const TreeKind& kind);

// All passes as the reference makes them, up to pass 1, 2 or 3; the accelerations that it finds.
VectorXd reference_passes(Tree& tree, int up_to);

// Sizes that no number of the tree exceeds by much, whatever point or order a right formula takes: the greatest distance
// between links, the greatest angular and linear velocity, the mass of all.
struct Sizes {
  double length, turn, speed, mass;
};
Sizes sizes_of(const Tree& tree);

}  // namespace grader::h7
