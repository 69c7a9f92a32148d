#include "hair/simulation/simulation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "hair/simulation/models.h"
#include "particles/require.h"

namespace hair {

using particles::require, particles::require_at_least, particles::require_direction,
    particles::require_finite, particles::require_positive;

namespace {

void check(const Description& description) {
  require_positive("the step", description.step);
  require_at_least("the tolerance", description.tolerance, 0);
  require_at_least("the number of threads", description.jobs, 1);
  require_at_least("the drag", description.drag, 0);
  require_finite("gravity", description.gravity);
  require_finite("the wind", description.wind);
  for (const Obstacle& obstacle : description.obstacles) check_obstacle(obstacle);
  if (!description.mesh) return;
  if (!description.modelled.empty())
    throw std::invalid_argument("a control mesh links strands of masses and springs, and no others");
  if (description.method != Method::implicit_euler)
    throw std::invalid_argument("a control mesh moves by implicit_euler, and not by " +
                                std::string(row_of(description.method).id));
}

void check_frame(const Vector3d& tangent, const Vector3d& normal) {
  require_direction("a root's tangent", tangent);
  require_direction("a root's normal", normal);
  require(std::abs(tangent.dot(normal)) <= 1e-6, "a root's tangent . normal", tangent.dot(normal), "0");
}

}  // namespace

Simulation::Simulation(Description description) : step_{description.step, description.tolerance} {
  check(description);
  watched_ = description.watched;
  for (const StrandStart& start : description.strands) {
    auto body = mass_spring_strand("strand " + std::to_string(bodies_.size()), start, description);
    springs_.push_back(body.get());
    bodies_.push_back(std::move(body));
  }
  if (description.mesh) joint_ = std::make_unique<LinkedGuides>(springs_, *description.mesh, watched_);
  for (const ModelledStrand& strand : description.modelled)
    bodies_.push_back(strand.model->make(strand.spec, description));
  int rows = 0, columns = 0;
  for (const auto& body : bodies_) {
    rows = std::max(rows, body->scratch_rows());
    columns = std::max(columns, body->scratch_columns());
  }
  watch_ = Watch(strands());
  // An exercise that wrongly reads its scratch memory still moves hair the same way in each run.
  own_.resize(description.jobs);
  for (Thread& own : own_) own.scratch.setZero(rows, columns);
  broke_.resize(bodies_.size());
  left_out_.resize(bodies_.size());
  threads_ = std::make_unique<StrandThreads>(description.jobs);
  obstacles_ = std::move(description.obstacles);
}

std::optional<BlowUp> Simulation::step() {
  if (blow_up_) return blow_up_;
  ++steps_;
  for (Obstacle& obstacle : obstacles_) move_obstacle(obstacle, step_.h);
  const BodyStep step{step_.h, step_.tolerance, obstacles_};
  const auto step_strand = [&](int thread, int i) {
    if (left_out_[i]) return;
    Body& body = *bodies_[i];
    Thread& own = own_[thread];
    broke_[i] = body.step(step, own.scratch.topRows(body.scratch_rows()), own.work);
  };
  if (joint_)
    joint_->step(step, broke_, own_.front().work);
  else
    threads_->run(strands(), std::ref(step_strand));
  work_ = {};
  for (const Thread& own : own_) work_ += own.work;
  for (int i = 0; i < strands(); ++i) {
    if (broke_[i] && !blow_up_) blow_up_ = {i, steps_, *broke_[i]};
    if (broke_[i] || !watched_ || left_out_[i]) continue;
    Sizes sizes = bodies_[i]->sizes();
    if (joint_) {
      sizes[Concern::passes] = joint_->passes(i);
      sizes[Concern::energy] = joint_->gain();
      sizes[Concern::contact_energy] = joint_->contact_gain();
      sizes[Concern::loss] = joint_->loss();
    }
    watch_.see(i, steps_, sizes);
  }
  return blow_up_;
}

void Simulation::leave_out(std::span<const int> strands) {
  if (joint_ && !strands.empty())
    throw std::invalid_argument(
        "strands of a control mesh are to be left out; each of them moves the others");
  for (const int strand : strands) left_out_.at(static_cast<std::size_t>(strand)) = 1;
}

std::optional<BlowUp> Simulation::advance(long steps) {
  for (long k = 0; k < steps; ++k)
    if (step()) break;
  return blow_up_;
}

void Simulation::restart(const Description& description) {
  require_positive("the step", description.step);
  const std::size_t count = description.strands.size() + description.modelled.size();
  require(count == bodies_.size() && description.strands.size() == springs_.size(),
          "the strands of a simulation that starts anew", static_cast<double>(count),
          std::to_string(strands()));
  require(description.obstacles.size() == obstacles_.size(), "the obstacles of a simulation that starts anew",
          static_cast<double>(description.obstacles.size()), std::to_string(obstacles_.size()));
  for (std::size_t i = 0; i < springs_.size(); ++i) {
    const StrandStart& start = description.strands[i];
    require(start.state.x.size() == springs_[i]->size(), "the numbers in x of a strand that starts anew",
            static_cast<double>(start.state.x.size()), std::to_string(springs_[i]->size()));
    springs_[i]->restart(start);
  }
  if (joint_) joint_->restart();
  for (std::size_t i = 0; i < description.modelled.size(); ++i) {
    const ModelledStrand& strand = description.modelled[i];
    bodies_[springs_.size() + i] = strand.model->make(strand.spec, description);
  }
  step_.h = description.step;
  obstacles_ = description.obstacles;
  for (Thread& own : own_) {
    own.scratch.setZero();
    own.work = {};
  }
  steps_ = 0;
  work_ = {};
  watch_ = Watch(strands());
  blow_up_.reset();
}

void Simulation::set_root(int strand, const Root& root) {
  require_finite("a root's position", root.position);
  require_finite("a root's velocity", root.velocity);
  require_finite("a root's angular velocity", root.angular_velocity);
  check_frame(root.tangent, root.normal);
  bodies_.at(strand)->set_root(root);
}

void Simulation::set_root_velocity(int strand, const Vector3d& velocity) {
  require_finite("a root's velocity", velocity);
  springs_.at(strand)->set_root_velocity(velocity);
}

void Simulation::set_root_frame(int strand, const Vector3d& tangent, const Vector3d& normal) {
  check_frame(tangent, normal);
  springs_.at(strand)->set_root_frame(tangent, normal);
}

void Simulation::set_obstacle_velocity(int obstacle, const Vector3d& velocity) {
  require_finite("an obstacle's velocity", velocity);
  obstacles_.at(obstacle).velocity = velocity;
}

void Simulation::set_obstacle_spin(int obstacle, const Vector3d& angular_velocity) {
  require_finite("an obstacle's angular velocity", angular_velocity);
  auto* const placed = std::get_if<PlacedSolid>(&obstacles_.at(obstacle).shape);
  if (!placed) throw std::invalid_argument("an obstacle that is no placed solid is to turn; only those do");
  placed->angular_velocity = angular_velocity;
}

}  // namespace hair
