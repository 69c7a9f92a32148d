#include "hair/simulation/models.h"

#include <array>
#include <stdexcept>

#include "hair/simulation/mass_spring_strand.h"
#include "hair/simulation/rigid_links_strand.h"
#include "solver/course.h"

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

bool mass_spring_moves_by(const MethodRow& method) {
  return method.mass_spring != nullptr;
}

constexpr ModelRow kMassSpring = {"mass_spring",       mass_spring_exercises, true,
                                  mass_spring_why_not, make_mass_spring,      mass_spring_moves_by};

// With what the course has; a row that is not used is not linked.
template <bool has_links>
constexpr auto rows() {
  if constexpr (has_links)
    return std::array{kMassSpring, ModelRow{"rigid_links", rigid_links_exercises, false, rigid_links_why_not,
                                            make_rigid_links, rigid_links_moves_by}};
  else
    return std::array{kMassSpring};
}
constexpr auto kModels = rows<in_course("H7")>();

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
