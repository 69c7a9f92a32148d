// The parts of a scene's JSON, each read by a function of its own. hair/scenes/README.md says what they mean.
// All throw BadInput with the JSON path.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>

#include "hair/io/files/strict_json.h"
#include "hair/scene/scene.h"

namespace hair::json {

// What the readers of parts share.
struct Reading {
  // Reads a groom's file, whose path counts from the scene's folder; none: this scene has no files.
  std::function<std::vector<Eigen::VectorXd>(const JsonValue& file)> groom;

  Scene scene;
  std::map<std::string, std::size_t> motions;  // name -> which of the scene's riders
  long particles = 0;

  // Counts particles before there is memory for them: at most kMostParticles in a scene.
  void expect(const JsonValue& where, long strands, long of_each);

  // Who rides on the motion that `object` names as "moves_with", or nobody.
  Rider* rider(const JsonValue& object);
};

inline constexpr long kMostParticles = 10'000'000;
inline constexpr long kMostFrames = 100'000;
inline constexpr long kMostStates = 1'000'000'000;  // particles times frames

void read_motions(const JsonValue& list, Reading& reading);
void read_obstacles(const JsonValue& list, Reading& reading);
void read_hair(const JsonValue& list, Reading& reading);
void read_groom(const JsonValue& group, Reading& reading);  // of "hair", one with "groom"
void read_toys(const JsonValue& list, Reading& reading);
Toy read_cloth(const JsonValue& object, Reading& reading);  // particles, springs, rows and columns
Look read_look(const JsonValue& object);

// All of it.
Scene scene_of(const JsonDocument& document, const std::filesystem::path& file, Reading reading);

}  // namespace hair::json
