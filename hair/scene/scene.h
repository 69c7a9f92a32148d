// A scene: what there is, how it moves, for how long. Plain data, read from JSON (hair/scenes/README.md says
// how) or made by hand.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hair/scene/motion.h"
#include "hair/simulation/description.h"
#include "particles/toys/toy.h"

namespace hair {

using particles::Toy, particles::ToyMethod;

// How it is drawn. What `hairlab` needs, and nothing that changes how it moves.
struct Look {
  double width = 1e-4;                        // m, of a strand as it is drawn
  Vector3d root_colour = {0.10, 0.05, 0.02};  // linear, 0 to 1
  Vector3d tip_colour = {0.22, 0.12, 0.05};
  Vector3d view = Vector3d(0.35, -1, 0.2);  // from the scene to the camera
  std::optional<Vector3d> look_at = {};     // m; none: the middle of all that there will be to see
  double zoom = 1;                          // times as near; above 1 something may be outside of the picture
  int image_width = 1280, image_height = 720;
  bool shadows = true;
};

// What rides on a motion: the roots of strands (their positions, and the frames of those that are clamped),
// and obstacles. Poses are relative to the start: the motion's first key is where things are in the
// description.
struct Rider {
  Motion motion;
  std::vector<int> strands, obstacles;
};

struct Scene {
  std::string name;   // "strand-swing"
  std::string shows;  // one line
  int frames = 1;     // after the first, which is the start
  double frames_per_second = 30;
  int steps_per_frame = 8;  // 1 / (frames_per_second * hair.step), which is a whole number
  Description hair;         // without strands there is no hair simulation
  std::vector<Rider> riders;
  std::vector<Toy> toys;     // particles with springs, rods, wires: for P1 and P2, and cloth
  std::optional<Look> look;  // none: there is nothing to render
};

// Whether there is a hair simulation.
inline bool has_strands(const Scene& scene) {
  return !scene.hair.strands.empty() || !scene.hair.modelled.empty();
}

// Throw BadInput with file and JSON path: "FILE: hair[0].roots.count: ...". Paths of grooms count from the
// scene's folder.
Scene read_scene(const std::filesystem::path& file);

// The same of text, for a scene without files of its own: one that names a groom is refused. `name` stands
// for the file.
Scene parse_scene(const std::string& text, const std::string& name);

// The exercises whose functions it calls, in the order of exercises.json: {"S1", "H1", ...}.
std::vector<std::string> exercises_of(const Scene& scene);

}  // namespace hair
