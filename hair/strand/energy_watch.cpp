#include "hair/strand/energy_watch.h"

#include <cmath>

namespace hair {

namespace {

// m/s. The balance includes the energy of a motion this slow from the start, so that rounding errors, which
// are far smaller, are no gain.
constexpr double kUnseen = 1e-3;

}  // namespace

EnergyWatch::EnergyWatch(double mass, double length, double gravity, double drag)
    : EnergyWatch(mass * (gravity * length + kUnseen * kUnseen / 2), 2 * drag * length / mass) {}

void EnergyWatch::begin(const Energies& now) {
  begun_ = true;
  now_ = now;
  spare_ = now.aside;
  scale_ = unit_ + now.kinetic + now.elastic + now.aside;
}

void EnergyWatch::root_moved(const Energies& now) {
  come_in(now.kept() - now_.kept());
  now_ = now;
}

void EnergyWatch::after_step(const Energies& now, double work, bool in_contact, double h) {
  come_in(work);
  double gained = now.kept() - now_.kept() - work;
  const double spared = std::clamp(gained, 0.0, spare_);
  spare_ -= spared;
  last_ = gained -= spared;
  now_ = now;
  const double left = std::exp(-fading_ * h);
  free_.add(in_contact ? 0 : gained, left);
  in_contact_.add(in_contact ? gained : 0);
  aside_ += now.aside / scale_;
  unmoved_ += now.unmoved;
  moving_ += now.kinetic;
  ++steps_;
  gain_ = std::max(gain_, free_.risen() / scale_);
  contact_gain_ = std::max(contact_gain_, in_contact_.risen() / scale_);
  // Work that wind puts into stretching is not lost.
  loss_ = std::max(loss_, (free_.fallen() - std::min(now.aside, came_in_)) / scale_);
}

}  // namespace hair
