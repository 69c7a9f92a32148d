// STAFF ONLY. What a submission may take of the machine, all of its exercises together; or what it has taken.
//
// Each exercise has an equal share: what one overruns is not taken from another. A share is no grade: an
// exercise that uses up its share ends there, with the points of its other categories. These shares suffice
// on a machine that is ten times as slow as most. An exercise ends far earlier where it takes many times what
// the reference takes here (grader/tool/suite_jobs.h).
#pragma once

#include <span>

namespace grader::inline course {

struct Budget {
  double idle_seconds = 40;            // workers that neither compute nor wait for a processor
  double worker_cpu_seconds = 550;     // the submission's code at run time
  double compiler_cpu_seconds = 1500;  // compiler and linker, each file twice
  double suite_cpu_seconds = 900;      // what the suite spends to converse with workers
  double restarts = 75;                // of workers that crashed or broke the rules
  double messages = 3e7;               // from workers
  double megabytes = 11000;            // in these messages
  // By the clock on the wall, while workers are asked: ten times what the longest of an honest one's
  // exercises takes, in each share. A busy machine can use it up: then a person looks, and the submission is
  // graded again.
  double wall_seconds = 600;

  bool operator==(const Budget&) const = default;
};

struct BudgetField {
  const char* key;      // in course files and timing.json
  const char* name;     // "idle time"
  const char* heading;  // "Idle"
  double Budget::*value;
  // A limit by the reference is this much at least, for one exercise. 0: the reference limits nothing here.
  double least = 0;
};

std::span<const BudgetField> budget_fields();

// One of `parts` equal shares.
Budget share_of(const Budget& budget, int parts);

Budget nothing_spent();

// The name of what is over its limit; null if nothing is.
const char* used_up(const Budget& spent, const Budget& limit);

}  // namespace grader::course
