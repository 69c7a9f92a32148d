// STAFF ONLY. The files of a course with several hand-ins: a page and a table of people and hand-ins, beside
// the hand-ins' folders.
#pragma once

#include <filesystem>

namespace grader::inline class_folder {

// Does nothing for a record whose hand-in has no name.
void write_course_files(const std::filesystem::path& folder);

}  // namespace grader::class_folder
