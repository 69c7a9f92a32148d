// STAFF ONLY. A learning system's names: what it says about a hand-in stands in the names of the files and
// folders directly in a download. Each system is a row (table.cpp), and has a file of its own. Students
// choose the last part of a flat name, and all that is below a folder; nothing there may say whose a hand-in
// is.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grader/intake/owner.h"

namespace grader::inline intake {

// A name directly in a download.
struct NamedPath {
  enum class Kind {
    hand_in,
    text,  // what was typed into the system, or its note of a hand-in: its owner has handed in, and it holds no file of ours
    made,  // by the system, of nobody: an index
  };
  Kind kind = Kind::hand_in;
  Owner owner = {};
  std::string inside = {};     // of a flat name: the file's own name
  std::string handed_in = {};  // "2025-03-04 10:15:22"
  int version = 0;             // the highest of a time counts
  bool late = false;
  std::string doubt = {};  // not empty: why a person should look whose it is
  std::string stem = {};   // of a flat name: all before the student's part, for a rule about all names
  std::vector<NamedPath> others = {};  // the other readings of this name
};

// How well an owner in a system's download is known: 2 by number and name (as a person's, or as a group's of
// theirs), 1 by one of these.
using KnownOwner = std::function<int(const Owner& owner, std::string_view system)>;
// Takes the reading that is known best. The doubt stays unless that is proven.
void settle_readings(NamedPath& named, std::string_view system, const KnownOwner& known);

struct Around {
  std::string folder;    // the name of the folder or archive that the names stand in
  bool is_said = false;  // by --from: nothing is guessed
};

struct System {
  std::string_view name;     // for --from
  std::string_view shown;    // for people
  std::string_view example;  // a name as it gives it
  std::optional<NamedPath> (*read)(std::string_view name, bool is_folder, const Around& around);
  void (*settle)(std::vector<NamedPath*>& names) = nullptr;  // by what all names say together
  bool files_have_versions = false;  // a version is one file's; else it is all files' of a hand-in
};

// In the order in which they are guessed.
const std::vector<System>& systems();

// The word that --from takes: "canvas", ..., "folders".
std::vector<std::string> layout_names();

// Null if no system has this name.
const System* system_called(std::string_view name);

// The answer of the first system that knows the name of one file or folder.
struct Told {
  const System* system;
  NamedPath named;
};
std::optional<Told> told_by_name(std::string_view name, bool is_folder, const KnownOwner& known = {});

std::optional<NamedPath> read_canvas(std::string_view name, bool is_folder, const Around& around);
std::optional<NamedPath> read_moodle(std::string_view name, bool is_folder, const Around& around);
std::optional<NamedPath> read_brightspace(std::string_view name, bool is_folder, const Around& around);
std::optional<NamedPath> read_blackboard(std::string_view name, bool is_folder, const Around& around);
std::optional<NamedPath> read_classroom(std::string_view name, bool is_folder, const Around& around);
std::optional<NamedPath> read_gradescope(std::string_view name, bool is_folder, const Around& around);
std::optional<NamedPath> read_autolab(std::string_view name, bool is_folder, const Around& around);

void settle_canvas(std::vector<NamedPath*>& names);
void settle_moodle(std::vector<NamedPath*>& names);
void settle_brightspace(std::vector<NamedPath*>& names);
void settle_blackboard(std::vector<NamedPath*>& names);
void settle_classroom(std::vector<NamedPath*>& names);

}  // namespace grader::intake
