// Runs a scene: assembles it once, with only the parts that it needs, then advances frame by frame.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hair/linked_guides/control_mesh.h"
#include "hair/scene/scene.h"
#include "hair/strand/body.h"
#include "particles/state.h"

namespace hair {

// Sums and maxima over all strands and toys.
struct FrameMeasures {
  double stretch = 0;                    // the largest |l - l0| / l0 of all segments, springs and rods
  double kinetic = 0, potential = 0;     // J
  Vector3d momentum = Vector3d::Zero();  // kg m/s
  Vector3d angular_momentum = Vector3d::Zero();  // kg m^2/s, about the origin

  double energy() const { return kinetic + potential; }
};

class SceneRun {
 public:
  // Throws std::invalid_argument as Simulation does.
  explicit SceneRun(const Scene& scene);
  ~SceneRun();
  SceneRun(const SceneRun&) = delete;
  SceneRun& operator=(const SceneRun&) = delete;

  // Restarts from the start of `scene`, with its steps, for repeated runs: nothing is assembled again. Only
  // states, root frames, obstacles and steps may differ from the original scene. Work is counted from 0.
  // Throws std::invalid_argument for other particles.
  void restart(const Scene& scene);

  // As Simulation::leave_out: these strands stay where they are.
  void leave_out(std::span<const int> strands);

  // The next step brings all that rides on motions further: to hand(x) in place of x. It is for a page on
  // which somebody drags roots. Planes and capsules follow without a turn.
  void lead(const Way& hand);

  // Advances to the next frame. Returns nothing, or the place of a blow-up: "strand 0, step 17: filter".
  // After a blow-up it stays there and returns the same. Passes on exceptions of stubs.
  std::optional<std::string> advance();

  double time() const;  // s
  int frame() const;    // 0 at the start
  long steps() const;   // since the start, including the one that broke

  // The coordinates of all bodies: strand after strand, then toy after toy. For masses and springs they are
  // positions.
  particles::State state() const;
  std::vector<std::uint32_t> coordinates() const;                      // for each body: ModelRow::coordinates
  particles::State centre_lines(const particles::State& state) const;  // the points of these coordinates
  const std::vector<int>& strands() const;                             // the number of points of each strand
  std::vector<int> sizes() const;                  // a third of the number of coordinates of each strand
  const std::vector<Obstacle>& obstacles() const;  // at their present positions
  const Watch& watch() const;                      // watches the hair
  std::vector<Warning> warnings() const;           // for the hair, then for the toys
  Work work() const;                               // the hair's; for toys the solves and their steps
  const MeshRecord* mesh_record() const;           // null without a control mesh

  // Measures any state of the scene's particles at the present frame. A state from elsewhere is measured with
  // our own forces. The potential energy includes that of a control mesh (Simulation::mesh_energy).
  FrameMeasures measure(const particles::State& state) const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hair
