// STAFF ONLY. The suite as the host of a server (grader/calls/server.h): it calls the reference's functions
// for a worker.
#pragma once

#include <algorithm>

#include "grader/calls/server.h"
#include "grader/judge/student/provided.h"
#include "reference/S1/calls.h"

namespace grader::inline judge {

class ProvidingHost {
 public:
  using Vector = UnguardedVector;

  ProvidingHost(const Products& served, const Products& callback, std::vector<ProvidedSolve>& solves)
      : served_(served), callback_(callback), solves_(solves) {}

  void ask(const Question& question) {
    std::vector<double> answer;
    const Products& asked = question.provided ? served_ : callback_;
    if (!asked(question.which, {question.numbers.begin(), question.numbers.end()}, answer))
      throw StoppedCall();
    if (answer.size() != question.answer.size()) throw MalformedMessage("a product of another length");
    std::copy(answer.begin(), answer.end(), question.answer.begin());
  }

  template <class Call, class... Arguments>
  typename Call::Signature::Result call(Arguments&&... arguments) {
    if constexpr (std::is_same_v<Call, s1::Calls::Of<s1::conj_grad>>)
      return solve(arguments...);
    else
      return Call::function(arguments...);
  }
  void bound(int& sweeps, Eigen::Index size) {
    sweeps = std::clamp(sweeps, 0, kMostWork / std::max(1, static_cast<int>(size / 3)));
  }
  void served(const particles::Force&) {}

 private:
  // Bounds segments times sweeps of a call, 0.1 s or so. Hair takes a hundredth of it.
  static constexpr int kMostWork = 5'000'000;

  double solve(const Operator& A, particles::Output x, particles::Output b, double epsilon, int& steps) {
    const int most = steps;
    const double value = s1::conj_grad(A, x, b, epsilon, steps);
    solves_.push_back({most, epsilon, value});
    return value;
  }

  const Products& served_;
  const Products& callback_;
  std::vector<ProvidedSolve>& solves_;
};

}  // namespace grader::judge
