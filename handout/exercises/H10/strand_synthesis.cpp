// H10: strand synthesis. The contract is in hair/strand_synthesis.h, the text in
// exercises/H10/text.md.

#include "hair/strand_synthesis.h"

#include "solver/not_implemented.h"

namespace hair {

std::array<double, 3> root_weights(const std::array<Vector3d, 3>& /*corners*/, const Vector3d& /*root*/) {
  throw NotImplemented("H10 root_weights");
}

void interpolate(const std::array<GuideHair, 3>& /*guides*/, const std::array<double, 3>& /*weights*/,
                 const RootFrame& /*root*/, Output /*child*/) {
  throw NotImplemented("H10 interpolate");
}

void carry_along(Input /*guide*/, GuideFrames& /*frames*/) {
  throw NotImplemented("H10 carry_along");
}

void extrapolate(Input /*guide*/, const GuideFrames& /*frames*/, const Vector3d& /*root*/, double /*spread*/,
                 Output /*child*/) {
  throw NotImplemented("H10 extrapolate");
}

void blend(Input /*arc*/, Input /*at_root*/, Input /*at_tip*/, Output /*child*/) {
  throw NotImplemented("H10 blend");
}

}  // namespace hair
