// STAFF ONLY. Limits on a submission, all of its exercises together; or the costs so far.
//
// Each exercise has an equal share: one that needs more takes nothing from another. A share is no grade: an
// exercise that uses up its share ends there, with the points of its other categories. These shares suffice
// on a machine that is ten times as slow as most. An exercise ends far earlier if it takes many times the
// reference's time here (grader/grading/suite_jobs.h).
#pragma once

#include <span>

namespace grader::inline course {

struct Budget {
  double idle_seconds = 40;            // workers that neither compute nor wait for a processor
  double worker_cpu_seconds = 550;     // is the submission's code at run time
  double compiler_cpu_seconds = 1500;  // is compiler and linker, each file twice
  double suite_cpu_seconds = 900;      // is the suite's own time for messages with workers
  double restarts = 75;                // counts workers that crashed or broke the rules
  double messages = 3e7;               // come from workers
  double megabytes = 11000;            // are in these messages
  // This is wall time while workers answer: ten times the longest of an honest submission's exercises, in
  // each share. A busy machine can use it up: then a person looks, and the submission is graded again.
  double wall_seconds = 600;

  bool operator==(const Budget&) const = default;
};

struct BudgetField {
  const char* key;   // in course files and timing.json
  const char* name;  // "idle time"
  double Budget::*value;
  // Bounds a limit by the reference from below, for one exercise. 0: the reference limits nothing here.
  double least = 0;
};

std::span<const BudgetField> budget_fields();

// Returns one of `parts` equal shares.
Budget share_of(const Budget& budget, int parts);

Budget nothing_spent();

// Returns the name of a field over its limit; null if there is none.
const char* used_up(const Budget& spent, const Budget& limit);

}  // namespace grader::course
