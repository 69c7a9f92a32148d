// Runs a scene: assembles it once, with only the parts that it needs, then advances frame by frame.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hair/linked_guides/control_mesh.h"
#include "hair/scene/riding.h"
#include "hair/scene/scene.h"
#include "hair/scene/toy_body.h"
#include "hair/simulation/simulation.h"
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
  void lead(const Way& hand) { hand_ = hand; }

  // Advances to the next frame. Returns nothing, or the place of a blow-up: "strand 0, step 17: filter".
  // After a blow-up it stays there and returns the same. Passes on exceptions of stubs.
  std::optional<std::string> advance();

  double time() const { return frame_ / frames_per_second_; }  // s
  int frame() const { return frame_; }                         // 0 at the start
  long steps() const { return steps_; }  // since the start, including the one that broke

  // The coordinates of all bodies: strand after strand, then toy after toy. For masses and springs they are
  // positions.
  particles::State state() const;
  // For each body: ModelRow::coordinates.
  const std::vector<std::uint32_t>& coordinates() const { return coordinates_; }
  particles::State centre_lines(const particles::State& state) const;  // the points of these coordinates
  const std::vector<int>& strands() const { return strands_; }         // the number of points of each strand
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
  void check_size(const particles::State& all) const;
  // Strand after strand, then toy after toy.
  int bodies() const { return static_cast<int>(strands_.size() + toys_.size()); }
  const Body& body(int i) const;
  void ride(const Scene& scene);  // riders start from the scene's roots and obstacles
  void add_toys(const std::vector<Toy>& toys);
  void step();

  double h_, tolerance_;
  int steps_per_frame_;
  double frames_per_second_;
  std::optional<Simulation> simulation_;  // none without strands
  std::vector<Riding> riding_;
  Way held_, hand_;  // belong to the last step and to the next
  std::vector<std::unique_ptr<ToyBody>> toys_;
  Work toys_work_;
  bool watched_;
  std::string_view solver_;  // hair's: the exercise of its method
  Watch nothing_;            // used without strands
  Watch toys_watch_;
  Eigen::MatrixXd scratch_;                 // shared by the toys, one after the other
  std::vector<Obstacle> still_;             // used without strands: nothing moves them
  std::vector<int> strands_;                // the points of each
  std::vector<std::uint32_t> coordinates_;  // one for each body
  int size_ = 0;
  Eigen::Index mesh_size_ = 0;  // the numbers of strands that a mesh couples
  int frame_ = 0;
  long steps_ = 0;
  std::optional<std::string> trouble_;
};

}  // namespace hair
