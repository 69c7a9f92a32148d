// STAFF ONLY. What the proxies of H1, H2 and H3 share: the request of grader/worker/strand_call.h.
#pragma once

#include "grader/play/asking.h"
#include "grader/wire/strand_message.h"
#include "hair/geometric_term.h"
#include "particles/vectors.h"

namespace grader {

inline MessageWriter strand_request(int function, hair::GeometricTerm term, const hair::Strand& strand,
                                    const Eigen::VectorXd& x, const Eigen::VectorXd& dx,
                                    const Eigen::VectorXd& before) {
  MessageWriter request;
  request.put(function).put(static_cast<int>(term));
  put(request, strand);
  put(request, x);
  put(request, dx);
  put(request, before);
  return request;
}

inline double asked_energy(const hair::Strand& strand, particles::Input x) {
  MessageReader reply = ask_student(strand_request(0, hair::GeometricTerm::full, strand, x, {}, {}));
  const double energy = reply.get<double>();
  reply.expect_end();
  return energy;
}

// Function 1 is the force; others are products, with dx.
inline void ask_to_add(int function, hair::GeometricTerm term, const hair::Strand& strand, particles::Input x,
                       const Eigen::VectorXd& dx, particles::Output& sum) {
  MessageReader reply = ask_student(strand_request(function, term, strand, x, dx, sum));
  sum = get_vector(reply, sum.size());
  reply.expect_end();
}

}  // namespace grader
