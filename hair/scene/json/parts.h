// Reads the parts of a scene's JSON: the keys of each part, and the functions that make it. All throw
// BadInput with the JSON path.
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "hair/linked_guides/make_control_mesh.h"
#include "hair/scene/json/keys.h"
#include "hair/scene/json/roots.h"
#include "hair/scene/scene.h"
#include "hair/simulation/models.h"
#include "hair/strand/strand_spec.h"
#include "particles/toys/toy.h"

namespace hair::json {

inline constexpr long kMostParticles = 10'000'000;
inline constexpr long kMostDensePoints = 50'000'000;  // limits strands that are only drawn
inline constexpr long kMostPoints = 10'000;           // per strand
inline constexpr long kMostFrames = 100'000;
inline constexpr long kMostStates = 1'000'000'000;  // particles times frames

// The data of a group's strands once they are read.
struct GroupRoots {
  int first = 0;                  // its first strand
  int points = 0;                 // per strand; 0: they differ
  const Rider* rider = nullptr;   // the motion that the group follows
  std::vector<RootFrame> listed;  // all of them, if the roots are a list
  bool dense = false;             // it is drawn as dense hair
};

// The common state of the readers.
struct Reading {
  // Reads a groom's file, with a path relative to the scene's folder; empty: this scene has no files.
  std::function<std::vector<Eigen::VectorXd>(const JsonValue& file)> groom;

  Scene scene;
  std::map<std::string, std::size_t> motions;  // name -> index of the scene's riders
  std::vector<int> rows;                       // the first strand of each group
  std::vector<GroupRoots> groups;              // the groups of hair
  long particles = 0;
  long most_particles = kMostParticles;
  long most_strands = kMostDensePoints;  // made per group; further ones are only counted
  long dense_points = 0;                 // points of drawn strands

  // Counts particles before memory is allocated for them: at most `most_particles` in a scene.
  void expect(const JsonValue& where, long strands, long of_each);

  // The number of a group's `count` strands that are made.
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
// Adds one strand. Throws std::invalid_argument if the model can't express it.
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
  SynthesisDescription made;  // without guides and children
  int strands;
  std::size_t rows = 1;
  double gathered = 0.6;  // for clumps
};
void keys_of(Keys& keys, SynthesisText& synthesis);
// Adds dense hair to the last group. scalp: not used if its roots are a list.
void add_synthesis(const JsonValue& object, const SynthesisText& synthesis, GroupScalp scalp,
                   Reading& reading);

// The common keys of all groups of strands.
struct GroupText {
  std::size_t model = 0;  // its row in the table of models
  Fibre fibre;
  bool clamped = true;
  Held start;
  Vector3d root_velocity = Vector3d::Zero();
  std::optional<std::string> moves_with;
  std::optional<SynthesisText> synthesis;
};

void keys_of(Keys& keys, GroupText& group);

// Reads all of a strand specification, except roots, forms, lengths and elements. `object`: the group.
StrandSpec spec_of(const JsonValue& object, const GroupText& group);

// Hair that grows on a head: a groom of a group, or hair that stays still.
const Section& grown_section();
StillHair read_grown(const JsonValue& groom);

struct LinksText {
  MeshSpec spec;
  Neighbours neighbours = Neighbours::rows;
};
void keys_of(Keys& keys, LinksText& links);
void add_links(const JsonValue& object, const LinksText& links,
               Reading& reading);  // between the strands that are there

std::vector<ObjectKind> kinds_of_toys();
void add_toys(const JsonValue& list, Reading& reading);

// A patch of cloth, made of the same particles and springs as hair: the lecture's closing question. It is a
// flat grid of rows x columns particles at equal distances, >= 2 each, between three corners:
//
//   corner ---- across ---- corner + across
//      |
//     down                                       particle (row, column) is number row * columns + column
//      |
//   corner + down
//
// Springs of the given stiffness: along the threads between neighbours (stretch), across the squares (shear),
// and from each particle to the second next along both threads (bend).
struct Cloth {
  int rows, columns;
  Vector3d corner, across, down;  // m
  double area_density;            // kg/m^2; inner particles have the mass of a square, those on edges half
  double stretch, shear, bend;    // N/m, >= 0; 0: no such springs
  double damping;                 // N s/m, of every spring
};

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
