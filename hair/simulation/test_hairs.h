// STAFF ONLY. Hairs for the tests of strands.
#pragma once

#include <array>

#include "hair/simulation/simulation.h"
#include "hair/strand/make_strand.h"
#include "hair/strand/rest_shape.h"
#include "solver/test_numbers.h"

namespace reference_tests {

using Eigen::Vector3d;
using hair::Description;
using hair::Method;
using hair::Simulation;
using hair::StrandStart;

constexpr double kG = kGravity;
inline const Vector3d kDown = -Vector3d::UnitZ();

inline constexpr std::array kExplicitMethods = {Method::forward_euler, Method::symplectic_euler,
                                                Method::midpoint, Method::runge_kutta_4};
inline constexpr std::array kMethods = {Method::forward_euler,  Method::symplectic_euler,
                                        Method::midpoint,       Method::runge_kutta_4,
                                        Method::implicit_euler, Method::predictor_corrector};

inline const char* name_of(Method method) {
  return hair::row_of(method).name;
}

// Straight hair at rest, starting at the origin.
inline StrandStart straight_hair(int segments, double length, const Vector3d& direction = kDown,
                                 const hair::Material& material = {}) {
  const Eigen::VectorXd x =
      hair::straight_shape(segments, length, {Vector3d::Zero(), direction, direction.unitOrthogonal()}).x;
  return {hair::strand_from_rest(material, x), {x, Eigen::VectorXd::Zero(x.size())}};
}

// One strand without external forces.
inline Description alone(StrandStart start, Method method, double step) {
  Description description;
  description.strands.push_back(std::move(start));
  description.method = method;
  description.step = step;
  description.gravity.setZero();
  return description;
}

inline Vector3d particle(const Simulation& simulation, int i, int strand = 0) {
  return simulation.state(strand).x.segment<3>(3 * i);
}

}  // namespace reference_tests
