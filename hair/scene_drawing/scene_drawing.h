// Draws a scene: its strands, obstacles and toys at the positions of a state, with one camera for all frames.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "hair/linked_guides/control_mesh.h"
#include "hair/render/camera.h"
#include "hair/render/drawing.h"
#include "hair/render/opengl/renderer.h"
#include "hair/render/strand_clearance.h"
#include "hair/scene/scene.h"
#include "particles/state.h"

namespace hair {

// Cells along a solid's longest side: for its surface in pictures, and in pages, which must stay small.
inline constexpr int kCellsOfPicture = 220, kCellsOfPage = 48;

// A scene without a look gets the default one. Calls H10 if the scene has dense hair.
class SceneDrawing {
 public:
  // strands: the number of points of each strand's centre line (SceneRun::strands). cache: a folder where
  // surface nets of heads are kept. Keeps a reference to the scene, which must outlive it.
  SceneDrawing(const Scene& scene, std::vector<int> strands,
               const std::optional<std::filesystem::path>& cache = {}, int cells = kCellsOfPicture);

  RenderSettings settings() const;
  const Camera& camera() const { return camera_; }  // placed by scene_bounds.h
  // The sides of the view. Nothing beyond one of them is visible, and neither is its shadow.
  const std::vector<Plane>& view() const { return view_; }
  const Synthesis& dense(std::size_t group) const { return *dense_.at(group); }  // for a group of dense hair

  // Draws from the positions of all points (strand after strand, then toy after toy) and the obstacles at
  // `time`, s. Throws std::invalid_argument for a state of another size. Not for two threads at a time.
  //
  // Dense hair that is drawn as fine hair is kept out of obstacles (strand_clearance.h); ribbons are drawn as
  // H10 makes them. With Look::links, links of the control mesh are tubes, except broken ones (in `mesh`;
  // null: none is broken) and links of guides that dense hair replaces. In a toy, springs and rods are tubes,
  // particles are balls and wires are rings; cloth is a sheet.
  Drawing at(const particles::State& state, const std::vector<Obstacle>& obstacles, double time,
             const MeshRecord* mesh = nullptr) const;

  void lead(const Way& hand) { hand_ = hand; }  // as SceneRun::lead

  // Counts for the last drawing's dense hair.
  const SynthesisCounts& synthesised() const { return synthesised_; }
  long moved_out() const { return moved_out_; }  // the strands that were moved out of an obstacle

 private:
  Way way(const std::optional<Motion>& motion, double time) const;  // still hair's and dense hair's
  void add_strands(particles::Input x, const std::vector<Obstacle>& obstacles, double time,
                   StrandsDrawing& drawing) const;
  void add_dense(std::size_t group, particles::Input guides, double time, StrandsDrawing& drawing) const;
  void add_still(const StillHair& hair, const Groom& grown, double time, std::uint32_t& id,
                 StrandsDrawing& drawing) const;
  void add_links(particles::Input x, const MeshRecord* mesh, Drawing& drawing) const;
  void add_toy(const Toy& toy, int toy_index, particles::Input x, Drawing& drawing) const;

  const Scene& scene_;
  std::vector<int> strands_;
  Look look_;
  Camera camera_;
  std::vector<std::shared_ptr<const SurfaceMesh>> meshes_;  // for the obstacles that are solids
  double unit_;                                             // m: the height of the visible region
  std::vector<std::unique_ptr<Synthesis>> dense_;           // for each of the scene's groups of dense hair
  std::unique_ptr<StrandClearance> clearance_;              // for dense fine hair; null: there is no obstacle
  std::vector<Groom> still_;                                // for each of the scene's still hair, as it grows
  std::vector<Plane> view_;
  Way hand_;
  mutable SynthesisCounts synthesised_;
  mutable long moved_out_ = 0;
};

}  // namespace hair
