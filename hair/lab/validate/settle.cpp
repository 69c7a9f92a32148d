#include "hair/lab/validate/settle.h"

#include <cmath>
#include <limits>

#include "hair/lab/validate/clamped_hair.h"
#include "solver/timing.h"

namespace hair {

Settled settle(const StrandStart& start, const Material& material, Method method, double slowest, double step,
               const ValidationSettings& settings) {
  Settled result{Eigen::VectorXd::Constant(start.state.x.size(), std::numeric_limits<double>::quiet_NaN())};
  if (!std::isfinite(slowest)) return result;
  Description description;
  description.strands = {start};
  description.method = method;
  description.step = step;
  description.gravity = Vector3d(0, 0, -kEarthGravity);
  description.drag = 2 * slowest * material.line_density();
  Simulation simulation(std::move(description));
  const particles::State& state = simulation.state(0);
  const double before = timing::cpu_seconds();
  while (simulation.time() < 60 / slowest) {
    settings.go_on();
    if (simulation.step()) return result;
  }
  result.cpu_seconds = timing::cpu_seconds() - before;
  result.x = state.x;
  result.speed = state.v.cwiseAbs().maxCoeff();
  return result;
}

}  // namespace hair
