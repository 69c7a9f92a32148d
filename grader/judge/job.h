// STAFF ONLY. A job for hairsuite or hairstudy, which they read as JSON from standard input; the keys are
// these fields. grader/result/suite_result.h has the results.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "grader/course/budget.h"
#include "grader/course/isolation.h"

namespace grader::inline judge {

// See whole_run.h. Not in SuiteJob, where clang 14 has no std::optional::emplace() for such a struct.
struct WholeRunJob {
  std::filesystem::path scene;
  std::string seed;
  std::filesystem::path runner;  // see grader/judge/run/play.h
  int cpu_seconds = 10;

  bool operator==(const WholeRunJob&) const = default;
};

struct SuiteJob {
  std::string exercise;  // or "runs": all exercises together, for hairstudy
  std::string seed;
  std::filesystem::path kit;
  std::vector<std::string> provided;           // exercises whose functions the suite provides (provided.h)
  std::vector<std::filesystem::path> objects;  // in loading order
  std::filesystem::path log;
  Isolation isolation = Isolation::namespaces;
  int cpu_seconds = 10;
  Budget allowance = {};
  std::optional<std::filesystem::path> pictures = {};  // holds the reference's pictures; empty: no pictures

  std::optional<WholeRunJob> whole_run = {};  // for an exercise with one

  // This is the title of a category that is asked alone, to write its first failing case (reproduction.h);
  // "": all are asked.
  std::string reproduce = {};
  std::filesystem::path exercises = {};  // is exercises.json, for `reproduce`

  // Only hairstudy reads these, see study/study.h.
  std::set<std::string> left_out = {};
  std::map<std::string, std::string> unavailable = {};
  std::vector<std::filesystem::path> reference_objects = {};
  std::filesystem::path motions = {};  // holds true motions

  bool operator==(const SuiteJob&) const = default;
};

std::string to_json(const SuiteJob& job);  // one line
// Throws BadInput for a text that is no job; errors name it `name`.
SuiteJob suite_job_from_json(const std::string& text, const std::string& name);

}  // namespace grader::judge
