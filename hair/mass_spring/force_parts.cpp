#include "hair/mass_spring/force_parts.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "hair/mass_spring/rest_curvature.h"
#include "particles/drag.h"
#include "particles/gravity.h"

namespace hair {

namespace {

using Starts = std::span<const StrandStart>;

bool is_curved(const StrandStart& start) {
  return start.rest_curvature.size() > 0;
}

bool stretches(const StrandStart& start) {
  return start.strand.stretch_rigidity > 0;
}

bool bends_straight(const StrandStart& start) {
  return start.strand.bend_rigidity > 0 && !is_curved(start);
}

bool bends_curved(const StrandStart& start) {
  return start.strand.bend_rigidity > 0 && is_curved(start);
}

bool skips(const StrandStart& start) {
  return start.strand.skip_rigidity > 0;
}

const char* why_no_stretching(Starts) {
  return "no strand resists it: EA is 0";
}

const char* why_no_bending(Starts starts) {
  return std::any_of(starts.begin(), starts.end(), bends_curved) ? "rest curvature takes its place"
                                                                 : "no strand resists it: EI is 0";
}

const char* why_no_rest_curvature(Starts starts) {
  return std::any_of(starts.begin(), starts.end(), is_curved) ? "no curved strand resists bending: EI is 0"
                                                              : "every strand is straight at rest";
}

const char* why_no_skipping(Starts) {
  return "no strand has them";
}

void add_stretching(const StrandStart&, GeometricTerm term, Products, MovingStrand& moving) {
  moving.force.emplace<StretchForce>(moving.strand, term);
}

void add_bending(const StrandStart&, GeometricTerm, Products product, MovingStrand& moving) {
  moving.force.emplace<BendForce>(moving.strand, product);
}

void add_rest_curvature(const StrandStart& start, GeometricTerm, Products product, MovingStrand& moving) {
  auto rest =
      std::make_unique<RestCurvature>(moving.strand, start.rest_curvature, start.root_normal, product);
  moving.rest_curvature = rest.get();
  moving.force.add(std::move(rest));
}

void add_skipping(const StrandStart&, GeometricTerm term, Products, MovingStrand& moving) {
  moving.force.emplace<BendSpringForce>(moving.strand, term);
}

constexpr ForcePart kParts[] = {
    {.name = "stretching",
     .how = "springs along the segments",
     .exercise = "H1",
     .acts = stretches,
     .why_not = why_no_stretching,
     .add = add_stretching,
     .of_lengths = true},
    {.name = "bending",
     .how = "angular springs at the joints",
     .exercise = "H2",
     .acts = bends_straight,
     .why_not = why_no_bending,
     .add = add_bending},
    {.name = "rest curvature",
     .how = "at the joints",
     .exercise = "",
     .acts = bends_curved,
     .why_not = why_no_rest_curvature,
     .add = add_rest_curvature},
    {.name = "springs that skip",
     .how = "springs that skip a particle,",
     .exercise = "H3",
     .acts = skips,
     .why_not = why_no_skipping,
     .add = add_skipping},
};

}  // namespace

std::span<const ForcePart> force_parts() {
  return kParts;
}

std::vector<std::string> exercises_of(const StrandStart& start) {
  std::vector<std::string> called;
  for (const ForcePart& part : kParts)
    if (*part.exercise != '\0' && part.acts(start)) called.emplace_back(part.exercise);
  return called;
}

void add_forces(const ForceOptions& options, const StrandStart& start, MovingStrand& moving) {
  const Strand& strand = moving.strand;
  particles::ForceSum& force = moving.force;
  for (const ForcePart& part : kParts)
    if (part.acts(start)) {
      part.add(start, options.geometric_term, options.bend_product, moving);
      (part.of_lengths ? moving.stretching : moving.bending).push_back(&force.last());
    }
  if (options.gravity != Vector3d::Zero()) force.emplace<particles::Gravity>(strand.mass, options.gravity);
  if (options.drag > 0) {
    // Half of the segments on either side, as for masses.
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(strand.count());
    coefficients.head(strand.segments()) += options.drag / 2 * strand.rest_length;
    coefficients.tail(strand.segments()) += options.drag / 2 * strand.rest_length;
    moving.drag = &force.emplace<particles::Drag>(std::move(coefficients), options.wind);
  }
  if (options.point_forces) {
    auto forces = std::make_unique<PointForces>();
    moving.point_forces = forces.get();
    force.add(std::move(forces));
  }
  if (!options.band) force.hide_band();
}

}  // namespace hair
