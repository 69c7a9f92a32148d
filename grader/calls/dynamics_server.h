// STAFF ONLY. Serves Dynamics to a student's code: the other side is RemoteDynamics, remote.h.
#pragma once

#include <vector>

#include "grader/wire/message.h"
#include "particles/dynamics.h"

namespace grader::inline calls {

class DynamicsServer {
 public:
  // Serves n particles; it answers `most` questions and then stops the request.
  DynamicsServer(particles::Dynamics& dynamics, int n, int most)
      : dynamics_(dynamics), size_(3 * n), most_(most) {}

  // Is a handler of Products.
  bool operator()(int which, const std::vector<double>& question, std::vector<double>& answer) {
    if (which != 0 || static_cast<int>(question.size()) != 2 * size_)
      throw MalformedMessage("a question that makes no sense");
    answer.assign(size_, 0.0);
    Eigen::Map<Eigen::VectorXd> a(answer.data(), size_);
    dynamics_.acceleration(Eigen::Map<const Eigen::VectorXd>(question.data(), size_),
                           Eigen::Map<const Eigen::VectorXd>(question.data() + size_, size_), a);
    return ++evaluations <= most_;
  }

  int evaluations = 0;  // counted so far

 private:
  particles::Dynamics& dynamics_;
  int size_, most_;
};

}  // namespace grader::calls
