// STAFF ONLY. P2, asked of the student's worker: the requests of grader/worker/serve_P2.cpp.
#include "grader/play/asking.h"
#include "grader/wire/constraints_message.h"
#include "grader/wire/particles_message.h"
#include "grader/wire/report_message.h"
#include "grader/wire/strand_message.h"
#include "particles/constraint_forces.h"

namespace particles {
namespace {

constexpr int kValues = 0, kRates = 1, kForces = 2, kMatrix = 3, kSolveRods = 4;

// Functions that take less than the whole state get zeros for the rest.
grader::MessageWriter request_of(int function, const Constraints& constraints, const Particles& particles,
                                 const Eigen::VectorXd& x, const Eigen::VectorXd& v) {
  grader::MessageWriter request;
  request.put(function);
  grader::put(request, constraints);
  grader::put(request, particles);
  grader::put(request, x);
  grader::put(request, v);
  return request;
}

Particles any_particles(Eigen::Index size) {
  return {Eigen::VectorXd::Ones(size / 3), std::vector<char>(static_cast<std::size_t>(size / 3), 0)};
}

// Asks for what overwrites or adds to `result`, which is the last of the request.
void ask_for(grader::MessageWriter& request, Output& result) {
  grader::put(request, result);
  grader::MessageReader reply = grader::ask_student(request);
  result = grader::get_vector(reply, result.size());
  reply.expect_end();
}

class AskedProducts : public implicitMatrix {
 public:
  AskedProducts(const Constraints& constraints, const Particles& particles, const State& state)
      : constraints_(constraints), particles_(particles), state_(state) {}

  void matVecMult(double x[], double b[]) override {
    const Eigen::Index rows = constraints_.rows();
    Eigen::Map<Eigen::VectorXd> input(x, rows), product(b, rows);
    grader::MessageWriter request = request_of(kMatrix, constraints_, particles_, state_.x, state_.v);
    grader::put(request, input);
    grader::put(request, Eigen::VectorXd::Zero(rows));
    grader::MessageReader reply = grader::ask_student(request);
    product = grader::get_vector(reply, rows);
    input = grader::get_vector(reply, rows);
    grader::get_vector(reply, rows);
    reply.expect_end();
  }

 private:
  const Constraints& constraints_;
  const Particles& particles_;
  const State& state_;
};

}  // namespace

void constraint_values(const Constraints& constraints, Input x, Output C) {
  auto request =
      request_of(kValues, constraints, any_particles(x.size()), x, Eigen::VectorXd::Zero(x.size()));
  ask_for(request, C);
}

void constraint_rates(const Constraints& constraints, Input x, Input v, Output rates) {
  auto request = request_of(kRates, constraints, any_particles(x.size()), x, v);
  ask_for(request, rates);
}

void add_constraint_forces(const Constraints& constraints, Input x, Input lambda, Output f) {
  auto request =
      request_of(kForces, constraints, any_particles(x.size()), x, Eigen::VectorXd::Zero(x.size()));
  grader::put(request, Eigen::VectorXd(lambda));
  ask_for(request, f);
}

std::unique_ptr<implicitMatrix> constraint_matrix(const Constraints& constraints, const Particles& particles,
                                                  const State& state) {
  return std::make_unique<AskedProducts>(constraints, particles, state);
}

ConstraintReport solve_constraints(const Constraints& constraints, const Particles& particles,
                                   const State& state, Input f, Output lambda) {
  grader::MessageWriter request = request_of(kSolveRods, constraints, particles, state.x, state.v);
  grader::put(request, Eigen::VectorXd(f));
  grader::put(request, lambda);
  grader::MessageReader reply = grader::ask_student(request);
  ConstraintReport report{};
  report.steps = grader::get_steps(reply);
  report.residual = reply.get<double>();
  lambda = grader::get_vector(reply, lambda.size());
  reply.expect_end();
  return report;
}

}  // namespace particles
