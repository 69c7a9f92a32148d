// A scene: its objects, their motion, its duration. Plain data, read from JSON (hair/scenes/README.md) or
// made by code.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hair/dense/synthesis.h"
#include "hair/head/grow.h"
#include "hair/scene/motion.h"
#include "hair/simulation/description.h"
#include "particles/toys/toy.h"

namespace hair {

using particles::Toy, particles::ToyMethod;

// How the scene is drawn. Only `hairlab` uses it; it has no effect on the motion.
struct Look {
  double width = 1e-4;                        // m, the drawn width of a strand
  Vector3d root_colour = {0.10, 0.05, 0.02};  // linear, 0 to 1
  Vector3d tip_colour = {0.22, 0.12, 0.05};
  Vector3d view = Vector3d(0.35, -1, 0.2);  // from the scene to the camera
  std::optional<Vector3d> look_at = {};     // m; none: the middle of the box of all objects
  bool frame = false;                       // the camera is as near as all objects allow
  double zoom = 1;                          // magnification; above 1 objects may be outside the picture
  int image_width = 1280, image_height = 720;
  bool shadows = true;
  bool fine_hair = false;  // thin strands with tapered tips; else ribbons
  bool links = false;      // unbroken links of the control mesh, between guides that are drawn
};

// Objects that follow a motion: the roots of strands (positions, and frames of clamped strands), and
// obstacles. Poses are relative to the start: at the motion's first key, objects are at the places of their
// description.
struct Rider {
  Motion motion;
  std::vector<int> strands, obstacles;
};

// Drawn strands that replace a group's strands, which are their guides (H10). They have no effect on the
// motion.
struct DenseHair {
  int first = 0;                     // the scene's strand that is the first guide; the others follow it
  SynthesisDescription description;  // `points` are those of the guides' centre lines
  std::optional<Motion> motion;      // the scalp's
};

// Hair that is drawn and does not move on its own: it keeps its shape, and moves with the head.
struct StillHair {
  std::shared_ptr<const Head> head;
  Vector3d at = Vector3d::Zero();  // m, the head's origin at the start
  HairStyle style;
  GrowSettings settings;
  std::optional<Motion> motion;
};

struct Scene {
  std::string name;   // "strand-swing"
  std::string shows;  // one line
  int frames = 1;     // not counting frame 0, the start
  double frames_per_second = 30;
  int steps_per_frame = 8;  // 1 / (frames_per_second * hair.step), which is a whole number
  Description hair;         // without strands there is no hair simulation
  int bald_roots = 0;       // roots of grooms without hair, which are left out
  std::vector<Rider> riders;
  std::vector<Toy> toys;     // particles with springs, rods, wires: for P1 and P2, and for cloth
  std::optional<Look> look;  // none: no pictures
  std::vector<DenseHair> dense;
  std::vector<StillHair> still;
};

// True if there is a hair simulation.
inline bool has_strands(const Scene& scene) {
  return !scene.hair.strands.empty() || !scene.hair.modelled.empty();
}

// Both throw BadInput with file and JSON path: "FILE: hair[0].roots.count: ...". Paths of grooms are relative
// to the scene's folder.
Scene read_scene(const std::filesystem::path& file);

// The same with few strands: it is read in a moment, looks the same and calls the same exercises.
Scene read_outline(const std::filesystem::path& file);

// The same for a text, for a scene without files: rejects a scene that names a groom. Errors name it `name`.
Scene parse_scene(const std::string& text, const std::string& name);

// All keys that a scene can have, with their units, defaults and bounds: tables in Markdown.
std::string scene_keys();

// The exercises whose functions the scene calls, in the order of exercises.json: {"S1", "H1", ...}.
std::vector<std::string> exercises_of(const Scene& scene);

}  // namespace hair
