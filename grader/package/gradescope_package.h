// STAFF ONLY. Makes autograder.zip for Gradescope: the project's sources, the staff's secret, and the two
// scripts that the platform runs (grader/package/gradescope): setup.sh once, when it makes the image, and
// run_autograder for each hand-in. It holds no built files, for the image is another system.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "grader/course/course.h"
#include "grader/package/handout.h"

namespace grader::inline package {

struct GradescopePackage {
  std::filesystem::path out;
  std::optional<std::filesystem::path> course, secret;
  std::string hand_in;  // names one of several in a course
  int minutes = 10;     // are the platform's limit for a hand-in
  // Packs the public checks alone, for the days before the deadline: no secret, stubs in the reference's
  // place, and no hidden cases.
  bool checks_only = false;
};

// The same project and secret give the same bytes. Throws BadInput for files that can't be read or written,
// and HandoutError if the public checks' package held lines of the reference; then `out` stays unchanged.
void write_gradescope_package(const HandoutSources& sources, const std::string& secret, const Course& course,
                              const GradescopePackage& package);

// Says in a few lines which settings to choose on the platform.
std::string advice_for_gradescope(const Course& course, int minutes);

}  // namespace grader::package
