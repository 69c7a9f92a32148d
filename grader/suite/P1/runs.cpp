// STAFF ONLY.
#include "grader/suite/P1/runs.h"

#include <functional>
#include <span>
#include <sstream>

#include "grader/exercise/dynamics_server.h"

namespace grader::p1 {
namespace {

using Eigen::Map;
using Eigen::VectorXd;

VectorXd vector_of(const std::vector<double>& values) {
  return Map<const VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

}  // namespace

const Method kMethods[4] = {{0, "forward_euler", 1, 1, particles::forward_euler},
                            {1, "symplectic_euler", 1, 1, particles::symplectic_euler},
                            {2, "midpoint", 2, 2, particles::midpoint},
                            {3, "runge_kutta_4", 4, 4, particles::runge_kutta_4}};

State random_state(Random& random, int n) {
  return {vector_of(random.normals(3 * n)), vector_of(random.normals(3 * n))};
}

Run run(Trial& trial, const Method& method, particles::Dynamics& dynamics, const State& start,
        const Setting& setting) {
  const int size = static_cast<int>(start.x.size()), n = size / 3;
  std::ostringstream text;
  text << method.name << ", n = " << n << ", h = " << setting.h << ", " << setting.steps
       << " steps, scratch of " << setting.columns << " columns with " << setting.junk;
  trial.describe(text.str());

  MessageWriter request;
  request.put(method.number).put(n).put(setting.h).put(setting.steps).put(setting.columns).put(setting.junk);
  for (const VectorXd* vector : {&start.x, &start.v})
    request.put(std::span<const double>(vector->data(), vector->size()));
  // Ten times what is needed, so that it is a category of its own that counts.
  DynamicsServer server(dynamics, n, 10 * method.evaluations * setting.steps);
  MessageReader reply =
      trial.ask(request, std::ref(server), "evaluates the acceleration far more often than it should");
  const std::vector<double> numbers =
      reply.get_doubles(2 * static_cast<std::size_t>(size) * static_cast<std::size_t>(setting.steps));
  Run result;
  reply.expect_end();
  result.evaluations = server.evaluations;
  for (int step = 0; step < setting.steps; ++step) {
    const double* at = numbers.data() + std::ptrdiff_t{2} * size * step;
    result.states.push_back({Map<const VectorXd>(at, size), Map<const VectorXd>(at + size, size)});
  }
  return result;
}

void expect_moves(Trial& trial, const Method& method, const State& start, double h, const State& end) {
  trial.expect((end.x - start.x - h * start.v).norm() <= 0.5 * (h * start.v).norm() && end.v != start.v,
               std::string(method.name) + " does not move the particles");
}

}  // namespace grader::p1
