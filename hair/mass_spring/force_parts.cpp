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

void add_stretching(const StrandStart&, GeometricTerm term, Products, MovingStrand& moving,
                    particles::ForceSum& sum) {
  sum.emplace<StretchForce>(moving.strand, term);
}

void add_bending(const StrandStart&, GeometricTerm, Products product, MovingStrand& moving,
                 particles::ForceSum& sum) {
  sum.emplace<BendForce>(moving.strand, product);
}

void add_rest_curvature(const StrandStart& start, GeometricTerm, Products product, MovingStrand& moving,
                        particles::ForceSum& sum) {
  auto rest =
      std::make_unique<RestCurvature>(moving.strand, start.rest_curvature, start.root_normal, product);
  moving.rest_curvatures.push_back(rest.get());
  sum.add(std::move(rest));
}

void add_skipping(const StrandStart&, GeometricTerm term, Products, MovingStrand& moving,
                  particles::ForceSum& sum) {
  sum.emplace<BendSpringForce>(moving.strand, term);
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

// To `sum`, with products as said.
void add_parts(const ForceOptions& options, const StrandStart& start, GeometricTerm geometric_term,
               Products bend_product, MovingStrand& moving, particles::ForceSum& sum) {
  const Strand& strand = moving.strand;
  const bool main = &sum == &moving.force;
  for (const ForcePart& part : kParts)
    if (part.acts(start)) {
      part.add(start, geometric_term, bend_product, moving, sum);
      if (main) (part.of_lengths ? moving.stretching : moving.bending).push_back(&sum.last());
    }
  if (options.gravity != Vector3d::Zero()) sum.emplace<particles::Gravity>(strand.mass, options.gravity);
  if (options.drag > 0) {
    // Half of the segments on either side, as for masses.
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(strand.count());
    coefficients.head(strand.segments()) += options.drag / 2 * strand.rest_length;
    coefficients.tail(strand.segments()) += options.drag / 2 * strand.rest_length;
    const auto& drag = sum.emplace<particles::Drag>(std::move(coefficients), options.wind);
    if (main) moving.drag = &drag;
  }
  if (options.point_forces) {
    auto forces = std::make_unique<PointForces>();
    moving.point_forces.push_back(forces.get());
    sum.add(std::move(forces));
  }
}

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

void add_forces(const ForceOptions& options, const StrandStart& start, bool with_definite,
                MovingStrand& moving) {
  using enum GeometricTerm;
  using enum Products;
  if (with_definite) {
    add_parts(options, start, full, exact, moving, moving.force);
    add_parts(options, start, filtered, definite, moving, moving.definite_force);
  } else {
    add_parts(options, start, options.geometric_term, options.bend_product, moving, moving.force);
  }
  if (!options.band) {
    moving.force.hide_band();
    moving.definite_force.hide_band();
  }
}

}  // namespace hair
