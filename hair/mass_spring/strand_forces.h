// The forces within a strand as particles::Force, for the integrators. Each keeps a reference to a strand,
// which must outlive it and may change between calls; for example the root's tangent changes when the root
// turns.
#pragma once

#include "hair/bend_springs.h"
#include "hair/geometric_term.h"
#include "hair/strand.h"
#include "hair/stretch_springs.h"
#include "particles/force.h"
#include "particles/products_to_band.h"
#include "particles/springs.h"

namespace hair {

using particles::Input;
using particles::Output;
using particles::Products;

// Springs between each particle i and i + reach: their energy, force and product. `term` selects the
// products' geometric term.
template <auto energy_of, auto add_force_of, auto add_product_of, int reach>
class SpringForce final : public particles::Force {
 public:
  SpringForce(const Strand& strand, GeometricTerm term) : strand_(strand), term_(term) {}
  double energy(Input x) const override { return energy_of(strand_, x); }
  void add_force(Input x, Input, Output f) const override { add_force_of(strand_, x, f); }
  void add_dfdx(Input x, Input, Input dx, Output df) const override {
    add_product_of(strand_, x, term_, dx, df);
  }
  void add_dfdv(Input, Input, Input, Output) const override {}
  bool add_band(Input x, Input, double by_dfdx, double, solver::BlockBand& band,
                particles::Scratch work) const override {
    return particles::add_products(
        reach, by_dfdx, [&](Input dx, Output df) { add_product_of(strand_, x, definite(term_), dx, df); },
        band, work);
  }

 private:
  const Strand& strand_;
  GeometricTerm term_;
};

// H1 joins neighbours; H3 skips a particle.
using StretchForce = SpringForce<stretch_energy, add_stretch_force, add_stretch_product, 1>;
using BendSpringForce = SpringForce<bend_spring_energy, add_bend_spring_force, add_bend_spring_product, 2>;

// H2: angular springs at the joints.
class BendForce final : public particles::Force {
 public:
  BendForce(const Strand& strand, Products product) : strand_(strand), product_(product) {}
  double energy(Input x) const override;
  void add_force(Input x, Input v, Output f) const override;
  void add_dfdx(Input x, Input v, Input dx, Output df) const override;
  void add_dfdv(Input, Input, Input, Output) const override {}
  bool add_band(Input x, Input v, double by_dfdx, double by_dfdv, solver::BlockBand& band,
                particles::Scratch work) const override;

 private:
  const Strand& strand_;
  Products product_;
};

}  // namespace hair
