// STAFF ONLY. For allocations_test: functions of all exercises that compute nothing. Those that promise to allocate nothing
// allocate once, and call what the suite holds, which allocates, too.
#include <vector>

#include "hair/angular_springs.h"
#include "hair/bend_springs.h"
#include "hair/predictor_corrector.h"
#include "hair/rigid_links.h"
#include "hair/static_links.h"
#include "hair/strand_synthesis.h"
#include "hair/stretch_springs.h"
#include "hair/super_helix.h"
#include "particles/constraint_forces.h"
#include "particles/explicit_integrators.h"
#include "particles/implicit_euler.h"
#include "solver/normal_equations.h"

namespace {

void allocate() {
  const std::vector<double> used(3, 1.0);
  const volatile double* const kept = used.data();  // no compiler leaves it out
  static_cast<void>(kept[0]);
}

class Product : public implicitMatrix {
 public:
  explicit Product(implicitMatrix* asked) : asked_(asked), in_(1000), out_(1000) {}
  void matVecMult(double /*x*/[], double /*b*/[]) override {
    if (asked_ != nullptr) asked_->matVecMult(in_.data(), out_.data());
    allocate();
  }

 private:
  implicitMatrix* asked_;
  std::vector<double> in_, out_;
};

void step(particles::Dynamics& dynamics, particles::Input x, particles::Input v, particles::Scratch scratch) {
  dynamics.acceleration(x, v, scratch.col(0));
  allocate();
}

}  // namespace

double ConjGrad(int, implicitMatrix*, double[], double[], double, int*) {
  return 0;
}
std::unique_ptr<implicitMatrix> dense_matrix(int, int, const double[]) {
  return std::make_unique<Product>(nullptr);
}
std::unique_ptr<implicitMatrix> normal_matrix(int, int, implicitMatrix* A, implicitMatrix*) {
  return std::make_unique<Product>(A);
}
double solve_normal_equations(int, int, implicitMatrix*, implicitMatrix*, double[], double[], double, int*) {
  return 0;
}

namespace particles {

void forward_euler(Dynamics& dynamics, double, Output x, Output v, Scratch scratch) {
  step(dynamics, x, v, scratch);
}
void symplectic_euler(Dynamics& dynamics, double, Output x, Output v, Scratch scratch) {
  step(dynamics, x, v, scratch);
}
void midpoint(Dynamics& dynamics, double, Output x, Output v, Scratch scratch) {
  step(dynamics, x, v, scratch);
}
void runge_kutta_4(Dynamics& dynamics, double, Output x, Output v, Scratch scratch) {
  step(dynamics, x, v, scratch);
}

std::unique_ptr<implicitMatrix> implicit_matrix(const Force&, const Particles&, const State&, double,
                                                double) {
  return std::make_unique<Product>(nullptr);
}
void implicit_rhs(const Force& force, const Particles&, const State& state, double, double, Output rhs) {
  force.add_force(state.x, state.v, rhs);
}
SolveReport solve_plain(implicitMatrix&, Output, double, int, Output) {
  return {};
}
SolveReport implicit_euler(const Force&, const Particles&, double, double, State&, Scratch) {
  return {};
}

void constraint_values(const Constraints&, Input, Output) {}
void constraint_rates(const Constraints&, Input, Input, Output) {}
void add_constraint_forces(const Constraints&, Input, Input, Output) {}
std::unique_ptr<implicitMatrix> constraint_matrix(const Constraints&, const Particles&, const State&) {
  return std::make_unique<Product>(nullptr);
}
ConstraintReport solve_constraints(const Constraints&, const Particles&, const State&, Input, Output) {
  return {};
}

}  // namespace particles

namespace hair {

double stretch_energy(const Strand&, Input) {
  return 0;
}
void add_stretch_force(const Strand&, Input, Output) {}
void add_stretch_product(const Strand&, Input, GeometricTerm, Input, Output) {}
double bend_energy(const Strand&, Input) {
  return 0;
}
void add_bend_force(const Strand&, Input, Output) {}
void add_bend_product(const Strand&, Input, Input, Output) {}
void add_bend_product_spd(const Strand&, Input, Input, Output) {}
double bend_spring_energy(const Strand&, Input) {
  return 0;
}
void add_bend_spring_force(const Strand&, Input, Output) {}
void add_bend_spring_product(const Strand&, Input, GeometricTerm, Input, Output) {}

CorrectionReport relax_lengths(const Strand&, double, int, Output) {
  return {};
}
CorrectionReport correct_lengths(const Strand&, double, int, Output, Scratch) {
  allocate();
  return {};
}
CorrectionReport correct_velocities(const Strand&, Input, double, int, Output, Scratch) {
  allocate();
  return {};
}

StepReport predictor_corrector(const particles::Force& force, const particles::Particles&, const Strand&,
                               double, double, particles::State& state, Scratch scratch) {
  force.add_force(state.x, state.v, scratch.col(0));
  allocate();
  return {};
}

void outward_velocities(const std::vector<Link>&, Input, std::vector<LinkPass>&) {
  allocate();
}
void inward_inertias(const std::vector<Link>&, Input, std::vector<LinkPass>&) {
  allocate();
}
void outward_accelerations(const std::vector<Link>&, Input, std::vector<LinkPass>&, Output) {
  allocate();
}

std::array<double, 8> stumpff(double) {
  return {};
}
MaterialFrame frame_at(const MaterialFrame& start, const Vector3d&, double) {
  return start;
}
void carry_frames(const MaterialFrame&, std::vector<HelixElement>&) {}
void helix_stiffness(const HelixStrand&, Output) {}
void elastic_force(const HelixStrand&, Input, Output) {}
HelixJacobian jacobian_at(const MaterialFrame&, const Vector3d&, double) {
  return {};
}
void generalised_force(const std::vector<HelixElement>&, const std::vector<HelixPoint>&, Output) {}
void mass_matrix(const std::vector<HelixElement>&, const std::vector<HelixPoint>&,
                 Eigen::Ref<Eigen::MatrixXd>) {}
void helix_step(const HelixStrand&, const std::vector<HelixElement>&, const std::vector<HelixPoint>&, Input,
                Input, double, Scratch, Output) {
  allocate();
}

double link_strength(const StaticLink&, double) {
  allocate();
  return 0;
}
void remember_stretches(std::span<const StaticLink>, std::span<const Matrix3d>, Input, Output) {
  allocate();
}
double link_energy(std::span<const StaticLink>, std::span<const Matrix3d>, Input, Input) {
  allocate();
  return 0;
}
void add_link_force(std::span<const StaticLink>, std::span<const Matrix3d>, Input, Input, Output) {
  allocate();
}
void add_link_product(std::span<const StaticLink>, Input, Input, Output) {
  allocate();
}
bool touch_strip(int, const std::array<int, 3>&, double, double, Input, Input, StripContact&) {
  allocate();
  return false;
}
double strip_energy(std::span<const StripContact>, const StripLaw&, Input) {
  allocate();
  return 0;
}
void add_strip_force(std::span<const StripContact>, const StripLaw&, Input, Output) {
  allocate();
}
void add_strip_product(std::span<const StripContact>, const StripLaw&, Input, Input, Output) {
  allocate();
}
void apply_strip_friction(std::span<const StripContact>, const StripLaw&, Input, double, Input, Output) {
  allocate();
}

std::array<double, 3> root_weights(const std::array<Vector3d, 3>&, const Vector3d&) {
  allocate();
  return {};
}
void interpolate(const std::array<GuideHair, 3>&, const std::array<double, 3>&, const RootFrame&, Output) {
  allocate();
}
void carry_along(Input, GuideFrames&) {
  allocate();
}
void extrapolate(Input, const GuideFrames&, const Vector3d&, double, Output) {
  allocate();
}
void blend(Input, Input, Input, Output) {
  allocate();
}

}  // namespace hair
