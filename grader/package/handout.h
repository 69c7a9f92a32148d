// STAFF ONLY. Makes the students' archive: the files of handout/manifest.txt for a course, in the folder
// hair-assignment/.
#pragma once

#include <filesystem>
#include <string>

#include "grader/course/course.h"
#include "grader/package/gates.h"

namespace grader::inline package {

struct HandoutSources {
  std::filesystem::path root;    // the project's root
  std::filesystem::path golden;  // the build's output for the public checks: <build>/golden
};

// Writes `out`, a .tar.gz; the same sources and course give the same bytes. Writes a temporary file, reads it
// back, and renames it only if it passes all gates. Throws BadInput for a missing source or an `out` that
// can't be written, and HandoutError for a failed gate; then `out` stays unchanged. Returns a remark if the
// texts have no pages, or "".
std::string make_handout(const HandoutSources& sources, const Course& course,
                         const std::filesystem::path& out);

// Writes the list of the whole course's files, handout/packed.txt, after a person has looked at them.
// make_handout compares with it.
void accept_files(const HandoutSources& sources, const Course& course);

// Checks that public pages hold neither the staff's mark nor lines of a solution. Throws HandoutError.
void check_pages(const Files& pages, const HandoutSources& sources, const Course& course);

// Returns the files of the handout, by their paths in it.
Files handout_files(const HandoutSources& sources, const Course& course);

}  // namespace grader::package
