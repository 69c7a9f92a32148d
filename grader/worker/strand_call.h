// STAFF ONLY. A request of H1, H2 or H3 and its memory. Function 0 is the energy, 1 the force, 2 and up are
// products:
//
//   function, geometric term, strand, x, dx, initial value of f or df  ->  E | f | df
#pragma once

#include <Eigen/Core>

#include "grader/wire/strand_message.h"
#include "grader/worker/session.h"
#include "hair/geometric_term.h"

namespace grader {

struct StrandCall {
  explicit StrandCall(Session& session)
      : function(session.request.get<int>()),
        term(static_cast<hair::GeometricTerm>(session.request.get<int>())),
        strand(get_strand(session.request)),
        x(session.request.get_doubles()),
        dx(session.request.get_doubles()),
        result(session.request.get_doubles()) {}

  static Eigen::Map<Eigen::VectorXd> vector(GuardedBuffer& buffer) {
    return {buffer.data(), static_cast<Eigen::Index>(buffer.values().size())};
  }

  int function;
  hair::GeometricTerm term;
  hair::Strand strand;
  GuardedBuffer x, dx, result;
};

}  // namespace grader
