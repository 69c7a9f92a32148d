#include "hair/simulation/models.h"

#include <stdexcept>

#include "hair/simulation/mass_spring_strand.h"
#include "hair/simulation/rigid_links_strand.h"
#include "hair/simulation/super_helix_strand.h"

namespace hair {

namespace {

std::vector<std::string> mass_spring_exercises(const StrandSpec& spec) {
  return exercises_of(discretise(spec));
}

std::string mass_spring_why_not(const StrandSpec& spec) {
  if (is_wave_or_curl(spec.form) && !spec.clamped) return "wavy and curly hair must be clamped";
  if (spec.fibre.twist_factor != 1)
    return "masses and springs have no twist; leave the twist_factor out, or choose another model";
  if (spec.fibre.relaxation_time != 0)
    return "masses and springs don't resist the rates of bends; the relaxation_time must be 0";
  if (spec.fibre.joint_limit) return "masses and springs have no limits of joints; leave the joint_limit out";
  return {};
}

std::unique_ptr<Body> make_mass_spring(const StrandSpec& spec, const Description& description) {
  if (const std::string why = mass_spring_why_not(spec); !why.empty()) throw std::invalid_argument(why);
  return mass_spring_strand("a strand", discretise(spec), description);
}

long points_of_elements(const StrandSpec& spec) {
  return spec.elements + 1L;
}

bool mass_spring_moves_by(const MethodRow&) {
  return true;
}

constexpr ModelRow kModels[] = {
    {.id = "mass_spring",
     .exercises = mass_spring_exercises,
     .calls_method = true,
     .why_not = mass_spring_why_not,
     .points = points_of_elements,
     .make = make_mass_spring,
     .moves_by = mass_spring_moves_by},
    {.id = "rigid_links",
     .exercises = rigid_links_exercises,
     .calls_method = false,
     .why_not = rigid_links_why_not,
     .points = points_of_elements,
     .make = make_rigid_links,
     .moves_by = rigid_links_moves_by},
    {.id = "super_helix",
     .exercises = super_helix_exercises,
     .calls_method = false,
     .why_not = super_helix_why_not,
     .points = super_helix_points,
     .make = make_super_helix,
     .moves_by = super_helix_moves_by},
};

}  // namespace

std::span<const ModelRow> models() {
  return kModels;
}

const ModelRow* find_model(std::string_view id) {
  for (const ModelRow& row : kModels)
    if (row.id == id) return &row;
  return nullptr;
}

}  // namespace hair
