// STAFF ONLY. P2's figure: the forces that hold a rod and a wire, and the error with and without feedback.
#include "particles/constraint_forces.h"
#include "particles/implicit_euler.h"
#include "particles/toys/moving_toy.h"
#include "reference/figures/drawing.h"

namespace figures {
namespace {

// Draws weight, velocity and constraint force of a particle of 1 kg that moves across `out` from particle 0,
// which is pinned.
void draw_forces(Drawing& drawing, const View& view, const particles::Constraints& constraints,
                 const Vector3d& out, double speed, const Spot& beside) {
  const particles::Particles particles{Eigen::Vector2d::Ones(), {1, 0}};
  particles::State state{VectorXd::Zero(6), VectorXd::Zero(6)};
  state.x.tail<3>() = out;
  state.v.tail<3>() = speed * Vector3d::UnitZ().cross(out);
  VectorXd f = -particles::kEarthGravity * VectorXd::Unit(6, 4), force = VectorXd::Zero(6),
           lambda(constraints.rows());
  particles::solve_constraints(constraints, particles, state, f, lambda);
  particles::add_constraint_forces(constraints, state.x, lambda, force);
  const auto arrow = [&](const Vector3d& vector, double pixels, const Pen& pen, const char* name,
                         const Spot& at) {
    drawing.arrow(view(out), view(out + pixels / view.unit * vector), pen, name, at);
  };
  arrow(f.tail<3>(), 8, {kMiddle, 3}, "*m g*", {0, 20});
  arrow(state.v.tail<3>(), 45, {colour(0), 2, "6 4"}, "*v*", {14, -4});
  arrow(force.tail<3>(), 8, {colour(1), 4}, "*J*^T*λ*", beside);
  drawing.dot(view(out), kText, 8);
}

// The largest |C| of a double pendulum while it swings.
Spots errors(double stiffness) {
  particles::Toy toy;
  toy.particles = {Vector3d::Ones(), {1, 0, 0}};
  toy.start = {VectorXd::Zero(9), VectorXd::Zero(9)};
  toy.start.x.tail<6>() << 0.5, 0, 0, 1, 0, 0;
  toy.constraints = {{{0, 1, 0.5}, {1, 2, 0.5}}, {}, stiffness, 2 * std::sqrt(stiffness)};
  particles::MovingToy moving(toy);
  const particles::ToyStep method = toy_step_of(particles::ToyMethod::runge_kutta_4);
  Eigen::MatrixXd scratch(9, method.scratch);
  VectorXd C(2);
  return sampled(0.05, 10, 199, [&](double time) {
    double largest = 1e-14;
    for (int step = 0; step < 50; ++step) {
      method.step(moving, {1e-3, particles::kSolveTolerance}, scratch);
      particles::constraint_values(toy.constraints, moving.state.x, C);
      largest = std::max(largest, C.cwiseAbs().maxCoeff());
    }
    return Spot(time, largest);
  });
}

}  // namespace

std::string draw_p2() {
  Drawing drawing(
      "P2", 536, "Which forces hold a rod and a wire, and do they hold for long?",
      "The forces point along the rod and across the wire. Errors of a double pendulum over time.");
  const View rod = {{120, 40}, 170}, wire = {{520, 148}, 100};
  const Vector3d centre = Vector3d::Zero(), hanging(std::sin(0.7), -std::cos(0.7), 0),
                 sliding(std::sin(0.8), std::cos(0.8), 0);
  drawing.line({rod(centre), rod(hanging)}, {kText, 4});
  drawing.area({rod(centre) - Spot(14, 14), rod(centre) + Spot(14, -14), rod(centre)}, kMiddle, 1);
  draw_forces(drawing, rod, {{{1, 0, 1.0}}, {}}, hanging, 1.6, {-34, 4});
  drawing.words({150, 298}, "The rod pulls inwards.");
  drawing.ring(wire(centre), wire.unit, {kText, 4});
  draw_forces(drawing, wire, {{}, {{1, centre, Vector3d::UnitZ(), 1.0}}}, sliding, -0.9, {30, 2});
  drawing.words({520, 298}, "The wire pushes outwards here.");
  const Plot plot = drawing.plot({70, 352, 630, 130}, {"time, s", false, 0, 10},
                                 {"|*C*|, m^2, of a double pendulum", true, 1e-14, 1e-5}, 5, 4);
  drawing.curve(plot, errors(0), {colour(1), 2.5});
  drawing.curve(plot, errors(400), {colour(0), 2.5});
  drawing.words(plot(5, 1e-6), "without feedback: errors add up", {colour(1)});
  drawing.words(plot(5, 1e-13), "with feedback: they stay small", {colour(0)});
  return drawing.svg();
}

}  // namespace figures
