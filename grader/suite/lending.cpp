// STAFF ONLY.
#include "grader/suite/lending.h"

#include <algorithm>

#include "grader/wire/force_answer.h"
#include "grader/wire/lent_functions.h"
#include "grader/wire/particles_message.h"
#include "grader/wire/report_message.h"
#include "grader/wire/strand_message.h"

namespace grader {
namespace {

// Segments times sweeps: the most that a call may compute, 0.1 s or so. Hair takes a hundredth of it.
constexpr int kMostWork = 5'000'000;

// An operator of the other side's, asked through `products`.
std::vector<double> ask(const Products& products, int which, const std::vector<double>& question,
                        std::size_t expected) {
  std::vector<double> answer;
  if (!products(which, question, answer)) throw StoppedLoan();
  if (answer.size() != expected) throw MalformedMessage("a product of another length");
  return answer;
}

class AskedMatrix : public implicitMatrix {
 public:
  AskedMatrix(const Products& products, std::size_t n) : products_(products), n_(n) {}

  void matVecMult(double x[], double b[]) override {
    const std::vector<double> product = ask(products_, kLentMatrix, {x, x + n_}, n_);
    std::copy(product.begin(), product.end(), b);
  }

 private:
  const Products& products_;
  std::size_t n_;
};

class AskedForce : public particles::Force {
 public:
  explicit AskedForce(const Products& products) : products_(products) {}

  double energy(particles::Input x) const override {
    return ask(products_, kForceEnergy, joined({&x}), 1)[0];
  }
  void add_force(particles::Input x, particles::Input v, particles::Output f) const override {
    add(kForceForce, {&x, &v}, f);
  }
  void add_dfdx(particles::Input x, particles::Input v, particles::Input dx,
                particles::Output df) const override {
    add(kForceDfdx, {&x, &v, &dx}, df);
  }
  void add_dfdv(particles::Input x, particles::Input v, particles::Input dv,
                particles::Output df) const override {
    add(kForceDfdv, {&x, &v, &dv}, df);
  }
  bool add_band(particles::Input x, particles::Input v, double by_dfdx, double by_dfdv,
                solver::BlockBand& band, particles::Scratch /*work*/) const override {
    std::vector<double> question = joined({&x, &v});
    question.push_back(by_dfdx);
    question.push_back(by_dfdv);
    std::vector<double> answer =
        ask(products_, kForceBand, question, size_of_band(static_cast<int>(x.size())));
    return add_answered_band(answer, band);
  }

 private:
  using View = Eigen::Ref<const Eigen::VectorXd>;

  static std::vector<double> joined(std::initializer_list<const View*> vectors) {
    std::vector<double> all;
    for (const View* vector : vectors) all.insert(all.end(), vector->data(), vector->data() + vector->size());
    return all;
  }

  void add(int which, std::initializer_list<const View*> inputs, particles::Output& sum) const {
    std::vector<double> question = joined(inputs);
    question.insert(question.end(), sum.data(), sum.data() + sum.size());
    const std::vector<double> answer = ask(products_, which, question, static_cast<std::size_t>(sum.size()));
    sum = Eigen::Map<const Eigen::VectorXd>(answer.data(), sum.size());
  }

  const Products& products_;
};

MessageWriter conj_grad(MessageReader& call, const Products& callback, std::vector<LentSolve>& solves) {
  const int n = call.get<int>();
  const double epsilon = call.get<double>();
  int steps = call.get<int>();
  if (n < 0) throw MalformedMessage("a system of " + std::to_string(n) + " unknowns");
  std::vector<double> b = call.get_doubles(static_cast<std::size_t>(n)), x(b.size());
  call.expect_end();
  AskedMatrix A(callback, b.size());
  const int most = steps;
  const double value = ConjGrad(n, &A, x.data(), b.data(), epsilon, &steps);
  solves.push_back({most, epsilon, value});
  MessageWriter result;
  return result.put(value).put(steps).put(std::span<const double>(x));
}

MessageWriter implicit(int function, MessageReader& call, const Products& held, const Products& callback) {
  const AskedForce force(call.get<std::uint8_t>() != 0 ? held : callback);
  const particles::Particles particles = get_particles(call);
  particles::State state = get_state(call, particles.count());
  const Eigen::Index size = state.x.size();
  const double first = call.get<double>(), second = call.get<double>();
  Eigen::MatrixXd scratch(size, particles::kImplicitScratch);
  MessageWriter result;
  if (function == kLentImplicitProduct) {
    Eigen::VectorXd x = get_vector(call, size), product(size);
    call.expect_end();
    particles::implicit_matrix(force, particles, state, first, second)->matVecMult(x.data(), product.data());
    put(result, product);
  } else if (function == kLentSolveImplicit) {
    const double tolerance = call.get<double>();
    call.expect_end();
    Eigen::VectorXd dv(size);
    const particles::SolveReport report =
        particles::solve_implicit(force, particles, state, first, second, tolerance, dv, scratch);
    put(result, dv);
    put(result, report);
  } else {
    call.expect_end();
    const particles::SolveReport report =
        particles::implicit_euler(force, particles, first, second, state, scratch);
    put(result, state);
    put(result, report);
  }
  return result;
}

MessageWriter lengths(int function, MessageReader& call) {
  const hair::Strand strand = get_strand(call);
  const double tolerance = call.get<double>();
  const int most = std::clamp(call.get<int>(), 0, kMostWork / strand.count());
  const Eigen::Index size = Eigen::Index{3} * strand.count();
  Eigen::VectorXd x = get_vector(call, size), v;
  if (function == kLentCorrectVelocities) v = get_vector(call, size);
  call.expect_end();
  Eigen::MatrixXd scratch(size, hair::kCorrectionScratch);
  hair::CorrectionReport report;
  if (function == kLentRelaxLengths)
    report = hair::relax_lengths(strand, tolerance, most, x);
  else if (function == kLentCorrectLengths)
    report = hair::correct_lengths(strand, tolerance, most, x, scratch);
  else
    report = hair::correct_velocities(strand, x, tolerance, most, v, scratch);
  MessageWriter result;
  put(result, function == kLentCorrectVelocities ? v : x);
  put(result, report);
  return result;
}

}  // namespace

MessageWriter lend(const std::vector<std::string>& lent, MessageReader call, const Products& held,
                   const Products& callback, std::vector<LentSolve>& solves) {
  const int function = call.get<int>();
  const auto may_call = [&](const char* exercise) {
    if (std::find(lent.begin(), lent.end(), exercise) == lent.end())
      throw MalformedMessage(std::string("a function of ") + exercise + ", which is not lent");
  };
  switch (function) {
    case kLentConjGrad:
      may_call("S1");
      return conj_grad(call, callback, solves);
    case kLentImplicitProduct:
    case kLentSolveImplicit:
    case kLentImplicitEuler:
      may_call("H4");
      return implicit(function, call, held, callback);
    case kLentRelaxLengths:
    case kLentCorrectLengths:
    case kLentCorrectVelocities:
      may_call("H5");
      return lengths(function, call);
    default:
      throw MalformedMessage("a function that is not lent");
  }
}

}  // namespace grader
