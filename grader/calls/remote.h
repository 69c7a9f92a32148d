// STAFF ONLY. Objects of the other side, which is called for each product and each value: so its counts are
// right, and no code of one side runs on the other. `Host` is their server (server.h):
//
//   host.ask(question)  sends it, and waits for its answer
//
// No contract allows an output that overlaps the input of a product: the result is NaN.
#pragma once

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "grader/wire/force_message.h"
#include "particles/dynamics.h"
#include "particles/force.h"
#include "solver/linearSolver.h"

namespace grader::inline calls {

// Names operator `which` of the other side. `provided`: it belongs to the force that the suite serves in this
// request, for functions that it provides; see client.h.
struct Question {
  int which;
  bool provided;
  std::span<const double> numbers;
  std::span<double> answer;
};

inline void poison_overlap(const double* in, std::ptrdiff_t in_size, double* out, std::ptrdiff_t out_size) {
  const std::less<const double*> before;
  if (before(in, out + out_size) && before(out, in + in_size))
    std::fill(out, out + out_size, std::numeric_limits<double>::quiet_NaN());
}

template <class Host>
class RemoteMatrix : public implicitMatrix {
 public:
  RemoteMatrix(Host& host, int which, int rows, int cols)
      : host_(host), which_(which), rows_(rows), cols_(cols) {}

  void matVecMult(double x[], double b[]) override {
    host_.ask({which_, false, {x, static_cast<std::size_t>(cols_)}, {b, static_cast<std::size_t>(rows_)}});
    poison_overlap(x, cols_, b, rows_);
  }

 private:
  Host host_;  // a copy, since it holds only references
  int which_, rows_, cols_;
};

template <class Host>
class RemoteDynamics : public particles::Dynamics {
 public:
  RemoteDynamics(Host& host, Eigen::Index size) : host_(host), size_(size) {}

  void acceleration(particles::Input x, particles::Input v, particles::Output a) override {
    if (x.size() != size_ || v.size() != size_ || a.size() != size_)
      throw std::invalid_argument("acceleration of " + std::to_string(size_) + " numbers asked for with " +
                                  std::to_string(x.size()) + ", " + std::to_string(v.size()) + " and " +
                                  std::to_string(a.size()));
    std::vector<double> question(x.data(), x.data() + size_), answer(static_cast<std::size_t>(size_));
    question.insert(question.end(), v.data(), v.data() + size_);
    host_.ask({0, false, question, answer});
    a = Eigen::Map<const Eigen::VectorXd>(answer.data(), size_);
    poison_overlap(x.data(), size_, a.data(), size_);
    poison_overlap(v.data(), size_, a.data(), size_);
  }

 private:
  Host& host_;
  Eigen::Index size_;
};

template <class Host>
class RemoteForce : public particles::Force {
 public:
  // `provided`: the suite serves this force.
  RemoteForce(Host& host, Eigen::Index size, bool provided) : host_(host), size_(size), provided_(provided) {}
  RemoteForce(const RemoteForce&) = delete;
  RemoteForce& operator=(const RemoteForce&) = delete;

  double energy(particles::Input x) const override {
    double energy = 0;
    host_.ask({kForceEnergy, provided_, joined({&x}), {&energy, 1}});
    return energy;
  }
  void add_force(particles::Input x, particles::Input v, particles::Output f) const override {
    add(kForceForce, {&x, &v}, f);
  }
  void add_dfdx(particles::Input x, particles::Input v, particles::Input dx,
                particles::Output df) const override {
    add(kForceDfdx, {&x, &v, &dx}, df);
    poison_overlap(dx.data(), dx.size(), df.data(), df.size());
  }
  void add_dfdv(particles::Input x, particles::Input v, particles::Input dv,
                particles::Output df) const override {
    add(kForceDfdv, {&x, &v, &dv}, df);
    poison_overlap(dv.data(), dv.size(), df.data(), df.size());
  }
  bool add_band(particles::Input x, particles::Input v, double by_dfdx, double by_dfdv,
                solver::BlockBand& band, particles::Scratch /*work*/) const override {
    std::vector<double> question = joined({&x, &v}), answer(size_of_band(static_cast<int>(size_)));
    question.push_back(by_dfdx);
    question.push_back(by_dfdv);
    host_.ask({kForceBand, provided_, question, answer});
    return add_answered_band(answer, band);
  }

 private:
  using View = Eigen::Ref<const Eigen::VectorXd>;

  std::vector<double> joined(std::initializer_list<const View*> vectors) const {
    std::vector<double> all;
    all.reserve((vectors.size() + 1) * static_cast<std::size_t>(size_));
    for (const View* vector : vectors) {
      expect_size(vector->size());
      all.insert(all.end(), vector->data(), vector->data() + size_);
    }
    return all;
  }

  void add(int which, std::initializer_list<const View*> inputs, particles::Output& sum) const {
    expect_size(sum.size());
    std::vector<double> question = joined(inputs), answer(static_cast<std::size_t>(size_));
    question.insert(question.end(), sum.data(), sum.data() + size_);
    host_.ask({which, provided_, question, answer});
    sum = Eigen::Map<const Eigen::VectorXd>(answer.data(), size_);
  }

  void expect_size(Eigen::Index size) const {
    if (size != size_)
      throw std::invalid_argument("a vector of " + std::to_string(size) + " numbers for a force on " +
                                  std::to_string(size_ / 3) + " particles");
  }

  Host& host_;
  Eigen::Index size_;
  bool provided_;
};

}  // namespace grader::calls
