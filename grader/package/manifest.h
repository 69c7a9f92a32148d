// STAFF ONLY. handout/manifest.txt: the list of the students' files. The file itself describes its format.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/course/course.h"

namespace grader::inline package {

// This is a file that ships.
struct ManifestLine {
  std::string source;       // relative to the project's root; "golden/..." comes from the build
  std::string destination;  // relative to the handout's top
  std::string where;        // "handout/manifest.txt:12", for messages
};

// An exercise's right run and a usual mistake's ship as a page that plays them, view.html.
inline const std::string kRuns = "view.json";

// Returns an exercise's file in the handout, "stubs/conj_grad.cpp.stub": the build copies it to student/ if
// it is missing there. Its name is no exercise file's, since a hand-in may hold the whole handout.
std::string stub_of(const Exercise& exercise);

// Returns the files for this course: those of its exercises (exercises.json), and those that the lines of
// root/handout/manifest.txt and the folders in it name. Throws BadInput with file and line for a line that
// can't be parsed, names an unknown exercise or a folder without files, points outside the project or the
// handout, or repeats a destination; and HandoutError for a folder that does not ship as one.
std::vector<ManifestLine> read_manifest(const std::filesystem::path& root, const Course& course);

}  // namespace grader::package
