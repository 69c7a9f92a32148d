// STAFF ONLY. A grade for a learning system.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "grader/intake/names/owner.h"

namespace grader::inline gradebook {

struct Grade {
  std::string hand_in;  // is the submission's name, and its folder among the reports
  Owner owner;
  std::string system;  // is the layout of the hand-in, see Roster::find
  double points = 0, max_points = 0;
  std::vector<std::pair<std::string, double>> exercises{};  // id, points
  bool excused = false;
  std::string not_final{};             // why, "the clock ended a part of it"; "": it is final
  std::vector<std::string> entered{};  // are cells that gradebooks got so far
};

// Is a file for a learning system.
struct Gradebook {
  std::string csv;
  std::vector<std::string>
      said{};  // for staff, a line each: omissions, effects of the importer, rules without a source
  std::size_t written = 0;                                     // counts its grades
  std::set<std::string> given{};                               // are the hand-ins that these are of
  bool all_entered = true;                                     // false: a person must read the lines
  std::vector<std::pair<std::string, std::string>> entered{};  // hand-in, cell
};

}  // namespace grader::gradebook
