// H7: rigid links. The contract is in hair/rigid_links.h, the text in exercises/H7/text.md.

#include "hair/rigid_links.h"

#include "solver/not_implemented.h"

namespace hair {

void outward_velocities(const std::vector<Link>& /*links*/, Input /*rates*/,
                        std::vector<LinkPass>& /*passes*/) {
  throw NotImplemented("H7 outward_velocities");
}

void inward_inertias(const std::vector<Link>& /*links*/, Input /*Q*/, std::vector<LinkPass>& /*passes*/) {
  throw NotImplemented("H7 inward_inertias");
}

void outward_accelerations(const std::vector<Link>& /*links*/, Input /*Q*/, std::vector<LinkPass>& /*passes*/,
                           Output /*accelerations*/) {
  throw NotImplemented("H7 outward_accelerations");
}

}  // namespace hair
