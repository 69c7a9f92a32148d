#include "hair/linked_guides/linked_force.h"

#include "solver/block_band.h"

namespace hair {

void LinkedForce::add_strand(const particles::Force& force, Eigen::Index size) {
  const Eigen::Index first = parts_.empty() ? 0 : parts_.back().first + parts_.back().size;
  parts_.push_back({force, first, size});
}

double LinkedForce::energy(Input x) const {
  double energy = link_energy(mesh_.links, state_.frames, state_.largest, x) +
                  strip_energy(state_.contacts, mesh_.law, x);
  for (const auto& [force, first, size] : parts_) energy += force.energy(x.segment(first, size));
  return energy;
}

void LinkedForce::add_mesh_force(Input x, Output f) const {
  add_link_force(mesh_.links, state_.frames, state_.largest, x, f);
  torque_.add_force(state_.frames, x, f);
  add_strip_force(state_.contacts, mesh_.law, x, f);
}

void LinkedForce::add_force(Input x, Input v, Output f) const {
  for (const auto& [force, first, size] : parts_)
    force.add_force(x.segment(first, size), v.segment(first, size), f.segment(first, size));
  add_mesh_force(x, f);
}

void LinkedForce::add_dfdx(Input x, Input v, Input dx, Output df) const {
  for (const auto& [force, first, size] : parts_)
    force.add_dfdx(x.segment(first, size), v.segment(first, size), dx.segment(first, size),
                   df.segment(first, size));
  add_link_product(mesh_.links, state_.largest, dx, df);
  torque_.add_product(state_.frames, x, dx, df);
  add_strip_product(state_.contacts, mesh_.law, x, dx, df);
}

void LinkedForce::add_dfdv(Input x, Input v, Input dv, Output df) const {
  for (const auto& [force, first, size] : parts_)
    force.add_dfdv(x.segment(first, size), v.segment(first, size), dv.segment(first, size),
                   df.segment(first, size));
}

bool LinkedForce::add_band(Input x, Input v, double by_dfdx, double by_dfdv, solver::BlockBand& band,
                           particles::Scratch work) const {
  for (const auto& [force, first, size] : parts_) {
    // The rows of this strand in the band's memory.
    auto block = band.block(static_cast<int>(first / 3), 0);
    const Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>> rows(
        block.data(), size, solver::BlockBand::kColumns, Eigen::OuterStride<>(block.outerStride()));
    solver::BlockBand own(rows);
    if (!force.add_band(x.segment(first, size), v.segment(first, size), by_dfdx, by_dfdv, own,
                        work.middleRows(first, size)))
      return false;
  }
  return true;
}

}  // namespace hair
