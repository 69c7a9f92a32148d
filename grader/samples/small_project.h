// STAFF ONLY. Makes a project of two exercises and one sample, in the running test's own folder.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace grader::inline samples {

namespace fs = std::filesystem;

// Belongs to this test alone: others run at the same time.
inline fs::path scratch(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return fs::path(testing::TempDir()) / ("make_samples_test_" + std::string(test->name()) + "_" + name);
}

inline constexpr const char* kExercises = R"json({"exercises": [
    {"id": "A", "title": "a", "file": "a.cpp", "functions": ["a()"], "header": "a.h", "prerequisites": [], "libraries": [], "points": 5, "role": "assigned"},
    {"id": "B", "title": "b", "file": "b.cpp", "functions": ["b()"], "header": "b.h", "prerequisites": [], "libraries": [], "points": 5, "role": "assigned"}]})json";

// Makes a project with two exercises and one sample, whose edit turns "one" to "two" in text `source`.
inline fs::path small_project(const std::string& source) {
  const fs::path project = scratch("project");
  const fs::path samples = project / "grader/samples/groups";
  fs::remove_all(project);
  for (const char* folder : {"grader/samples/groups", "handout/exercises/A", "handout/exercises/B",
                             "reference/A/right", "reference/B"})
    fs::create_directories(project / folder);
  std::ofstream(project / "handout" / "exercises.json") << kExercises;
  std::ofstream(project / "handout/exercises/A/categories.json")
      << R"([{"id": "One", "title": "The first", "points": 2, "asks": ""},
             {"id": "Two", "title": "The second", "points": 3, "asks": ""}])";
  std::ofstream(project / "handout/exercises/B/categories.json")
      << R"([{"id": "One", "title": "The first", "points": 5, "asks": ""}])";
  std::ofstream(project / "handout/exercises/B/b.cpp") << "stub\n";
  std::ofstream(project / "reference/B/b.cpp") << "reference\n";
  std::ofstream(project / "reference/A/right/plain.cpp") << source;
  std::ofstream(samples / "bugs.samples")
      << "title Bugs\n\nsample bug\nshows A bug.\nform folder\nfile plain a.cpp\n"
         "fails A One\nedit\n-one\n+two\n";
  return project;
}

// Adds a group with one sample, which has these further lines. They begin in line 4.
inline void add_sample(const fs::path& project, const std::string& name, const std::string& lines,
                       const std::string& group = "more") {
  std::ofstream(project / "grader/samples/groups" / (group + ".samples"))
      << "title More\nsample " << name << "\nshows It.\n"
      << lines;
}

inline const std::string kAttack = "place start\nfence A wall.\nmost A 2\nseconds 1.5\n";

}  // namespace grader::samples
