// All forces of guides that a control mesh makes one system: those of each strand, links, and strips.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "hair/linked_guides/control_mesh.h"
#include "hair/linked_guides/frame_torque.h"
#include "hair/static_links.h"
#include "particles/force.h"

namespace hair {

// The state of a control mesh that is held during a step.
struct MeshState {
  std::vector<Matrix3d> frames;  // for each particle
  Eigen::VectorXd largest;       // stretches, for each link
  std::span<const StripContact> contacts;
};

class LinkedForce final : public particles::Force {
 public:
  // roots[l]: the root of the guide of link l's particle a. Keeps references to mesh and state.
  LinkedForce(const ControlMesh& mesh, const MeshState& state, std::vector<int> roots)
      : mesh_(mesh), state_(state), torque_(mesh.links, std::move(roots)) {}

  // Adds the next strand: `size` numbers. Keeps a reference to its force.
  void add_strand(const particles::Force& force, Eigen::Index size);

  // Call this before each step, with the state that the step holds.
  void hold() { torque_.hold(state_.largest); }

  // Adds the forces of links and strips alone, for the energy balance of LinkedGuides.
  void add_mesh_force(Input x, Output f) const;

  double energy(Input x) const override;
  void add_force(Input x, Input v, Output f) const override;
  void add_dfdx(Input x, Input v, Input dx, Output df) const override;
  void add_dfdv(Input x, Input v, Input dv, Output df) const override;

  // The strands' own bands. The solver's iterations handle the mesh's coupling.
  bool add_band(Input x, Input v, double by_dfdx, double by_dfdv, solver::BlockBand& band,
                particles::Scratch work) const override;

 private:
  struct Part {
    const particles::Force& force;
    Eigen::Index first, size;
  };
  const ControlMesh& mesh_;
  const MeshState& state_;
  FrameTorque torque_;
  std::vector<Part> parts_;
};

}  // namespace hair
