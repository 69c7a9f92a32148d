#include "hair/runs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "hair/make_strand.h"
#include "hair/measures.h"
#include "hair/rest_shape.h"
#include "hair/simulation.h"
#include "particles/constraint_forces.h"
#include "particles/explicit_integrators.h"
#include "particles/gravity.h"
#include "particles/springs.h"
#include "particles/system.h"

namespace hair {

namespace {

using particles::Particles;
using particles::State;

constexpr int kFrames = 12;  // after the first
constexpr double kStep = 1.0 / 240;

bool is_finite(const Frame& frame) {
  return frame.state.x.allFinite() && frame.state.v.allFinite() && std::isfinite(frame.stretch) &&
         std::isfinite(frame.energy);
}

// --- Strands ---

// Where a strand of rest shape `shape` starts.
StrandStart start_at(const Material& material, const Eigen::VectorXd& rest, const Eigen::VectorXd& x) {
  return {strand_from_rest(material, rest), {x, Eigen::VectorXd::Zero(x.size())}};
}

// A straight hair along `direction`, from `root`.
StrandStart straight_hair(int segments, double length, const Vector3d& root, const Vector3d& direction) {
  const RootFrame frame{root, direction, direction.unitOrthogonal()};
  const Eigen::VectorXd x = straight_shape(segments, length, frame).x;
  return start_at({}, x, x);
}

Frame frame_of(const Simulation& simulation) {
  Frame frame{simulation.time(), {}, 0, 0};
  int size = 0;
  for (int i = 0; i < simulation.strands(); ++i) size += 3 * simulation.strand(i).count();
  frame.state.x.resize(size);
  frame.state.v.resize(size);
  int at = 0;
  for (int i = 0; i < simulation.strands(); ++i) {
    const State& state = simulation.state(i);
    frame.state.x.segment(at, state.x.size()) = state.x;
    frame.state.v.segment(at, state.v.size()) = state.v;
    at += static_cast<int>(state.x.size());
    const Measures measures =
        measure(simulation.strand(i), simulation.particles(i), simulation.force(i), state);
    frame.stretch = std::max(frame.stretch, measures.stretch);
    frame.energy += measures.energy();
  }
  return frame;
}

RunResult simulate(Description description, int steps_per_frame) {
  Simulation simulation(std::move(description));
  RunResult result{{frame_of(simulation)}, ""};
  for (int k = 0; k < kFrames; ++k) {
    if (const auto blow_up = simulation.advance(steps_per_frame)) {
      result.trouble = "strand " + std::to_string(blow_up->strand) + ", step " +
                       std::to_string(blow_up->step) + ": " + stage_name(blow_up->stage);
      break;
    }
    result.frames.push_back(frame_of(simulation));
  }
  return result;
}

// H6: a hair that starts level, and swings down.
Description strand_swing() {
  Description description;
  description.step = kStep;
  description.strands.push_back(straight_hair(10, 0.1, Vector3d::Zero(), Vector3d::UnitX()));
  return description;
}

// H4: ten times as stiff, clamped, with a root that is pulled aside.
Description stiff_swing() {
  Description description;
  description.method = Method::implicit_euler;
  description.step = kStep;
  StrandStart start = straight_hair(10, 0.1, Vector3d::Zero(), -Vector3d::UnitZ());
  start.strand.stretch_rigidity *= 10;
  start.strand.clamped = true;
  start.state.v.head<3>() = Vector3d(0.5, 0, 0);
  description.strands.push_back(std::move(start));
  return description;
}

// H6 with a collision stage: hair falls over a head.
Description strand_over_sphere() {
  Description description;
  description.step = kStep;
  for (const double y : {-0.01, 0.02})
    description.strands.push_back(straight_hair(10, 0.12, Vector3d(-0.04, y, 0.07), Vector3d::UnitX()));
  description.obstacles.push_back({Sphere{Vector3d(0, 0, 0), 0.06}, 0.3});
  return description;
}

// H4 with a rest curvature: a soft curl sags, and lags behind its root.
Description curly_hair() {
  Description description;
  description.method = Method::implicit_euler;
  description.step = kStep;
  const Material soft{.young_modulus = 1e8};
  StrandStart start = start_at_rest(soft, curly_shape(9, 0.06, 0.006, 0.015, RootFrame{}));
  start.state.v.head<3>() = Vector3d(0, 0.3, 0);
  description.strands.push_back(std::move(start));
  return description;
}

// H3: springs that skip a particle hold a hair up a little.
Description skip_springs() {
  Description description;
  description.method = Method::implicit_euler;
  description.step = kStep;
  StrandStart start = straight_hair(8, 0.08, Vector3d::Zero(), Vector3d::UnitX());
  start.strand.bend_rigidity = 0;
  start.strand.skip_rigidity = 0.2 * start.strand.stretch_rigidity;
  description.strands.push_back(std::move(start));
  return description;
}

// --- Particles ---

// Takes steps, and a frame before them and after every `steps_per_frame`; ends early before one that is not finite.
RunResult record(int steps_per_frame, const std::function<Frame(int step)>& frame,
                 const std::function<void()>& take_step) {
  RunResult result{{frame(0)}, ""};
  for (int step = 1; step <= kFrames * steps_per_frame; ++step) {
    take_step();
    if (step % steps_per_frame != 0) continue;
    Frame next = frame(step);
    if (!is_finite(next)) {
      result.trouble = "step " + std::to_string(step) + ": not finite";
      break;
    }
    result.frames.push_back(std::move(next));
  }
  return result;
}

// P1: the same double pendulum of springs four times, side by side, each with its own integrator.
RunResult pendulums() {
  constexpr int kEach = 3, kSteps = 40;
  constexpr double kLength = 0.5, kPendulumStep = 1e-3;
  using Integrator =
      void (*)(particles::Dynamics&, double, particles::Output, particles::Output, particles::Scratch);
  const Integrator integrators[] = {particles::forward_euler, particles::symplectic_euler,
                                    particles::midpoint, particles::runge_kutta_4};
  const int copies = static_cast<int>(std::size(integrators)), size = 3 * kEach;

  const Particles pendulum{Eigen::Vector3d(1, 0.3, 0.2), {1, 0, 0}};
  particles::ForceSum force;
  force.emplace<particles::Gravity>(pendulum.mass, Vector3d(0, 0, -9.81));
  force.emplace<particles::DampedSprings>(
      std::vector<particles::Spring>{{0, 1, 400, kLength, 0.1}, {1, 2, 300, kLength, 0.1}});
  particles::ParticleSystem system(pendulum, force);

  State all{Eigen::VectorXd(copies * size), Eigen::VectorXd::Zero(copies * size)};
  for (int c = 0; c < copies; ++c)
    for (int i = 0; i < kEach; ++i)
      all.x.segment<3>(c * size + 3 * i) =
          kLength * Vector3d(i == 0 ? 0 : 0.8, 0.4 * c, -0.8 * i + (i == 0 ? 0 : 0.2));
  Eigen::MatrixXd scratch(size, particles::kIntegratorScratch);

  auto frame = [&](int step) {
    Frame result{step * kPendulumStep, all, 0, 0};
    for (int c = 0; c < copies; ++c) {
      const Eigen::VectorXd x = all.x.segment(c * size, size), v = all.v.segment(c * size, size);
      for (int i = 0; i + 1 < kEach; ++i)
        result.stretch = std::max(
            result.stretch, std::abs((x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm() / kLength - 1));
      result.energy += force.energy(x) + particles::kinetic_energy(pendulum, v);
    }
    return result;
  };
  return record(kSteps, frame, [&] {
    for (int c = 0; c < copies; ++c)
      integrators[c](system, kPendulumStep, all.x.segment(c * size, size), all.v.segment(c * size, size),
                     scratch);
  });
}

// What P2's constraints leave of gravity.
class Constrained : public particles::Dynamics {
 public:
  Constrained(const Particles& particles, const particles::Constraints& constraints,
              const particles::Force& force)
      : particles_(particles),
        constraints_(constraints),
        force_(force),
        state_{Eigen::VectorXd(3 * particles.count()), Eigen::VectorXd(3 * particles.count())},
        lambda_(constraints.rows()) {}

  void acceleration(particles::Input x, particles::Input v, particles::Output a) override {
    state_.x = x;
    state_.v = v;
    a.setZero();
    force_.add_force(x, v, a);
    particles::solve_constraints(constraints_, particles_, state_, a, lambda_);
    particles::add_constraint_forces(constraints_, x, lambda_, a);
    for (int i = 0; i < particles_.count(); ++i) a.segment<3>(3 * i) /= particles_.mass[i];
  }

 private:
  const Particles& particles_;
  const particles::Constraints& constraints_;
  const particles::Force& force_;
  State state_;
  Eigen::VectorXd lambda_;
};

// P2: a bead on a wire, from which two rods hang.
RunResult bead_on_wire() {
  constexpr int kSteps = 20;
  constexpr double kBeadStep = 2e-3, kRod = 0.4;
  const Particles bead{Eigen::Vector3d(0.5, 0.2, 0.1), {0, 0, 0}};
  particles::Constraints constraints;
  constraints.rods = {{0, 1, kRod}, {1, 2, kRod}};
  constraints.wires = {{0, Vector3d::Zero(), Vector3d(0, 1, 0), 1}};
  constraints.stiffness = 400;
  constraints.damping = 40;
  const particles::Gravity gravity(bead.mass, Vector3d(0, 0, -9.81));
  Constrained dynamics(bead, constraints, gravity);

  State state{Eigen::VectorXd(9), Eigen::VectorXd::Zero(9)};
  state.x << 0.8, 0, -0.6, 0.8 + kRod, 0, -0.6, 0.8 + kRod, kRod, -0.6;
  Eigen::MatrixXd scratch(9, particles::kIntegratorScratch);

  auto frame = [&](int step) {
    Frame result{step * kBeadStep, state, 0, 0};
    for (const particles::Rod& rod : constraints.rods) {
      const double length = (state.x.segment<3>(3 * rod.i) - state.x.segment<3>(3 * rod.j)).norm();
      result.stretch = std::max(result.stretch, std::abs(length / rod.length - 1));
    }
    result.energy = gravity.energy(state.x) + particles::kinetic_energy(bead, state.v);
    return result;
  };
  return record(kSteps, frame,
                [&] { particles::runge_kutta_4(dynamics, kBeadStep, state.x, state.v, scratch); });
}

struct Entry {
  Run run;
  std::function<RunResult()> work;
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all = {
      {{"pendulums", "one double pendulum, four integrators", {"P1"}, {3, 3, 3, 3}}, pendulums},
      {{"bead-on-wire", "a bead on a wire, and two rods", {"S1", "P1", "P2"}, {3}}, bead_on_wire},
      {{"stiff-swing", "a stiff hair, its root pulled aside", {"S1", "H1", "H2", "H4"}, {11}},
       [] { return simulate(stiff_swing(), 2); }},
      {{"skip-springs", "a hair with springs that skip a particle", {"S1", "H1", "H3", "H4"}, {9}},
       [] { return simulate(skip_springs(), 2); }},
      {{"strand-swing", "a hair swings down", {"S1", "H1", "H2", "H4", "H5", "H6"}, {11}},
       [] { return simulate(strand_swing(), 4); }},
      {{"curly-hair", "a curl sags under its weight", {"S1", "H1", "H4"}, {10}},
       [] { return simulate(curly_hair(), 3); }},
      {{"strand-over-sphere", "two hairs fall over a head", {"S1", "H1", "H2", "H4", "H5", "H6"}, {11, 11}},
       [] { return simulate(strand_over_sphere(), 3); }},
  };
  return all;
}

}  // namespace

const std::vector<Run>& runs() {
  static const std::vector<Run> list = [] {
    std::vector<Run> all;
    for (const Entry& entry : entries()) all.push_back(entry.run);
    return all;
  }();
  return list;
}

RunResult do_run(const std::string& name) {
  for (const Entry& entry : entries())
    if (entry.run.name == name) return entry.work();
  throw std::invalid_argument("no run has the name " + name);
}

}  // namespace hair
