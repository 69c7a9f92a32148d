// STAFF ONLY. The costs of grading: of each exercise, and of a class.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/budget.h"

namespace grader::inline result {

// This is the cost of an exercise; the only part of a result that differs from run to run. timing.json
// needs only a row in result_fields.cpp for a new member.
struct ExerciseTiming {
  double compile_seconds = 0;  // wall time, including linking; 0 if it came from the cache
  double suite_seconds = 0;    // is wall time
  double worker_cpu_seconds = 0;
  int worker_starts = 0;
  Budget spent = nothing_spent();
  double run_cpu_seconds = 0;      // is the worker's in the whole run
  double picture_cpu_seconds = 0;  // is for drawing and comparing its pictures

  bool operator==(const ExerciseTiming&) const = default;
};

// By exercise, or another part such as a study.
using TimingByExercise = std::map<std::string, ExerciseTiming>;

struct LastRun {
  double wall_seconds = 0;
  int graded = 0, jobs = 0;
  std::string began = {}, ended = {};  // "2025-03-04 10:15:22" (UTC); ended "": it is at work, or was killed
  int asked = 0, done = 0;             // count hand-ins; done: graded, or already done

  bool is_whole() const { return done >= asked && (began.empty() || !ended.empty()); }

  bool operator==(const LastRun&) const = default;
};

struct ClassCosts {
  TimingByExercise reference;
  std::map<std::string, TimingByExercise> submissions;  // by name
  // Lists by submission the exercises that ended by wall time. A person looks at them.
  std::map<std::string, std::vector<std::string>> ended_by_the_clock = {};
  std::optional<LastRun> last_run;

  bool operator==(const ClassCosts&) const = default;
};

// Writes timing.json.
std::string to_json(const ClassCosts& costs);

}  // namespace grader::result
