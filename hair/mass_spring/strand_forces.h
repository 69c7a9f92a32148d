// The forces within a strand as particles::Force, for the integrators. Each keeps a reference to a strand,
// which must outlive it and may change between calls; for example the root's tangent changes when the root
// turns.
#pragma once

#include "hair/geometric_term.h"
#include "hair/strand.h"
#include "particles/force.h"
#include "particles/products.h"

namespace hair {

using particles::Input;
using particles::Output;
using particles::Products;

// H1: springs along the segments. `term` selects the products' geometric term.
class StretchForce final : public particles::Force {
 public:
  StretchForce(const Strand& strand, GeometricTerm term) : strand_(strand), term_(term) {}
  double energy(Input x) const override;
  void add_force(Input x, Input v, Output f) const override;
  void add_dfdx(Input x, Input v, Input dx, Output df) const override;
  void add_dfdv(Input, Input, Input, Output) const override {}
  bool add_band(Input x, Input v, double by_dfdx, double by_dfdv, solver::BlockBand& band,
                particles::Scratch work) const override;

 private:
  const Strand& strand_;
  GeometricTerm term_;
};

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

// H3: springs that skip a particle.
class BendSpringForce final : public particles::Force {
 public:
  BendSpringForce(const Strand& strand, GeometricTerm term) : strand_(strand), term_(term) {}
  double energy(Input x) const override;
  void add_force(Input x, Input v, Output f) const override;
  void add_dfdx(Input x, Input v, Input dx, Output df) const override;
  void add_dfdv(Input, Input, Input, Output) const override {}
  bool add_band(Input x, Input v, double by_dfdx, double by_dfdv, solver::BlockBand& band,
                particles::Scratch work) const override;

 private:
  const Strand& strand_;
  GeometricTerm term_;
};

}  // namespace hair
