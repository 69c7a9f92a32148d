// STAFF ONLY. H4, asked of the student's worker: the requests of grader/worker/serve_H4.cpp. The forces stay here.
#include <limits>

#include "grader/play/asking.h"
#include "grader/play/force_server.h"
#include "grader/wire/particles_message.h"
#include "grader/wire/report_message.h"
#include "grader/wire/strand_message.h"
#include "particles/implicit_euler.h"

namespace particles {
namespace {

constexpr int kProduct = 0, kSolve = 1, kEuler = 2;
constexpr int kNoLimit = std::numeric_limits<int>::max();  // player.cpp has one

grader::MessageWriter request_of(int function, const Particles& particles, const State& state) {
  grader::MessageWriter request;
  request.put(function);
  grader::put(request, particles);
  grader::put(request, state);
  return request;
}

grader::MessageReader ask(const grader::MessageWriter& request, const Force& force, int n) {
  grader::ForceServer server(force, n, kNoLimit);
  return grader::ask_student(request, std::ref(server));
}

class AskedMatrix : public implicitMatrix {
 public:
  AskedMatrix(const Force& force, const Particles& particles, const State& state, double a, double b)
      : force_(force), particles_(particles), state_(state), a_(a), b_(b) {}

  void matVecMult(double x[], double b[]) override {
    const Eigen::Index size = state_.x.size();
    Eigen::Map<Eigen::VectorXd> input(x, size), product(b, size);
    grader::MessageWriter request = request_of(kProduct, particles_, state_);
    request.put(a_).put(b_);
    grader::put(request, input);
    grader::put(request, Eigen::VectorXd::Zero(size));
    grader::MessageReader reply = ask(request, force_, particles_.count());
    product = grader::get_vector(reply, size);
    input = grader::get_vector(reply, size);
    grader::get_vector(reply, size);
    if (grader::overlapped(reply)) product.setConstant(grader::kNoNumber);
  }

 private:
  const Force& force_;
  const Particles& particles_;
  const State& state_;
  double a_, b_;
};

}  // namespace

std::unique_ptr<implicitMatrix> implicit_matrix(const Force& force, const Particles& particles,
                                                const State& state, double a, double b) {
  return std::make_unique<AskedMatrix>(force, particles, state, a, b);
}

SolveReport solve_implicit(const Force& force, const Particles& particles, const State& state, double a,
                           double b, double tolerance, Output dv, Scratch) {
  grader::MessageWriter request = request_of(kSolve, particles, state);
  request.put(a).put(b).put(tolerance);
  grader::put(request, dv);
  grader::MessageReader reply = ask(request, force, particles.count());
  dv = grader::get_vector(reply, dv.size());
  const SolveReport report = grader::get_solve_report(reply);
  if (grader::overlapped(reply)) dv.setConstant(grader::kNoNumber);
  return report;
}

SolveReport implicit_euler(const Force& force, const Particles& particles, double h, double tolerance,
                           State& state, Scratch) {
  grader::MessageWriter request = request_of(kEuler, particles, state);
  request.put(h).put(tolerance);
  grader::MessageReader reply = ask(request, force, particles.count());
  state = grader::get_state(reply, particles.count());
  const SolveReport report = grader::get_solve_report(reply);
  if (grader::overlapped(reply)) state.v.setConstant(grader::kNoNumber);
  return report;
}

}  // namespace particles
