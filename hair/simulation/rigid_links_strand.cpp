#include "hair/simulation/rigid_links_strand.h"

#include <stdexcept>
#include <string>

#include "hair/rigid_links/rigid_links_body.h"
#include "hair/simulation/description.h"

namespace hair {

struct LinkMethod {
  TreeStep step;
};
const LinkMethod kLinkSymplecticEuler{&TreeSteps::symplectic_euler};
const LinkMethod kLinkRungeKutta4{&TreeSteps::runge_kutta_4};
const LinkMethod kLinkImplicitEuler{&TreeSteps::linearly_implicit_euler};

std::vector<std::string> rigid_links_exercises(const StrandSpec&) {
  return {"H7"};
}

std::string rigid_links_why_not(const StrandSpec& spec) {
  return why_not_of_links(spec);
}

bool rigid_links_moves_by(const MethodRow& method) {
  return method.rigid_links != nullptr;
}

LinkStrand links_of(const StrandSpec& spec, const Description& description) {
  LinkStrand strand = link_strand(spec);
  strand.forces.gravity = description.gravity;
  strand.forces.drag = description.drag;
  strand.forces.wind = description.wind;
  return strand;
}

std::unique_ptr<Body> make_rigid_links(const StrandSpec& spec, const Description& description) {
  const MethodRow& method = row_of(description.method);
  if (!rigid_links_moves_by(method)) {
    std::string others;
    for (const MethodRow& row : methods())
      if (rigid_links_moves_by(row)) others += (others.empty() ? "" : ", ") + std::string(row.id);
    throw std::invalid_argument(std::string("rigid links don't move by ") + method.id + "; they do by " +
                                others);
  }
  if (!description.obstacles.empty() && method.is_explicit)
    throw std::invalid_argument(std::string("rigid links don't collide with ") + method.id +
                                "; use implicit_euler, or leave the obstacles out");
  return std::make_unique<RigidLinksBody>(links_of(spec, description), spec.root_velocity,
                                          method.rigid_links->step);
}

}  // namespace hair
