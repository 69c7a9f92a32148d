// The sum of several forces. It owns its parts; without parts it is zero.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "particles/force.h"

namespace particles {

class ForceSum : public Force {
 public:
  void add(std::unique_ptr<const Force> part) { parts_.push_back(std::move(part)); }

  // add(std::make_unique<Part>(arguments...)). Returns the part, which lives as long as the sum.
  template <typename Part, typename... Arguments>
  const Part& emplace(Arguments&&... arguments) {
    auto part = std::make_unique<const Part>(std::forward<Arguments>(arguments)...);
    const Part& added = *part;
    add(std::move(part));
    return added;
  }

  const Force& last() const { return *parts_.back(); }

  double energy(Input x) const override {
    double energy = 0;
    for (const auto& part : parts_) energy += part->energy(x);
    return energy;
  }
  void add_force(Input x, Input v, Output f) const override {
    for (const auto& part : parts_) part->add_force(x, v, f);
  }
  void add_dfdx(Input x, Input v, Input dx, Output df) const override {
    for (const auto& part : parts_) part->add_dfdx(x, v, dx, df);
  }
  void add_dfdv(Input x, Input v, Input dv, Output df) const override {
    for (const auto& part : parts_) part->add_dfdv(x, v, dv, df);
  }
  bool add_band(Input x, Input v, double by_dfdx, double by_dfdv, solver::BlockBand& band,
                Scratch work) const override {
    if (!has_band_) return false;
    for (const auto& part : parts_)
      if (!part->add_band(x, v, by_dfdx, by_dfdv, band, work)) return false;
    return true;
  }

  // The sum behaves from now on as if a part had no band: solves are not preconditioned.
  void hide_band() { has_band_ = false; }

 private:
  bool has_band_ = true;
  std::vector<std::unique_ptr<const Force>> parts_;
};

}  // namespace particles
