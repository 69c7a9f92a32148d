// The parts of a scene's JSON: the keys of each, and what makes a part of the scene of them. All throw
// BadInput with the JSON path.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "hair/head/control_mesh.h"
#include "hair/scene/cloth.h"
#include "hair/scene/json/keys.h"
#include "hair/scene/json/scalp.h"
#include "hair/scene/scene.h"
#include "hair/simulation/models.h"

namespace hair::json {

inline constexpr long kMostParticles = 10'000'000;
inline constexpr long kMostDensePoints = 50'000'000;  // of strands that are only drawn
inline constexpr long kMostPoints = 10'000;           // of a strand
inline constexpr long kMostFrames = 100'000;
inline constexpr long kMostStates = 1'000'000'000;  // particles times frames

// What is known of a group's strands once they are read.
struct GroupRoots {
  int first = 0;                  // its first strand
  int points = 0;                 // of each strand; 0: they differ
  const Rider* rider = nullptr;   // what it moves with
  std::vector<RootFrame> listed;  // of a list of roots, all of them
  bool dense = false;             // it is drawn as dense hair
};

// The common state of the readers.
struct Reading {
  // Reads a groom's file, with a path relative to the scene's folder; empty: this scene has no files.
  std::function<std::vector<Eigen::VectorXd>(const JsonValue& file)> groom;

  Scene scene;
  std::map<std::string, std::size_t> motions;  // name -> index of the scene's riders
  std::vector<int> rows;                       // the first strand of each group
  std::vector<GroupRoots> groups;              // of hair
  long particles = 0;
  long most_particles = kMostParticles;
  long most_strands = kMostDensePoints;  // that are made of a group; further ones are only counted
  long dense_points = 0;                 // of strands that are drawn

  // Counts particles before memory is allocated for them: at most `most_particles` in a scene.
  void expect(const JsonValue& where, long strands, long of_each);

  // How many of `count` strands of a group are made.
  int made(long count) const { return static_cast<int>(std::min(count, most_strands)); }

  // The rider of the motion that `object` names as "moves_with", or null for no name.
  Rider* rider(const JsonValue& object, const std::optional<std::string>& moves_with);
};

struct MotionText {
  std::string name;
  std::optional<JsonValue> keys;
};
void keys_of(Keys& keys, MotionText& motion);
void add_motions(const JsonValue& list, Reading& reading);

struct ObstacleText {
  std::optional<JsonValue> plane, sphere, capsule, bust;
  double friction = 0;
  std::optional<std::string> moves_with;
};
void keys_of(Keys& keys, ObstacleText& obstacle);
void add_obstacles(const JsonValue& list, Reading& reading);

std::vector<ObjectKind> kinds_of_hair();
void add_hair(const JsonValue& list, Reading& reading);
// One more strand. Throws std::invalid_argument for one that the model can't express.
void add_strand(const ModelRow& model, const StrandSpec& spec, Description& hair);
const Section& groomed_section();
void add_groomed(const JsonValue& group, Reading& reading);  // a group of "hair" that has "groom"

struct StillText {
  std::optional<JsonValue> groom;
  std::optional<std::string> moves_with;
};
void keys_of(Keys& keys, StillText& still);
void add_still_hair(const JsonValue& list, Reading& reading);

struct SynthesisText {
  SynthesisDescription made;  // but for guides and children
  int strands;
  std::size_t rows = 1;
  double gathered = 0.6;  // of clumps
};
void keys_of(Keys& keys, SynthesisText& synthesis);
// Of the last group. scalp: unless its roots are a list.
void add_synthesis(const JsonValue& object, const SynthesisText& synthesis, GroupScalp scalp,
                   Reading& reading);

struct LinksText {
  MeshSpec spec;
  Neighbours neighbours = Neighbours::rows;
};
void keys_of(Keys& keys, LinksText& links);
void add_links(const JsonValue& object, const LinksText& links,
               Reading& reading);  // between the strands that are there

std::vector<ObjectKind> kinds_of_toys();
void add_toys(const JsonValue& list, Reading& reading);

struct ClothText {
  Cloth cloth;
  std::optional<JsonValue> pinned;
};
void keys_of(Keys& keys, ClothText& cloth);
Toy read_cloth(const JsonValue& object, Reading& reading);  // particles, springs, rows and columns

void keys_of(Keys& keys, Fibre& fibre);
void keys_of(Keys& keys, Held& held);
void keys_of(Keys& keys, Look& look);

// The whole scene.
Scene scene_of(const JsonDocument& document, const std::filesystem::path& file, Reading reading);

}  // namespace hair::json
