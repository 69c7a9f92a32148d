#include "hair/strand/watch.h"

#include <cstddef>

#include "hair/strand/energy_watch.h"

namespace hair {

namespace {

constexpr ConcernRow kRows[] = {
    {Concern::energy, "energy", "gains energy that nothing gives it",
     "energy gained, of all that it had and got", 0.05},
    {Concern::contact_energy, "contact energy", "gains energy in steps with contacts",
     "energy gained, of all that it had and got", 0.5},
    {Concern::loss, "energy loss", "loses energy that nothing takes",
     "energy lost, of all that it had and got", 0.6},
    {Concern::unmoved, "velocities", "has velocities that it does not move with",
     "their kinetic energy, of all", 0.1},
    {Concern::stretching, "stretching", "is held by stretched springs, and does not move as hair does",
     "mean energy of stretching, of all that it had and got", 200},
    {Concern::stretch, "stretch", "does not keep its lengths", "|l - l0| / l0", 5e-3},
    {Concern::stretch_rate, "stretch rate", "has velocities that do not keep its lengths",
     "|l - l0| / l0 in a step", 0.5},
    {Concern::segment, "segment", "has a segment that is far from its length", "|l - l0| / l0", 0.05},
    {Concern::penetration, "penetration", "remains inside an obstacle", "m", 1e-4},
    {Concern::mends, "mends", "is pushed out of obstacles and corrected without end", "of all steps", 0.15},
    {Concern::unconverged, "unconverged", "has solves that end far above their tolerance",
     "residual, of the right-hand side", 0.1, false, true},
    {Concern::solves, "solves", "has solves that end above their tolerance", "of all its solves", 0.01, true,
     true},
    {Concern::passes, "passes", "goes through strips in single steps: these are too long",
     "particles, so far", 0.5},
};
static_assert(std::size(kRows) == kConcerns);

}  // namespace

std::span<const ConcernRow> concerns() {
  return kRows;
}

void Watch::see(int strand, long step, const Sizes& sizes) {
  for (std::size_t i = 0; i < kConcerns; ++i) {
    const double size = sizes.of[i];
    Seen& seen = seen_[i];
    if (size > seen.size) seen.size = size;
    if (size > 0 && begun_[strand][i] == 0) begun_[strand][i] = step;
    if (!(size > kRows[i].bound) || above_[strand][i]) continue;
    above_[strand][i] = true;
    if (seen.strands++ > 0) continue;
    seen.strand = strand;
    seen.step = kRows[i].adds_up ? begun_[strand][i] : step;
  }
}

void add(const EnergyWatch& energy, Sizes& sizes) {
  sizes[Concern::energy] = energy.gain();
  sizes[Concern::contact_energy] = energy.contact_gain();
  sizes[Concern::loss] = energy.loss();
  sizes[Concern::unmoved] = energy.unmoved();
}

std::vector<Warning> Watch::warnings() const {
  std::vector<Warning> all;
  for (std::size_t i = 0; i < kConcerns; ++i)
    if (const Seen& seen = seen_[i]; seen.strands > 0)
      all.push_back({&kRows[i], seen.strand, seen.step, seen.strands, seen.size});
  return all;
}

}  // namespace hair
