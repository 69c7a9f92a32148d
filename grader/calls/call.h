// STAFF ONLY. The functions of an exercise, as both ends of a pipe see them. The types of their parameters
// decide which way values go:
//
//   numbers, const T&, std::span<const T>, Input     there
//   Output, T&                                       there and back; a list keeps its length
//   Scratch                                          its shape and a filling number; the server makes it
//   const Force&, Dynamics&, Operator                stays with the client, the server asks (remote.h)
//   implicitMatrix&                                  likewise; square, of the size of the call's vectors
//   std::unique_ptr<implicitMatrix>, returned        stays with the server, which makes and multiplies it
//
// reference/<ID>/calls.h lists an exercise's calls, and the forms of its own structs. From the list follow
// the client (client.h), of the suite, of whole runs and of provided functions, and the server (server.h), in
// a worker and for provided functions.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <tuple>

#include "grader/calls/forms.h"
#include "particles/dynamics.h"
#include "particles/force.h"
#include "particles/vectors.h"
#include "solver/linearSolver.h"

namespace grader::inline calls {

// Holds a contract's promises that its types don't show.
struct Contract {
  int scratch_columns = 0;       // are its Scratch's; 0: a matrix is no scratch, it goes there and back
  bool scratch_of_size = false;  // adds as many columns as a vector of the call has numbers
  int sweeps = -1;               // is the argument that bounds its work, to bound hostile callers
  bool may_share = false;        // its Output may be one of its Inputs
};

// This is a matrix of the client's, for a contract with plain pointers.
struct Operator {
  int rows, cols;
  implicitMatrix* matrix;
};

template <class Function>
struct Signature;
template <class R, class... P>
struct Signature<R (*)(P...)> {
  using Result = R;
  using Parameters = std::tuple<P...>;
  static constexpr bool returns_matrix = std::is_same_v<R, std::unique_ptr<implicitMatrix>>;
};

// These take the function's declared types: the result, and a parameter by its number.
template <auto function>
using ResultOf = typename Signature<decltype(function)>::Result;
template <auto function, std::size_t i>
using ParameterOf = std::tuple_element_t<i, typename Signature<decltype(function)>::Parameters>;

// Counts the numbers of an argument that is a vector or a state; -1 for all others.
template <class Argument>
Eigen::Index numbers_of(const Argument& argument) {
  if constexpr (std::is_same_v<Argument, particles::State>) {
    return argument.x.size();
  } else if constexpr (DenseNumbers<Argument>) {
    if constexpr (Argument::SizeAtCompileTime == Eigen::Dynamic && Argument::ColsAtCompileTime == 1)
      return argument.size();
  }
  return -1;
}

// Returns the length of the call's vectors, 3n: that of the first vector. 0 if there is none.
template <class... Arguments>
Eigen::Index size_of(const Arguments&... arguments) {
  for (const Eigen::Index size : {numbers_of(arguments)...})
    if (size >= 0) return size;
  return 0;
}

// Checks a call's arguments: throws MalformedMessage if they do not fit each other. This check is for
// functions whose vectors all have 3n numbers. A check of functions that return a matrix also has
// shape(arguments...), its rows and columns.
struct SameSizes {
  template <class... Arguments>
  static void check(const Arguments&... arguments) {
    const Eigen::Index size = size_of(arguments...);
    const auto expect = [size](Eigen::Index other) {
      if (other != size)
        throw MalformedMessage("vectors of " + std::to_string(size) + " and of " + std::to_string(other) +
                               " numbers in one call");
    };
    const auto look = [&]<class Argument>(const Argument& argument) {
      if constexpr (std::is_same_v<Argument, hair::Strand> || std::is_same_v<Argument, particles::Particles>)
        expect(Eigen::Index{3} * argument.count());
      if constexpr (std::is_same_v<Argument, particles::State>) expect(argument.v.size());
      if (const Eigen::Index numbers = numbers_of(argument); numbers >= 0) expect(numbers);
    };
    (look(arguments), ...);
  }

  template <class... Arguments>
  static std::array<Eigen::Index, 2> shape(const Arguments&... arguments) {
    return {size_of(arguments...), size_of(arguments...)};
  }
};

template <auto function_, Contract contract_ = Contract{}, class Check_ = SameSizes>
struct Call {
  static constexpr auto function = function_;
  static constexpr Contract contract = contract_;
  using Check = Check_;
  using Signature = grader::Signature<decltype(function_)>;
};

// This is a type for each function: UBSan's compilers do not compare functions before they are linked.
template <auto function>
struct Named;

// A request names a call by its place in the list: exercises.json's functions, in their order, then others.
template <class... All>
struct CallList {
  static constexpr int count = sizeof...(All);
  template <int number>
  using At = std::tuple_element_t<number, std::tuple<All...>>;

  template <auto function>
  static constexpr int number_of() {
    int number = 0, found = -1;
    ((found = std::is_same_v<Named<All::function>, Named<function>> ? number : found, ++number), ...);
    return found;
  }
  template <auto function>
  using Of = At<number_of<function>()>;
};

}  // namespace grader::calls
