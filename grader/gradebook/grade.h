// STAFF ONLY. A grade on its way to a learning system.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "grader/intake/owner.h"

namespace grader::inline gradebook {

struct Grade {
  std::string hand_in;  // the submission's name, and its folder among the reports
  Owner owner;
  std::string system;  // the layout that the hand-in came in, see Roster::find
  double points = 0, max_points = 0;
  std::vector<std::pair<std::string, double>> exercises{};  // id, points
  bool excused = false;
  bool not_final = false;              // the clock ended a part of it
  std::vector<std::string> entered{};  // cells that gradebooks got of it so far
};

// A file for a learning system.
struct Gradebook {
  std::string csv;
  std::vector<std::string>
      said{};  // for staff, a line each: what was left out, what the importer may do, rules that no source confirms
  std::size_t written = 0;                                     // grades in it
  bool all_entered = true;                                     // false: a person must look at what is said
  std::vector<std::pair<std::string, std::string>> entered{};  // hand-in, cell
};

}  // namespace grader::gradebook
