// STAFF ONLY. Serves a force, or Dynamics, to a student's code, and counts the questions: the other side is
// remote.h.
#pragma once

#include <vector>

#include "grader/wire/force_message.h"
#include "grader/wire/message.h"
#include "particles/dynamics.h"
#include "particles/force.h"
#include "particles/state.h"

namespace grader::inline calls {

// Stores the states of force evaluations, too.
class ForceServer {
 public:
  // Serves n particles; it answers `most` questions and then stops the request.
  ForceServer(const particles::Force& force, int n, int most) : force_(force), size_(3 * n), most_(most) {}

  // This is a handler of Products.
  bool operator()(int which, const std::vector<double>& question, std::vector<double>& answer);

  int energies = 0, forces = 0, dfdx = 0, dfdv = 0, bands = 0;  // count questions so far
  // These are the states of the first evaluations, and the number of products with df/dv before each.
  std::vector<particles::State> forces_at;
  std::vector<int> products_before;

 private:
  const particles::Force& force_;
  int size_, most_;
};

class DynamicsServer {
 public:
  // Serves n particles; it answers `most` questions and then stops the request.
  DynamicsServer(particles::Dynamics& dynamics, int n, int most)
      : dynamics_(dynamics), size_(3 * n), most_(most) {}

  // This is a handler of Products.
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
