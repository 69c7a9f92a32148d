// STAFF ONLY. The archive that students get: handout/manifest.txt's files for a course, in the folder
// hair-assignment/.
#pragma once

#include <filesystem>

#include "grader/course/course.h"
#include "grader/package/gates.h"

namespace grader {

struct HandoutSources {
  std::filesystem::path root;    // the project's
  std::filesystem::path golden;  // what the build made for the public checks: <build>/golden
};

// Writes `out`, a .tar.gz; the same sources and course give the same bytes. It is written under a temporary
// name, read back, and renamed only after it has passed the gates. Throws BadInput for a source that is
// missing or an `out` that can't be written, HandoutError for a gate that closes; then `out` is left as it
// was.
void make_handout(const HandoutSources& sources, const Course& course, const std::filesystem::path& out);

// The files of the handout, by their paths in it.
Files handout_files(const HandoutSources& sources, const Course& course);

// The exercise's row in the table of assignment/README.md.
std::string index_row(const Exercise& exercise);

}  // namespace grader
