// STAFF ONLY. A sample's exercise files: copies of the reference, the stubs or a whole solution, with the
// headers beside them inserted, and the sample's edits.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "grader/course/course.h"
#include "grader/samples/sample.h"

namespace grader::inline samples {

// Returns files by path in the archive. `project` is the project's root. Throws BadInput if a file or an
// edit's lines are missing.
std::map<std::string, std::string> solution_files(const Sample& sample, const std::filesystem::path& project);

// This is a sample's file of one exercise.
struct SampleProgram {
  std::string name, source;  // belong to the first sample with this source
  bool right = false;
};

// True for statuses of programs that were compiled and ran. A missing file, a stub, or one that does not
// compile has nothing to check, and things that the sandbox forbids cost nothing outside of it.
bool runs_and_loses_points(const std::string& status);

// Lists the exercise's files of the `wanted` samples, each once: right samples come first. Attacks are left
// out, since they aim at the grader.
std::vector<SampleProgram> programs_of(
    const Exercise& exercise, const std::filesystem::path& project,
    const std::function<bool(const Sample&, const std::string& status)>& wanted);

}  // namespace grader::samples
