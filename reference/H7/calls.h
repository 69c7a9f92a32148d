// STAFF ONLY. The calls of H7; see grader/calls/call.h.
#pragma once

#include "grader/calls/call.h"
#include "hair/rigid_links.h"

namespace grader {

template <>
struct Form<hair::SpatialMotion> {
  static constexpr auto fields = std::tuple(&hair::SpatialMotion::angular, &hair::SpatialMotion::linear);
};

template <>
struct Form<hair::SpatialForce> {
  static constexpr auto fields = std::tuple(&hair::SpatialForce::force, &hair::SpatialForce::torque);
};

template <>
struct Form<hair::SpatialInertia> {
  using T = hair::SpatialInertia;
  static constexpr auto fields = std::tuple(&T::M, &T::H, &T::J);
};

template <>
struct Form<hair::Link> {
  using T = hair::Link;
  static constexpr auto fields = std::tuple(&T::parent, &T::joint, &T::first, &T::u, &T::d, &T::r, &T::tensor,
                                            &T::external, &T::inertia, &T::stiffening);
  static void check(const T& link) {
    if (link.joint < hair::JointType::revolute || link.joint > hair::JointType::spherical)
      throw MalformedMessage("an unknown type of joint");
  }
};

template <>
struct Form<hair::LinkPass> {
  using T = hair::LinkPass;
  static constexpr auto fields = std::tuple(&T::v, &T::c, &T::bias, &T::inertia, &T::gain, &T::a);
};

}  // namespace grader

namespace grader::h7 {

// Throws MalformedMessage unless the links are a tree, its base first, with vectors and passes of its size.
struct OneTree {
  static void check(const std::vector<hair::Link>& links, const auto& input,
                    const std::vector<hair::LinkPass>& passes, const auto&... accelerations) {
    if (links.empty()) throw MalformedMessage("a tree of links without its base");
    int rates = 0;
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (links[i].parent < 0 || links[i].parent > std::max(0, static_cast<int>(i) - 1))
        throw MalformedMessage("a link whose parent comes later");
      if (links[i].first != rates) throw MalformedMessage("rates that are not in the order of their links");
      if (i > 0) rates += hair::rates_of(links[i].joint);
    }
    for (const Eigen::Index size : {input.size(), accelerations.size()...})
      if (size != rates) throw MalformedMessage("numbers of another tree's rates");
    if (passes.size() != links.size()) throw MalformedMessage("passes of another tree");
  }
};

template <auto function>
using Pass = Call<function, Contract{}, OneTree>;

struct Calls : CallList<Pass<hair::outward_velocities>, Pass<hair::inward_inertias>,
                        Pass<hair::outward_accelerations>> {
  static constexpr const char* id = "H7";
};

}  // namespace grader::h7
