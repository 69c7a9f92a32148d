// STAFF ONLY. A project of two exercises and one sample, in the running test's own folder.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace grader {

namespace fs = std::filesystem;

// Of this test alone: others run at the same time.
inline fs::path scratch(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return fs::path(testing::TempDir()) / ("make_samples_test_" + std::string(test->name()) + "_" + name);
}

inline constexpr const char* kExercises = R"json({"exercises": [
    {"id": "A", "title": "a", "file": "a.cpp", "functions": ["a()"], "header": "a.h", "text": "a.md",
     "checks": "a_check.cpp", "prerequisites": [], "libraries": [], "points": 5, "role": "assigned"},
    {"id": "B", "title": "b", "file": "b.cpp", "functions": ["b()"], "header": "b.h", "text": "b.md",
     "checks": "b_check.cpp", "prerequisites": [], "libraries": [], "points": 5, "role": "assigned"}]})json";

// A project with two exercises and one sample, whose edit turns "one" to "two" in a file that reads `source`.
inline fs::path small_project(const std::string& source) {
  const fs::path project = scratch("project");
  const fs::path samples = project / "grader" / "samples";
  fs::remove_all(project);
  fs::create_directories(samples / "solutions/plain");
  for (const char* folder : {"handout/student", "reference"}) fs::create_directories(project / folder);
  std::ofstream(project / "handout" / "exercises.json") << kExercises;
  std::ofstream(project / "categories.json") << R"({
    "A": [{"name": "One", "title": "The first", "points": 2}, {"name": "Two", "title": "The second", "points": 3}],
    "B": [{"name": "One", "title": "The first", "points": 5}]})";
  std::ofstream(project / "handout" / "student" / "b.cpp") << "stub\n";
  std::ofstream(project / "reference" / "b.cpp") << "reference\n";
  std::ofstream(samples / "solutions" / "plain" / "a.cpp") << source;
  std::ofstream(samples / "bugs.samples")
      << "title Bugs\n\nsample bug\nshows A bug.\nform folder\nfile plain a.cpp\n"
         "fails A One\nedit\n-one\n+two\n";
  return project;
}

// Adds a group with one sample, which has these further lines. They begin in line 4.
inline void add_sample(const fs::path& project, const std::string& name, const std::string& lines,
                       const std::string& group = "more") {
  std::ofstream(project / "grader" / "samples" / (group + ".samples"))
      << "title More\nsample " << name << "\nshows It.\n"
      << lines;
}

inline const std::string kAttack = "place start\nfence A wall.\nmost A 2\nseconds 1.5\n";

}  // namespace grader
