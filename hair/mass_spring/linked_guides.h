// Guides of masses and springs that a control mesh makes one system, and its steps by implicit Euler (H4).
//
// In each step: frames of particles and contacts are those of its start (H9); friction changes velocities;
// then one implicit solve for all particles, with links and strips in its matrix, preconditioned by the
// strands' own bands; then each strand's collisions; then links remember how far they were stretched, and
// which broke is recorded.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hair/mass_spring/control_mesh.h"
#include "hair/mass_spring/joint_step.h"
#include "hair/mass_spring/mass_spring_body.h"
#include "hair/mass_spring/step_methods.h"

namespace hair {

// The method of each of these strands. Links carry energy from strand to strand, so they have common books
// (linked_energy.h).
extern const StepMethod kLinkedImplicitEuler;

// Throws std::invalid_argument for a mesh with indices or numbers out of bounds, and for guides that are not
// clamped: their roots have no frame. Keeps references to the strands. watched: the record has the energy
// that goes as links wear, too.
std::unique_ptr<JointStep> linked_guides(std::vector<MassSpringBody*> strands, const ControlMesh& mesh,
                                         bool watched);

}  // namespace hair
