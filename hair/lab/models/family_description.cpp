#include <algorithm>
#include <cmath>
#include <string_view>

#include "hair/lab/models/family.h"
#include "hair/simulation/models.h"

namespace hair::model_study {

std::string left_out(const Family& family, const StrandSpec& spec, const std::vector<std::string>& absent) {
  const ModelRow& model = *find_model(family.model);
  std::vector<std::string> called = model.exercises(spec);
  if (model.calls_method)
    for (const std::string_view id : row_of(family.method).exercises) called.emplace_back(id);
  for (const std::string& id : called)
    if (std::find(absent.begin(), absent.end(), id) != absent.end()) return "the course has no " + id;
  return {};
}

Description description_of(const Family& family, const StrandSpec& spec, int elements, double step) {
  Description description;
  ModelledStrand strand{find_model(family.model), spec};
  strand.spec.elements = elements;
  strand.spec.fibre.stretch_factor = family.stretch_factor;
  strand.spec.fibre.twist_factor = family.twist_factor;
  description.modelled = {strand};
  description.method = family.method;
  description.geometric_term = family.geometric_term;
  description.step = step;
  description.watched = false;  // times are the methods' own
  return description;
}

// The fastest oscillation is that of neighbours against each other: springs along the strand, and links that twist, both
// 2 c / l with the speed of sound or of torsion; links that bend to and fro, sqrt(48 EI / (rho A)) / l^2.
double explicit_step(const Family& family, const StrandSpec& spec, int elements) {
  const Material& material = spec.fibre.material;
  const double l = spec.length / elements, line = material.line_density();
  double fastest = 0;
  if (std::string_view(family.model) == "mass_spring") {
    fastest = 2 * std::sqrt(family.stretch_factor * material.stretch_rigidity() / line) / l;
  } else {
    const double twist = 2 * std::sqrt(material.shear_modulus / material.density) / l;
    fastest = std::max(twist, std::sqrt(48 * material.bend_rigidity() / line) / (l * l));
  }
  return 1 / fastest;
}

}  // namespace hair::model_study
