// STAFF ONLY. For allocations_test: an exercise's functions that compute nothing. Each asks what the suite holds, which allocates; if its
// contract promises to allocate nothing, it allocates once. The definitions themselves are generated, grader/cmake/definitions.cmake.
#pragma once

#include <concepts>
#include <vector>

#include "grader/calls/client.h"

namespace grader {

inline void allocate() {
  const std::vector<double> used(3, 1.0);
  const volatile double* const kept = used.data();  // no compiler leaves it out
  static_cast<void>(kept[0]);
}

class AllocatingProduct : public implicitMatrix {
 public:
  explicit AllocatingProduct(implicitMatrix* asked) : asked_(asked), in_(1000), out_(1000) {}
  void matVecMult(double /*x*/[], double /*b*/[]) override {
    if (asked_ != nullptr) asked_->matVecMult(in_.data(), out_.data());
    allocate();
  }

 private:
  implicitMatrix* asked_;
  std::vector<double> in_, out_;
};

// The first matrix among arguments.
inline implicitMatrix* matrix_among() {
  return nullptr;
}
template <class First, class... Rest>
implicitMatrix* matrix_among(const First& first, const Rest&... rest) {
  if constexpr (std::convertible_to<First, implicitMatrix*>)
    return first;
  else
    return matrix_among(rest...);
}

// Asks the forces and dynamics among arguments, with numbers on the stack.
template <class... Arguments>
void ask_served(Arguments&... arguments) {
  constexpr Eigen::Index kMost = 3000;
  const Eigen::Index size = size_of(arguments...);
  if (size > kMost) return;
  double in[kMost] = {}, out[kMost] = {};
  const Eigen::Map<const Eigen::VectorXd> x(in, size);
  Eigen::Map<Eigen::VectorXd> y(out, size);
  const auto ask = [&]<class Argument>(Argument& argument) {
    if constexpr (std::derived_from<Argument, particles::Force>) argument.add_force(x, x, y);
    if constexpr (std::derived_from<Argument, particles::Dynamics>) argument.acceleration(x, x, y);
  };
  (ask(arguments), ...);
}

template <class Calls, auto function>
constexpr bool promises_to_allocate_nothing() {
  if constexpr (Calls::template number_of<function>() >= 0)
    return Calls::template Of<function>::contract.allocates_nothing;
  return false;
}

inline Nothing ours() {
  return {};
}

template <class Calls, auto function, class... Arguments>
ResultOf<function> asked(Arguments&&... arguments) {
  if constexpr (Signature<decltype(function)>::returns_matrix) {
    return std::make_unique<AllocatingProduct>(matrix_among(arguments...));
  } else {
    ask_served(arguments...);
    if (promises_to_allocate_nothing<Calls, function>()) allocate();
    if constexpr (!std::is_void_v<ResultOf<function>>) return {};
  }
}

}  // namespace grader
