// STAFF ONLY. Functions of an exercise that compute nothing, for empty_functions_test. The definitions are
// generated, grader/cmake/definitions.cmake.
#pragma once

#include "grader/calls/client.h"

namespace grader::inline judge {

class NoProduct : public implicitMatrix {
 public:
  void matVecMult(double /*x*/[], double /*b*/[]) override {}
};

template <class Calls, auto function, class... Arguments>
ResultOf<function> proxied(Arguments&&... /*arguments*/) {
  if constexpr (Signature<decltype(function)>::returns_matrix)
    return std::make_unique<NoProduct>();
  else if constexpr (!std::is_void_v<ResultOf<function>>)
    return {};
}

}  // namespace grader::judge
