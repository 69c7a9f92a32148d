// STAFF ONLY. P2's figure: the forces that hold a rod and a wire, and the error with and without feedback.
#include "particles/constraint_forces.h"
#include "particles/implicit_euler.h"
#include "particles/toys/moving_toy.h"
#include "reference/figures/drawing.h"

namespace figures {

namespace {

using Eigen::Vector3d;

// Draws weight, velocity and constraint force of a particle of 1 kg, and names them.
void draw_forces(Drawing& drawing, const View& view, const particles::Constraints& constraints,
                 const particles::State& state, const Spot& name_at) {
  const int last = static_cast<int>(state.x.size()) - 3;
  particles::Particles particles{Eigen::VectorXd::Ones(last / 3 + 1), std::vector<char>(last / 3 + 1, 0)};
  if (last > 0) particles.pinned[0] = 1;
  Eigen::VectorXd f = Eigen::VectorXd::Zero(last + 3), force = f, lambda(constraints.rows());
  f[last + 1] = -particles::kEarthGravity;
  particles::solve_constraints(constraints, particles, state, f, lambda);
  particles::add_constraint_forces(constraints, state.x, lambda, force);
  const double per_newton = 8 / view.unit, per_speed = 45 / view.unit;  // m
  const Vector3d at = state.x.tail<3>(), pull = per_newton * force.tail<3>();
  drawing.arrow(view(at), view(at + per_newton * f.tail<3>()), {kMiddle, 3});
  drawing.words(view(at + per_newton * f.tail<3>()) + Spot(0, 20), "*m g*", {kQuiet});
  drawing.arrow(view(at), view(at + per_speed * state.v.tail<3>()), {colour(0), 2, "6 4"});
  drawing.words(view(at + per_speed * state.v.tail<3>()) + Spot(10, -4), "*v*", {colour(0), "start"});
  drawing.arrow(view(at), view(at + pull), {colour(1), 4});
  drawing.words(view(at + pull) + name_at, "*J*^T*λ*", {colour(1), "middle", 17});
  drawing.dot(view(at), kText, 8);
}

void draw_rod(Drawing& drawing) {
  const View view = {{120, 40}, 170};
  const Vector3d out = {std::sin(0.7), -std::cos(0.7), 0};
  particles::State state{Eigen::VectorXd::Zero(6), Eigen::VectorXd::Zero(6)};
  state.x.tail<3>() = out;
  state.v.tail<3>() = Vector3d(0, 0, 1.6).cross(out);
  drawing.line({view(Vector3d::Zero()), view(out)}, {kText, 4});
  drawing.area({Spot(106, 26), Spot(134, 26), view(Vector3d::Zero())}, kMiddle, 1);
  draw_forces(drawing, view, {{{1, 0, 1.0}}, {}}, state, {-34, 4});
  drawing.words({150, 284}, "The rod pulls inwards.");
}

void draw_bead(Drawing& drawing) {
  const View view = {{520, 148}, 100};
  particles::State state{Vector3d(std::sin(0.8), std::cos(0.8), 0), Vector3d(0.7, -0.5, 0)};
  state.v = Vector3d(0, 0, -0.9).cross(Vector3d(state.x));
  drawing.ring(view.middle, view.unit, {kText, 4});
  draw_forces(drawing, view, {{}, {{0, Vector3d::Zero(), Vector3d::UnitZ(), 1.0}}}, state, {30, 2});
  drawing.words({520, 284}, "The wire pushes outwards here.");
}

// The largest |C| of a double pendulum while it swings.
Spots errors(double stiffness) {
  particles::Toy toy;
  toy.particles = {Vector3d::Ones(), {1, 0, 0}};
  toy.start = {Eigen::VectorXd::Zero(9), Eigen::VectorXd::Zero(9)};
  toy.start.x.tail<6>() << 0.5, 0, 0, 1, 0, 0;
  toy.constraints = {{{0, 1, 0.5}, {1, 2, 0.5}}, {}, stiffness, 2 * std::sqrt(stiffness)};
  particles::MovingToy moving(toy);
  const particles::ToyStep method = toy_step_of(particles::ToyMethod::runge_kutta_4);
  Eigen::MatrixXd scratch(9, method.scratch);
  Spots values;
  Eigen::VectorXd C(2);
  double largest = 0;
  for (int step = 1; step <= 10000; ++step) {
    method.step(moving, {1e-3, particles::kSolveTolerance}, scratch);
    particles::constraint_values(toy.constraints, moving.state.x, C);
    largest = std::max(largest, C.cwiseAbs().maxCoeff());
    if (step % 50 == 0) values.emplace_back(1e-3 * step, std::exchange(largest, 1e-14));
  }
  return values;
}

}  // namespace

std::string draw_P2() {
  Drawing drawing(
      "P2", "Which forces hold a rod and a wire, and do they hold for long?",
      "A weight on a rod: the constraint force points along the rod to its pin. A bead on a ring: the "
      "force points away from the centre, at a right angle to the velocity. Below: the error C "
      "over time stays and adds up without feedback; with feedback it falls to almost nothing.",
      536);
  draw_rod(drawing);
  draw_bead(drawing);
  const Plot plot = drawing.plot({70, 352, 630, 130}, {"time, s", false, 0, 10},
                                 {"|*C*|, m^2, of a double pendulum", true, 1e-14, 1e-5}, 5, 4);
  drawing.curve(plot, errors(0), {colour(1), 2.5});
  drawing.curve(plot, errors(400), {colour(0), 2.5});
  drawing.words(plot(5, 1e-6), "without feedback: errors add up", {colour(1)});
  drawing.words(plot(5, 1e-13), "with feedback: they die away", {colour(0)});
  return drawing.svg();
}

}  // namespace figures
