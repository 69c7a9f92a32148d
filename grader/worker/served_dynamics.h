// STAFF ONLY. Dynamics that the suite holds: the worker requests each acceleration through the pipe, so that
// the suite's count is correct. The other side is grader/exercise/dynamics_server.h.
#pragma once

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "grader/worker/session.h"
#include "particles/dynamics.h"

namespace grader {

class ServedDynamics : public particles::Dynamics {
 public:
  // For n particles.
  ServedDynamics(Session& session, int n) : session_(session), size_(3 * n) {}

  void acceleration(particles::Input x, particles::Input v, particles::Output a) override {
    const Session::Uncounted ours(session_);
    if (x.size() != size_ || v.size() != size_ || a.size() != size_)
      throw std::invalid_argument("acceleration of " + std::to_string(size_) + " numbers asked for with " +
                                  std::to_string(x.size()) + ", " + std::to_string(v.size()) + " and " +
                                  std::to_string(a.size()));
    const bool overlaps = overlap(x, a) || overlap(v, a);
    std::vector<double> question(x.data(), x.data() + size_);
    question.insert(question.end(), v.data(), v.data() + size_);
    session_.product(0, question, {a.data(), static_cast<std::size_t>(size_)});
    if (overlaps) a.setConstant(std::numeric_limits<double>::quiet_NaN());  // no contract allows it
  }

 private:
  bool overlap(particles::Input in, const particles::Output& out) const {
    const std::less<const double*> before;
    return before(in.data(), out.data() + size_) && before(out.data(), in.data() + size_);
  }

  Session& session_;
  Eigen::Index size_;
};

}  // namespace grader
