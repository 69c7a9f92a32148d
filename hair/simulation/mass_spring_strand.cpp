#include "hair/simulation/models.h"

#include <stdexcept>

#include "hair/linked_guides/linked_guides.h"
#include "hair/mass_spring/force_parts.h"
#include "hair/mass_spring/step_methods.h"

namespace hair {

namespace {

std::string springs_why_not(const StrandSpec& spec) {
  if (is_wave_or_curl(spec.form) && !spec.clamped) return "wavy and curly hair must be clamped";
  if (spec.fibre.twist_factor != 1)
    return "masses and springs have no twist; leave the twist_factor out, or choose another model";
  if (spec.fibre.relaxation_time != 0)
    return "masses and springs don't resist the rates of bends; the relaxation_time must be 0";
  if (spec.fibre.joint_limit) return "masses and springs have no limits of joints; leave the joint_limit out";
  return {};
}

}  // namespace

std::unique_ptr<MassSpringBody> mass_spring_strand(const std::string& name, const StrandStart& start,
                                                   const Description& description) {
  check_start(name, start);
  const ForceOptions options{description.geometric_term.value_or(row_of(description.method).usual_term()),
                             description.bend_product,
                             description.gravity,
                             description.drag,
                             description.wind,
                             description.point_forces,
                             description.preconditioner};
  const StepMethod& step = description.mesh ? kLinkedImplicitEuler : *row_of(description.method).springs;
  return std::make_unique<MassSpringBody>(start, step, options, !description.obstacles.empty(),
                                          description.watched);
}

ModelRow mass_spring_model() {
  return {.id = "mass_spring",
          .coordinates = kPositions,
          .exercises = [](const StrandSpec& spec) { return exercises_of(discretise(spec)); },
          .calls_method = true,
          .why_not = springs_why_not,
          .points = [](const StrandSpec& spec) { return spec.elements + 1L; },
          .make = [](const StrandSpec& spec, const Description& description) -> std::unique_ptr<Body> {
            if (const std::string why = springs_why_not(spec); !why.empty()) throw std::invalid_argument(why);
            return mass_spring_strand("a strand", discretise(spec), description);
          },
          .moves_by = [](const MethodRow& /*row*/) { return true; }};
}

}  // namespace hair
