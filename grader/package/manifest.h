// STAFF ONLY. handout/manifest.txt: the list of the students' files. The file itself describes its format.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/course/course.h"

namespace grader {

struct ManifestLine {
  std::string source;       // relative to the project's root; "golden/..." comes from the build
  std::string destination;  // relative to the handout's top
  std::string where;        // "handout/manifest.txt:12", for messages
};

// The lines for this course, without those of absent exercises. Throws BadInput with file and line for a line
// that can't be parsed, names an unknown exercise, points outside the project or the handout, or repeats a
// destination.
std::vector<ManifestLine> read_manifest(const std::filesystem::path& file, const Course& course);

}  // namespace grader
