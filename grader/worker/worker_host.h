// STAFF ONLY. A worker as the host of a server (grader/calls/server.h): it calls a student's functions.
#pragma once

#include "grader/calls/server.h"
#include "grader/worker/session.h"
#include "particles/vectors.h"

namespace grader::inline worker {

// Ends before a protected page.
class GuardedVector {
 public:
  explicit GuardedVector(const std::vector<double>& values)
      : buffer_(values), view_(buffer_.data(), static_cast<Eigen::Index>(values.size())) {}

  Eigen::Map<Eigen::VectorXd>& view() { return view_; }
  std::span<const double> values() const { return buffer_.values(); }

 private:
  GuardedBuffer buffer_;
  Eigen::Map<Eigen::VectorXd> view_;
};

class WorkerHost {
 public:
  using Vector = GuardedVector;

  explicit WorkerHost(Session& session) : session_(session) {}

  void ask(const Question& question) { session_.product(question.which, question.numbers, question.answer); }
  template <class Call, class... Arguments>
  decltype(auto) call(Arguments&&... arguments) {
    return Call::function(arguments...);
  }
  void bound(int&, Eigen::Index) {}
  void served(const particles::Force& force) { session_.served_force = &force; }

 private:
  Session& session_;
};

}  // namespace grader::worker
