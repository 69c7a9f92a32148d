#include <algorithm>
#include <stdexcept>
#include <string>

#include "hair/rigid_links/rigid_links_body.h"
#include "hair/simulation/models.h"

namespace hair {

namespace {

struct LinkStep {
  Method method;
  TreeStep step;
};
constexpr LinkStep kLinkSteps[] = {{Method::symplectic_euler, &TreeSteps::symplectic_euler},
                                   {Method::runge_kutta_4, &TreeSteps::runge_kutta_4},
                                   {Method::implicit_euler, &TreeSteps::linearly_implicit_euler}};

// Null if links don't move by this method.
const TreeStep* step_of(Method method) {
  const auto* row = std::ranges::find(kLinkSteps, method, &LinkStep::method);
  return row == std::end(kLinkSteps) ? nullptr : &row->step;
}

LinkStrand links_of(const StrandSpec& spec, const Description& description) {
  LinkStrand strand = link_strand(spec);
  strand.forces.gravity = description.gravity;
  strand.forces.drag = description.drag;
  strand.forces.wind = description.wind;
  return strand;
}

std::unique_ptr<Body> make_links(const StrandSpec& spec, const Description& description) {
  const MethodRow& method = row_of(description.method);
  const TreeStep* step = step_of(description.method);
  if (!step) {
    std::string others;
    for (const LinkStep& other : kLinkSteps)
      others += (others.empty() ? "" : ", ") + std::string(row_of(other.method).id);
    throw std::invalid_argument(std::string("rigid links don't move by ") + method.id + "; they do by " +
                                others);
  }
  if (!description.obstacles.empty() && method.is_explicit)
    throw std::invalid_argument(std::string("rigid links don't collide with ") + method.id +
                                "; use implicit_euler, or leave the obstacles out");
  return std::make_unique<RigidLinksBody>(links_of(spec, description), spec.root_velocity, *step,
                                          description.watched);
}

}  // namespace

// Turns: the root's position, m, and for each link the rotation vector, rad, from its orientation in the rest
// shape.
ModelRow rigid_links_model() {
  return {.id = "rigid_links",
          .coordinates = 1,
          .exercises = [](const StrandSpec&) { return std::vector<std::string>{"H7"}; },
          .calls_method = false,
          .usual_method = Method::implicit_euler,
          .why_not = why_not_of_links,
          .points = [](const StrandSpec& spec) { return spec.elements + 1L; },
          .make = make_links,
          .moves_by = [](const MethodRow& row) { return step_of(row.method()) != nullptr; }};
}

}  // namespace hair
