// STAFF ONLY. Asks for a student's passes through the pipe, and compares them.
#pragma once

#include <string>

#include "grader/judge/cases/trial.h"
#include "reference/H7/trees.h"

namespace grader::h7 {

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
