#include "hair/linked_guides/linked_energy.h"

#include <algorithm>

namespace hair {

void LinkedEnergy::restart() {
  *this = LinkedEnergy(std::move(guides_));
}

void LinkedEnergy::after_step(const MeshEnergies& mesh) {
  if (!begun_) {
    begun_ = true;
    links_ = mesh.links_before;
    strips_ = mesh.strips_before;
    scale_ = links_ + strips_;
  }
  const bool touched = mesh.contacts || strips_ > 0;
  scale_ += std::max(mesh.links_before - links_, 0.0) + std::max(mesh.root_work, 0.0);
  double gained = mesh.links_after - mesh.links_before + mesh.strips_after - strips_ - mesh.root_work;
  links_ = mesh.links_after;
  strips_ = mesh.strips_after;

  double scale = scale_;
  for (const EnergyWatch* guide : guides_) {
    gained += guide->last();
    scale += guide->scale();
  }
  (touched ? in_contact_ : free_).add(gained);
  gain_ = std::max(gain_, free_.risen() / scale);
  contact_gain_ = std::max(contact_gain_, in_contact_.risen() / scale);
  loss_ = std::max(loss_, free_.fallen() / scale);
}

}  // namespace hair
