#include "hair/bench/plain_program.h"

#include <stdexcept>

#include "hair/predictor_corrector.h"
#include "hair/stretch_springs.h"
#include "particles/explicit_integrators.h"
#include "particles/implicit_euler.h"
#include "particles/products_to_band.h"

namespace hair_bench {

namespace {

using particles::Input;
using particles::Output;

// Both of the forces that there are.
class StretchAndWeight final : public particles::Force {
 public:
  StretchAndWeight(const hair::Strand& strand, double gravity, hair::GeometricTerm term)
      : strand_(strand), gravity_(gravity), term_(term) {}
  double energy(Input) const override { return 0; }
  void add_force(Input x, Input, Output f) const override {
    add_stretch_force(strand_, x, f);
    for (int i = 0; i < strand_.count(); ++i) f[3 * i + 2] += strand_.mass[i] * gravity_;
  }
  void add_dfdx(Input x, Input, Input dx, Output df) const override {
    add_stretch_product(strand_, x, term_, dx, df);
  }
  void add_dfdv(Input, Input, Input, Output) const override {}
  bool add_band(Input x, Input, double by_dfdx, double, solver::BlockBand& band,
                particles::Scratch work) const override {
    return particles::add_products(
        1, by_dfdx, [&](Input dx, Output df) { add_stretch_product(strand_, x, term_, dx, df); }, band, work);
  }

 private:
  const hair::Strand& strand_;
  double gravity_;
  hair::GeometricTerm term_;
};

class Falling final : public particles::Dynamics {
 public:
  Falling(const hair::Strand& strand, const Eigen::VectorXd& inverse_mass, double gravity)
      : strand_(strand), inverse_mass_(inverse_mass), gravity_(gravity) {}
  void acceleration(Input x, Input, Output a) override {
    a.setZero();
    add_stretch_force(strand_, x, a);
    a.head<3>().setZero();
    for (int i = 1; i < strand_.count(); ++i) {
      a[3 * i + 2] += strand_.mass[i] * gravity_;
      a.segment<3>(3 * i) *= inverse_mass_[i];
    }
  }

 private:
  const hair::Strand& strand_;
  const Eigen::VectorXd& inverse_mass_;
  double gravity_;
};

}  // namespace

PlainProgram::PlainProgram(const hair::Description& description)
    : method_(description.method),
      h_(description.step),
      tolerance_(description.tolerance),
      gravity_(description.gravity.z()),
      term_(description.geometric_term.value_or(hair::row_of(description.method).usual_term())) {
  int most = 0;
  for (const hair::StrandStart& start : description.strands) {
    const int n = start.strand.count();
    Hair& hair = strands_.emplace_back(Hair{start.strand,
                                            {start.strand.mass, std::vector<char>(n, 0)},
                                            start.strand.mass.cwiseInverse(),
                                            start.state});
    hair.particles.pinned[0] = 1;
    most = std::max(most, n);
  }
  scratch_.resize(3 * most, hair::kPredictorCorrectorScratch);
}

void PlainProgram::steps(int count) {
  for (int k = 0; k < count; ++k)
    for (Hair& hair : strands_) {
      auto scratch = scratch_.topRows(3 * hair.strand.count());
      const StretchAndWeight force(hair.strand, gravity_, term_);
      Falling falling(hair.strand, hair.inverse_mass, gravity_);
      switch (method_) {
        case hair::Method::implicit_euler:
          implicit_euler(force, hair.particles, h_, tolerance_, hair.state, scratch);
          break;
        case hair::Method::predictor_corrector:
          predictor_corrector(force, hair.particles, hair.strand, h_, tolerance_, hair.state, scratch);
          break;
        case hair::Method::symplectic_euler:
          particles::symplectic_euler(falling, h_, hair.state.x, hair.state.v, scratch);
          break;
        case hair::Method::runge_kutta_4:
          particles::runge_kutta_4(falling, h_, hair.state.x, hair.state.v, scratch);
          break;
        default:
          throw std::invalid_argument("the plain program has no such method");
      }
    }
}

}  // namespace hair_bench
