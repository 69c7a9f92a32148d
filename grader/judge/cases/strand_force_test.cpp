// STAFF ONLY. Tests that one wrong constant costs one category: the energy's factor excuses that of the
// force, and the force's that of the product.
#include "grader/judge/cases/strand_force.h"

#include <gtest/gtest.h>

namespace grader::inline judge {
namespace {

// Is E = x . x / 2. The strand's rigidities are the factors by which the student's answers are off.
const StrandForce kForce{
    .energy = [](Trial&,
                 const Posed& posed) { return posed.strand.stretch_rigidity * posed.x.squaredNorm() / 2; },
    .ask_force = [](Trial&, const Posed& posed, const VectorXd& before) -> VectorXd {
      return before - posed.strand.bend_rigidity * posed.x;
    },
    .reference_energy = [](const Posed& posed) { return posed.x.squaredNorm() / 2; },
    .reference_force = [](const Posed& posed) -> VectorXd { return -posed.x; },
    .products = {{[](Trial&, const Posed& posed, const VectorXd& dx, const VectorXd& before) -> VectorXd {
                    return before - posed.strand.skip_rigidity * dx;
                  },
                  [](const Posed&, const VectorXd& dx) -> VectorXd { return -dx; }}},
    .energy_rounding = [](const Posed&) { return 1e-12; },
    .force_rounding = [](const Posed&) { return 1e-12; },
    .product_rounding = [](const Posed&, const VectorXd&) { return 1e-12; },
    .rigidity = &Strand::stretch_rigidity};

TEST(StrandForce, OneWrongConstantCostsOneCategory) {
  const struct {
    double energy, force, product;
    const char* fails;
  } rows[] = {{1, 1, 1, ""},
              {2, 2, 2, "energy "},
              {2, 1, 1, "energy "},
              {1, 2, 2, "force "},
              {1, 1, 2, "product "},
              {2, 4, 4, "energy force "},
              {2, 2, 4, "energy product "},
              {0, 2, 2, "energy force "},
              {1, -1, -1, "force product "}};
  for (const auto& [energy, force, product, fails] : rows) {
    Posed posed;
    posed.strand.stretch_rigidity = energy;
    posed.strand.bend_rigidity = force;
    posed.strand.skip_rigidity = product;
    posed.x = VectorXd::LinSpaced(6, 1, 2);
    Student nobody{WorkerSetup{}};
    Trial trial(nobody, Random("seed", "a case"));
    std::string failed;
    const auto ask = [&](const char* what, const auto& question) {
      try {
        question();
      } catch (const CaseFailed&) {
        failed += what;
      }
    };
    ask("energy ", [&] { expect_energy(trial, kForce, posed); });
    ask("force ", [&] { expect_force(trial, kForce, posed); });
    ask("product ",
        [&] { expect_product(trial, kForce, kForce.products[0], posed, VectorXd::LinSpaced(6, 2, -1)); });
    EXPECT_EQ(failed, fails) << energy << ", " << force << ", " << product;
  }
}

}  // namespace
}  // namespace grader::judge
