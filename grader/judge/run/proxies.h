// STAFF ONLY. An exercise's functions as proxies: each calls the student's worker of the present run. The
// definitions are generated, grader/cmake/definitions.cmake.
#pragma once

#include "grader/calls/client.h"
#include "grader/judge/run/play.h"

namespace grader::inline judge {

struct PlayAsker {
  MessageReader ask(const MessageWriter& request, const Products& products) {
    return ask_student(request, products);
  }
  template <auto function>
  void start(MessageWriter&, const auto&...) const {}
  bool served(const particles::Force&) const { return false; }
  void scratch(const auto&, int) {}
  void changed() {}
};

template <class Calls, auto function, class... Arguments>
ResultOf<function> proxied(Arguments&&... arguments) {
  PlayAsker asker;
  if constexpr (Signature<decltype(function)>::returns_matrix)
    return matrix_of<Calls, function>(asker, arguments...);
  else
    return ask<Calls, function>(asker, arguments...);
}

}  // namespace grader::judge
