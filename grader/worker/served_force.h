// STAFF ONLY. A force that the suite holds: the worker requests each value and each product through the pipe,
// so that the suite's counts are correct. The other side is grader/play/force_server.h.
#pragma once

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "grader/wire/force_answer.h"
#include "grader/worker/session.h"
#include "particles/force.h"

namespace grader {

class ServedForce : public particles::Force {
 public:
  // For n particles.
  ServedForce(Session& session, int n) : session_(session), size_(3 * n) { session.served_force = this; }
  ServedForce(const ServedForce&) = delete;
  ServedForce& operator=(const ServedForce&) = delete;

  double energy(particles::Input x) const override {
    const Session::Uncounted ours(session_);
    double energy = 0;
    session_.product(kForceEnergy, joined({&x}), {&energy, 1});
    return energy;
  }
  void add_force(particles::Input x, particles::Input v, particles::Output f) const override {
    add(kForceForce, {&x, &v}, f);
  }
  void add_dfdx(particles::Input x, particles::Input v, particles::Input dx,
                particles::Output df) const override {
    add(kForceDfdx, {&x, &v, &dx}, df);
    spoil_overlap(dx, df);
  }
  void add_dfdv(particles::Input x, particles::Input v, particles::Input dv,
                particles::Output df) const override {
    add(kForceDfdv, {&x, &v, &dv}, df);
    spoil_overlap(dv, df);
  }
  bool add_band(particles::Input x, particles::Input v, double by_dfdx, double by_dfdv,
                solver::BlockBand& band, particles::Scratch /*work*/) const override {
    const Session::Uncounted ours(session_);
    std::vector<double> question = joined({&x, &v}), answer(size_of_band(static_cast<int>(size_)));
    question.push_back(by_dfdx);
    question.push_back(by_dfdv);
    session_.product(kForceBand, question, answer);
    return add_answered_band(answer, band);
  }

 private:
  using View = Eigen::Ref<const Eigen::VectorXd>;

  std::vector<double> joined(std::initializer_list<const View*> vectors) const {
    std::vector<double> all;
    all.reserve(vectors.size() * size_);
    for (const View* vector : vectors) {
      expect_size(vector->size());
      all.insert(all.end(), vector->data(), vector->data() + size_);
    }
    return all;
  }

  void add(int which, std::initializer_list<const View*> inputs, particles::Output& sum) const {
    const Session::Uncounted ours(session_);
    expect_size(sum.size());
    std::vector<double> question = joined(inputs), answer(size_);
    question.insert(question.end(), sum.data(), sum.data() + size_);
    session_.product(which, question, answer);
    sum = Eigen::Map<const Eigen::VectorXd>(answer.data(), size_);
  }

  void expect_size(Eigen::Index size) const {
    if (size != size_)
      throw std::invalid_argument("a vector of " + std::to_string(size) + " numbers for a force on " +
                                  std::to_string(size_ / 3) + " particles");
  }

  // No contract allows it: what comes out is NaN.
  static void spoil_overlap(const View& input, particles::Output& output) {
    const std::less<const double*> before;
    if (before(input.data(), output.data() + output.size()) &&
        before(output.data(), input.data() + input.size()))
      output.setConstant(std::numeric_limits<double>::quiet_NaN());
  }

  Session& session_;
  Eigen::Index size_;
};

}  // namespace grader
