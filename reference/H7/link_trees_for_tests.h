// STAFF ONLY. Trees of links for tests, and Newton's and Euler's laws for each link, which do not use H7.
#pragma once

#include <random>
#include <vector>

#include "hair/rigid_links/tree_motion.h"

namespace reference_tests {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using hair::JointType;

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : generator_(seed) {}
  double between(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(generator_);
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(generator_); }
  Vector3d vector(double size) { return size * Vector3d(between(-1, 1), between(-1, 1), between(-1, 1)); }
  Vector3d direction() { return Vector3d(normal(), normal(), normal()).normalized(); }
  Eigen::Quaterniond turn() {
    return Eigen::Quaterniond(normal(), normal(), normal(), normal()).normalized();
  }

 private:
  double normal() { return std::normal_distribution<double>()(generator_); }
  std::mt19937 generator_;
};

// Links of about 1 kg and 1 m, joints of the given types, parents at random (`chain`: the link before).
hair::LinkTree random_tree(int links, const std::vector<JointType>& types, bool chain,
                           RandomNumbers& numbers);

// n rods of equal length and mass, with spherical joints, hanging down.
hair::LinkTree rod_chain(int n, double length, double mass, double radius);

// Random coordinates of any size.
VectorXd random_coordinates(const hair::LinkTree& tree, RandomNumbers& numbers);

// The Q for these accelerations, link by link from their places (frames) by Newton's and Euler's laws.
VectorXd joint_forces(const hair::TreeMotion& motion, const hair::TreeBase& base, const VectorXd& rates,
                      const VectorXd& accelerations);

// Makes the three passes.
void accelerate(hair::TreeMotion& motion, const VectorXd& rates, const VectorXd& Q, VectorXd& accelerations);

// Adds the weight of all links.
void add_weight(const Vector3d& gravity, hair::TreeMotion& motion);

}  // namespace reference_tests
