// STAFF ONLY. An exercise's functions as the suite provides them to a worker whose code needs them as a
// prerequisite: each calls the suite, in the session of the present request. The definitions are generated,
// grader/cmake/definitions.cmake.
#pragma once

#include <limits>
#include <stdexcept>
#include <string>

#include "grader/calls/client.h"
#include "grader/worker/session.h"

// Each object has its own.
extern "C" __attribute__((visibility("default"))) grader::ProvidedSession provided_session;

namespace grader::inline worker {

template <class Calls>
struct ProvidedAsker {
  template <auto function>
  void start(MessageWriter& request, const auto&...) const {
    request.put(std::string(Calls::id));
  }
  MessageReader ask(const MessageWriter& request, const Products& products) const {
    return provided_session->call(
        request, [&](int which, std::vector<double>& x, std::vector<double>& y) { products(which, x, y); });
  }
  bool served(const particles::Force& force) const { return &force == provided_session->served_force; }
  // Fills the columns that the contract gives a function with NaN: a caller loses values there, as with any
  // function of that contract.
  void scratch(particles::Scratch scratch, int columns) const {
    if (scratch.cols() < columns)
      throw std::invalid_argument("scratch of " + std::to_string(scratch.cols()) + " columns; expected " +
                                  std::to_string(columns));
    scratch.leftCols(columns).setConstant(std::numeric_limits<double>::quiet_NaN());
  }
  void changed() const {}
};

template <class Calls, auto function, class... Arguments>
ResultOf<function> proxied(Arguments&&... arguments) {
  using Call = typename Calls::template Of<function>;
  ProvidedAsker<Calls> asker;
  Call::Check::check(arguments...);
  if constexpr (Call::Signature::returns_matrix)
    return matrix_of<Calls, function>(asker, arguments...);
  else
    return ask<Calls, function>(asker, arguments...);
}

}  // namespace grader::worker
