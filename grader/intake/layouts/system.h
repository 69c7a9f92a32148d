// STAFF ONLY. A learning system's names: the files and folders directly in a download identify hand-ins by
// their names. Each system is a row (systems.cpp). Students choose the last part of
// a flat name, and all names below a folder; these must not change the owner.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grader/intake/names/owner.h"

namespace grader::inline intake {

// This is a name directly in a download.
struct NamedPath {
  enum class Kind {
    hand_in,
    text,  // text typed into the system, or its note: the owner handed in, but no exercise file
    made,  // an index by the system, which belongs to nobody
  };
  Kind kind = Kind::hand_in;
  Owner owner = {};
  std::string inside = {};     // is a flat name's own file name
  std::string handed_in = {};  // "2025-03-04 10:15:22"
  int version = 0;             // the highest version of a time counts
  bool late = false;
  std::string doubt = {};              // not empty: why a person should look for the owner
  std::string stem = {};               // is a flat name before the student's part, for a rule about all names
  std::vector<NamedPath> others = {};  // are the other readings of this name
};

// Rates how well an owner in a system's download is known: 2 by number and name (a person's, or a person's
// group's), 1 by one of these.
using KnownOwner = std::function<int(const Owner& owner, std::string_view system)>;
// Takes the reading that is known best. The doubt stays unless that reading is proven.
void settle_readings(NamedPath& named, std::string_view system, const KnownOwner& known);

struct Around {
  std::string folder;    // is the folder or archive around the names
  bool is_said = false;  // by --from: nothing is guessed
};

struct System {
  std::string_view name;     // is for --from
  std::string_view shown;    // is for people
  std::string_view example;  // is an example of its names
  std::optional<NamedPath> (*read)(std::string_view name, bool is_folder, const Around& around);
  void (*settle)(const std::vector<NamedPath*>& names) = nullptr;  // changes them by a rule about all names
  bool files_have_versions = false;  // a version is one file's; else all files of a hand-in share it
};

// Lists systems in the order of guesses.
const std::vector<System>& systems();

// Lists the words that --from takes: "canvas", ..., "folders".
std::vector<std::string> layout_names();

// Returns null if no system has this name.
const System* system_called(std::string_view name);

// This is the answer of the first system that knows the name of one file or folder.
struct Told {
  const System* system;
  NamedPath named;
};
std::optional<Told> told_by_name(std::string_view name, bool is_folder, const KnownOwner& known = {});

std::optional<NamedPath> read_canvas(std::string_view name, bool is_folder, const Around& around);
void settle_canvas(const std::vector<NamedPath*>& names);

}  // namespace grader::intake
