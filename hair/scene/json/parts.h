// Readers for the parts of a scene's JSON, one function each. hair/scenes/README.md defines the keys. All
// throw BadInput with the JSON path.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "hair/io/files/strict_json.h"
#include "hair/scene/json/scalp.h"
#include "hair/scene/scene.h"
#include "hair/simulation/models.h"

namespace hair::json {

inline constexpr long kMostParticles = 10'000'000;
inline constexpr long kMostDensePoints = 50'000'000;  // of strands that are only drawn
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
  long dense_points = 0;  // of strands that are drawn

  // Counts particles before memory is allocated for them: at most `most_particles` in a scene.
  void expect(const JsonValue& where, long strands, long of_each);

  // The rider of the motion that `object` names as "moves_with", or null.
  Rider* rider(const JsonValue& object);
};

void read_motions(const JsonValue& list, Reading& reading);
void read_obstacles(const JsonValue& list, Reading& reading);
void read_hair(const JsonValue& list, Reading& reading);
const ModelRow* read_model(const JsonValue& group);  // "model"; if there is none, that of masses and springs
// One more strand. Throws std::invalid_argument for one that the model can't express.
void add_strand(const ModelRow& model, const StrandSpec& spec, Description& hair);
void read_groom(const JsonValue& group, Reading& reading);  // a group of "hair" that has "groom"
void read_still_hair(const JsonValue& list, Reading& reading);
// "synthesis" of the last group. scalp: unless its roots are a list.
void read_synthesis(const JsonValue& group, GroupScalp scalp, Reading& reading);
void read_links(const JsonValue& object, Reading& reading);  // between the strands that are there
void read_toys(const JsonValue& list, Reading& reading);
Toy read_cloth(const JsonValue& object, Reading& reading);  // particles, springs, rows and columns
Look read_look(const JsonValue& object);

// The whole scene.
Scene scene_of(const JsonDocument& document, const std::filesystem::path& file, Reading reading);

}  // namespace hair::json
