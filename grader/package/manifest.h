// STAFF ONLY. handout/manifest.txt: the files that students get. Its form is described at its own top.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/course/course.h"

namespace grader {

struct ManifestLine {
  std::string source;       // from the project's root; "golden/..." is made by the build
  std::string destination;  // from the handout's top
  std::string where;        // "handout/manifest.txt:12", for messages
};

// The lines that hold for the course: not those of its absent exercises. Throws BadInput with file and line
// for one that can't be read, names an unknown exercise, leads out of the project or the handout, or has a
// destination that another one has.
std::vector<ManifestLine> read_manifest(const std::filesystem::path& file, const Course& course);

}  // namespace grader
