// STAFF ONLY. P1, asked of the student's worker: the request of grader/worker/serve_P1.cpp, for one step. The
// accelerations are computed here.
#include <limits>

#include "grader/exercise/dynamics_server.h"
#include "grader/play/asking.h"
#include "particles/explicit_integrators.h"

namespace particles {
namespace {

void step(int method, Dynamics& dynamics, double h, Output& x, Output& v) {
  const int size = static_cast<int>(x.size()), n = size / 3;
  grader::MessageWriter request;
  // Scratch memory holds anything on entry.
  const double junk = std::numeric_limits<double>::quiet_NaN();
  request.put(method).put(n).put(h).put(1).put(kIntegratorScratch).put(junk);
  for (const Output* vector : {&x, &v})
    request.put(std::span<const double>(vector->data(), static_cast<std::size_t>(size)));
  // No limit: the submission's budget is one.
  grader::DynamicsServer server(dynamics, n, std::numeric_limits<int>::max());
  grader::MessageReader reply = grader::ask_student(request, std::ref(server));
  const std::vector<double> after = reply.get_doubles(2 * static_cast<std::size_t>(size));
  reply.expect_end();
  x = Eigen::Map<const Eigen::VectorXd>(after.data(), size);
  v = Eigen::Map<const Eigen::VectorXd>(after.data() + size, size);
}

}  // namespace

void forward_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch) {
  step(0, dynamics, h, x, v);
}

void symplectic_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch) {
  step(1, dynamics, h, x, v);
}

void midpoint(Dynamics& dynamics, double h, Output x, Output v, Scratch) {
  step(2, dynamics, h, x, v);
}

void runge_kutta_4(Dynamics& dynamics, double h, Output x, Output v, Scratch) {
  step(3, dynamics, h, x, v);
}

}  // namespace particles
