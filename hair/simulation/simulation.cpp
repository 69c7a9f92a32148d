#include "hair/simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "hair/simulation/simulation_parts.h"
#include "hair/strand/make_strand.h"
#include "particles/require.h"

namespace hair {

using particles::require, particles::require_at_least, particles::require_finite, particles::require_positive;

namespace {

void check_vector(std::string_view what, particles::Input values) {
  for (double value : values) require_finite(what, value);
}

void check_direction(std::string_view what, const Vector3d& direction) {
  if (std::abs(direction.norm() - 1) <= 1e-9) return;
  require(false, std::string(what) + ": its length", direction.norm(), "1");
}

void check_strand(const std::string& name, const StrandStart& start) {
  const Strand& strand = start.strand;
  const int n = strand.count();
  require_at_least(name + ": the number of particles", n, 1);
  require(strand.segments() == n - 1, name + ": the number of segments", strand.segments(),
          std::to_string(n - 1));
  require(start.state.x.size() == 3 * n, name + ": the numbers in x", start.state.x.size(),
          std::to_string(3 * n));
  require(start.state.v.size() == 3 * n, name + ": the numbers in v", start.state.v.size(),
          std::to_string(3 * n));
  for (double mass : strand.mass) require_positive(name + ": a mass", mass);
  for (double length : strand.rest_length) require_positive(name + ": a rest length", length);
  require_at_least(name + ": EA", strand.stretch_rigidity, 0);
  require_at_least(name + ": EI", strand.bend_rigidity, 0);
  require_at_least(name + ": the rigidity of springs that skip a particle", strand.skip_rigidity, 0);
  if (strand.clamped) check_direction(name + ": the root's tangent", strand.root_tangent);
  check_vector(name + ": a position", start.state.x);
  check_vector(name + ": a velocity", start.state.v);
  check_vector(name + ": a component of the rest curvature", start.rest_curvature);
}

void check(const Description& description) {
  require_positive("the step", description.step);
  require_at_least("the tolerance", description.tolerance, 0);
  require_at_least("the drag", description.drag, 0);
  check_vector("gravity", description.gravity);
  check_vector("the wind", description.wind);
  for (const Obstacle& obstacle : description.obstacles) check_obstacle(obstacle);
  for (std::size_t i = 0; i < description.strands.size(); ++i)
    check_strand("strand " + std::to_string(i), description.strands[i]);
}

constexpr double kDeepEnough =
    1e-7;  // m: what a particle that is pushed out so far does to lengths is nothing
constexpr int kMostMends = 20;

// The sum of the squares. Eight sums side by side, for one would wait for itself at each number.
double squares(const Eigen::VectorXd& values) {
  using Eight = Eigen::Array<double, 8, 1>;
  Eight sums = Eight::Zero();
  Eigen::Index i = 0;
  for (; i + 8 <= values.size(); i += 8) sums += values.segment<8>(i).array().square();
  return sums.sum() + values.tail(values.size() - i).squaredNorm();
}

// False for NaN, too. No number is larger than the norm, which is found much faster than the largest number.
bool within(const Eigen::VectorXd& values, double bound) {
  return squares(values) <= bound * bound || (values.array().abs() <= bound).all();
}

bool is_sound(const particles::State& state) {
  return within(state.x, kFarthest) && within(state.v, kFastest);
}

}  // namespace

StrandStart start_at_rest(const Material& material, const RestShape& shape) {
  StrandStart start{strand_from_rest(material, shape.x), {shape.x, Eigen::VectorXd::Zero(shape.x.size())}};
  start.strand.clamped = true;
  start.strand.root_tangent = shape.tangent;
  start.rest_curvature = bend_components(shape.x, shape.tangent, shape.normal);
  start.root_normal = shape.normal;
  return start;
}

Simulation::Simulation(Description description)
    : method_(method_of(description.method)),
      options_{description.step, description.tolerance},
      obstacles_(description.obstacles) {
  check(description);
  int most = 0;
  for (StrandStart& start : description.strands) {
    MovingStrand& moving = strands_.emplace_back(std::move(start.strand), std::move(start.state));
    add_forces(description, start, moving);
    most = std::max(most, moving.strand.count());
  }
  // An exercise that reads what it should not moves hair the same way each time all the same.
  scratch_.setZero(3 * most, method_.scratch);
  if (!obstacles_.empty()) x_before_.resize(3 * most);
}

std::optional<Stage> Simulation::step_strand(MovingStrand& moving) {
  const int size = 3 * moving.strand.count();
  if (!obstacles_.empty()) x_before_.head(size) = moving.state.x;

  const StepOutcome outcome = method_.step(moving, options_, scratch_.topRows(size));
  ++work_.strand_steps;
  work_.solver_steps += outcome.solver_steps;
  work_.correction_steps += outcome.correction_steps;
  work_.halvings += outcome.halvings;
  work_.unconverged += outcome.unconverged;
  if (!is_sound(moving.state)) return outcome.suspect;

  if (obstacles_.empty()) return {};
  collide_strand(moving);
  if (!is_sound(moving.state)) return Stage::collision;
  return {};
}

// Pushed out of obstacles, segments have other lengths, and with their lengths back particles are inside
// obstacles again, but less each time. The last word have the obstacles.
void Simulation::collide_strand(MovingStrand& moving) {
  const int size = 3 * moving.strand.count();
  CollisionReport report;
  for (int pass = 0;; ++pass) {
    report = collide(obstacles_, moving.particles, options_.h, x_before_.head(size), moving.state);
    if (pass == 0) work_.contacts += report.contacts;
    if (!method_.mend || report.deepest <= kDeepEnough || pass == kMostMends) break;
    method_.mend(moving, scratch_.topRows(size));
  }
  work_.penetration = std::max(work_.penetration, report.penetration);
}

std::optional<BlowUp> Simulation::step() {
  if (blow_up_) return blow_up_;
  ++steps_;
  for (Obstacle& obstacle : obstacles_) move_obstacle(obstacle, options_.h);
  for (int i = 0; i < strands(); ++i)
    if (const auto stage = step_strand(strands_[i]); stage && !blow_up_) blow_up_ = {i, steps_, *stage};
  return blow_up_;
}

std::optional<BlowUp> Simulation::advance(long steps) {
  for (long k = 0; k < steps; ++k)
    if (step()) break;
  return blow_up_;
}

void Simulation::restart(const Description& description) {
  require_positive("the step", description.step);
  require(static_cast<int>(description.strands.size()) == strands(),
          "the strands of a simulation that starts anew", static_cast<double>(description.strands.size()),
          std::to_string(strands()));
  require(description.obstacles.size() == obstacles_.size(), "the obstacles of a simulation that starts anew",
          static_cast<double>(description.obstacles.size()), std::to_string(obstacles_.size()));
  for (int i = 0; i < strands(); ++i) {
    const StrandStart& start = description.strands[i];
    MovingStrand& moving = strands_[i];
    require(start.state.x.size() == moving.state.x.size(), "the numbers in x of a strand that starts anew",
            static_cast<double>(start.state.x.size()), std::to_string(moving.state.x.size()));
    moving.state = start.state;
    moving.strand.root_tangent = start.strand.root_tangent;
    for (RestCurvature* rest : moving.rest_curvatures) rest->set_root_normal(start.root_normal);
  }
  options_.h = description.step;
  obstacles_ = description.obstacles;
  scratch_.setZero();
  steps_ = 0;
  work_ = {};
  blow_up_.reset();
}

void Simulation::set_root_velocity(int strand, const Vector3d& velocity) {
  check_vector("a root's velocity", velocity);
  strands_.at(strand).state.v.head<3>() = velocity;
}

void Simulation::set_root_frame(int strand, const Vector3d& tangent, const Vector3d& normal) {
  MovingStrand& moving = strands_.at(strand);
  check_direction("a root's tangent", tangent);
  check_direction("a root's normal", normal);
  require(std::abs(tangent.dot(normal)) <= 1e-6, "a root's tangent . normal", tangent.dot(normal), "0");
  moving.strand.root_tangent = tangent;
  for (RestCurvature* rest : moving.rest_curvatures) rest->set_root_normal(normal);
}

void Simulation::set_obstacle_velocity(int obstacle, const Vector3d& velocity) {
  check_vector("an obstacle's velocity", velocity);
  obstacles_.at(obstacle).velocity = velocity;
}

const char* stage_name(Stage stage) {
  switch (stage) {
    case Stage::integration:
      return "integration";
    case Stage::filter:
      return "filter";
    case Stage::correction:
      return "correction";
    case Stage::second_filter:
      return "second filter";
    case Stage::collision:
      return "collision";
  }
  return "";
}

}  // namespace hair
