// STAFF ONLY. Guides for tests of dense hair: roots on a disc or on a ball, and curls that grow from them.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "hair/dense/synthesis.h"
#include "hair/strand/variation.h"

namespace reference_tests {

using Eigen::VectorXd;
using hair::RootFrame, hair::Vector3d;

// Roots on the spiral of a sunflower's seeds, on the plane z = 0.
inline std::vector<RootFrame> roots_on_disc(int count, double radius) {
  std::vector<RootFrame> roots;
  for (int i = 0; i < count; ++i) {
    const double r = radius * std::sqrt((i + 0.5) / count), angle = 2.4 * i;
    roots.push_back(
        {Vector3d(r * std::cos(angle), r * std::sin(angle), 0), Vector3d(0, 0, 1), Vector3d(1, 0, 0)});
  }
  return roots;
}

// The same on a ball, up to `reach` (rad) from its top.
inline std::vector<RootFrame> roots_on_ball(int count, double radius, double reach) {
  std::vector<RootFrame> roots;
  for (int i = 0; i < count; ++i) {
    const double height = 1 - (1 - std::cos(reach)) * (i + 0.5) / count,
                 across = std::sqrt(1 - height * height);
    const Vector3d normal(across * std::cos(2.4 * i), across * std::sin(2.4 * i), height);
    roots.push_back({radius * normal, normal.normalized(), Vector3d(1, 0, 0)});
  }
  return roots;
}

inline double some_phase(std::size_t guide) {
  return hair::Variation(7, guide).uniform(0, 2 * std::numbers::pi);
}

// A curl along the normal, each with a phase of its own: radius `curl`, a turn takes six points and advances
// by `pitch`.
inline VectorXd curls(const std::vector<RootFrame>& roots, int n, double curl, double pitch) {
  VectorXd points(static_cast<Eigen::Index>(roots.size()) * 3 * n);
  for (std::size_t g = 0; g < roots.size(); ++g) {
    const Vector3d x = hair::side_along_scalp(Vector3d(0, 0, 1), roots[g].axis), y = roots[g].axis.cross(x);
    const auto on_circle = [&](double angle) -> Vector3d {
      return curl * (std::cos(angle) * x + std::sin(angle) * y);
    };
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * i / 6;
      points.segment<3>(3 * (static_cast<Eigen::Index>(g) * n + i)) =
          roots[g].position + on_circle(angle + some_phase(g)) - on_circle(some_phase(g)) +
          pitch * i / 6 * roots[g].axis;
    }
  }
  return points;
}

inline std::vector<double> make_all(hair::Synthesis& synthesis, const VectorXd& guides,
                                    const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity()) {
  std::vector<double> strands(3 * static_cast<std::size_t>(synthesis.children()) * synthesis.points());
  synthesis.make({guides.data(), static_cast<std::size_t>(guides.size())}, turn, {},
                 std::span<double>(strands));
  return strands;
}

}  // namespace reference_tests
