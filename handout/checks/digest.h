// The findings of an exercise's checks, for a terminal: the first failure in full, the others by name, the categories at stake.
#pragma once

#include <string>
#include <vector>

#include "finding.h"
#include "text_tables.h"

namespace checks {

// A category of the exercise's text, and the checks that foresee its loss.
struct Category {
  std::string title;   // as in the text
  std::string checks;  // patterns as --gtest_filter has them: "BendEnergy.*:*.IsBalanced"; a check is of the
                       // first category that fits
};

// A row of the text's table "what you see | where to look", and the checks that see it when none before them fails.
struct Symptom {
  std::string seen;  // how the row begins, in plain letters
  std::string checks;
};

// True for a name that fits one of the patterns, in which * stands for any letters.
bool fits(const std::string& name, const std::string& patterns);

struct Asked {
  std::string exercise;  // "H2"
  std::string text;      // the path of its text
  std::string program;   // that was started
  std::vector<Category> categories;
  std::vector<Symptom> symptoms;
};

// The first category whose patterns the check fits, or null.
const Category* category_of(const Asked& asked, const Finding& one);

// At most fifteen lines, and a row for each category. With `full`: all failures, each whole.
std::string digest(const Asked& asked, const TextTables& tables, const std::vector<Finding>& findings,
                   bool full);

// A line for each check: its name, its category and the row of "what you see", with tabs between them.
std::string list(const Asked& asked, const std::vector<Finding>& findings);

}  // namespace checks
