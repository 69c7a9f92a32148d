#include "hair/simulation/models.h"

#include <stdexcept>

#include "hair/simulation/mass_spring_strand.h"

namespace hair {

namespace {

std::vector<std::string> mass_spring_exercises(const StrandSpec& spec) {
  return exercises_of(discretise(spec));
}

std::string mass_spring_why_not(const StrandSpec& spec) {
  if (!std::holds_alternative<Straight>(spec.form) && !spec.clamped)
    return "wavy and curly hair must be clamped";
  return {};
}

std::unique_ptr<Body> make_mass_spring(const StrandSpec& spec, const Description& description) {
  if (const std::string why = mass_spring_why_not(spec); !why.empty()) throw std::invalid_argument(why);
  return mass_spring_strand("a strand", discretise(spec), description);
}

constexpr ModelRow kModels[] = {
    {"mass_spring", mass_spring_exercises, mass_spring_why_not, make_mass_spring},
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
