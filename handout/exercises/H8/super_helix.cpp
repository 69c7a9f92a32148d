// H8: super-helices. The contract is in hair/super_helix.h, the text in exercises/H8/text.md.

#include "hair/super_helix.h"

#include "solver/not_implemented.h"

namespace hair {

std::array<double, 8> stumpff(double /*x*/) {
  throw NotImplemented("H8 stumpff");
}

MaterialFrame frame_at(const MaterialFrame& /*start*/, const Vector3d& /*curvature*/, double /*s*/) {
  throw NotImplemented("H8 frame_at");
}

void carry_frames(const MaterialFrame& /*root*/, std::vector<HelixElement>& /*elements*/) {
  throw NotImplemented("H8 carry_frames");
}

void helix_stiffness(const HelixStrand& /*strand*/, Output /*K*/) {
  throw NotImplemented("H8 helix_stiffness");
}

void elastic_force(const HelixStrand& /*strand*/, Input /*q*/, Output /*force*/) {
  throw NotImplemented("H8 elastic_force");
}

HelixJacobian jacobian_at(const MaterialFrame& /*start*/, const Vector3d& /*curvature*/, double /*s*/) {
  throw NotImplemented("H8 jacobian_at");
}

void generalised_force(const std::vector<HelixElement>& /*elements*/,
                       const std::vector<HelixPoint>& /*points*/, Output /*Q*/) {
  throw NotImplemented("H8 generalised_force");
}

void mass_matrix(const std::vector<HelixElement>& /*elements*/, const std::vector<HelixPoint>& /*points*/,
                 Eigen::Ref<Eigen::MatrixXd> /*M*/) {
  throw NotImplemented("H8 mass_matrix");
}

void helix_step(const HelixStrand& /*strand*/, const std::vector<HelixElement>& /*elements*/,
                const std::vector<HelixPoint>& /*points*/, Input /*q*/, Input /*rates*/, double /*h*/,
                Scratch /*scratch*/, Output /*change*/) {
  throw NotImplemented("H8 helix_step");
}

}  // namespace hair
