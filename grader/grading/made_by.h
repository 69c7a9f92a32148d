// STAFF ONLY. The settings that made a folder of grades. Submissions of one class can be compared only if
// all of them have the same settings.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/grading/suite_jobs.h"

namespace grader::inline grading {

struct MadeBy {
  struct Rule {
    std::string id;
    Role role = Role::assigned;
    double points = 0;  // 0 for an exercise outside the hand-in
    bool operator==(const Rule&) const = default;
  };
  std::vector<Rule> exercises;                // are all exercises, in the course's order
  std::map<std::string, std::string> budget;  // the course's limits by their names; empty: it sets none
  std::string suite;                          // hashes all programs and data that test and judge
  std::string secret;                         // its fingerprint
  Isolation isolation = Isolation::namespaces;
  bool images = true;
  bool partial = false;  // is the course's

  bool operator==(const MadeBy&) const = default;
};

// Describes a run with these settings. `exercise` and `study` are no part of it: they leave out or add, and
// change no points.
MadeBy made_by(const GradingSettings& settings);

std::string to_json(const MadeBy& made_by);
std::optional<MadeBy> made_by_from_json(const std::string& text);  // returns nothing for any other text

struct Difference {
  std::string what;  // "another course file: S2 is worth 10 points there and 15 here"
  std::string way;   // says how `here` becomes like `there`: "use the course file that made it"
};

std::vector<Difference> differences(const MadeBy& there, const MadeBy& here);

}  // namespace grader::grading
