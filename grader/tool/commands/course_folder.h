// STAFF ONLY. A course's own folder has a file course.json. Commands that start there know its parts, so they
// need no options for them.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

namespace grader::inline tool {

inline constexpr const char *kCourseFile = "course.json", *kGrades = "grades", *kDownloads = "downloads",
                            *kRoster = "roster.csv", *kHandout = "handout.tar.gz";

// Returns course.json as `hairgrade new-course` writes it.
std::string unwritten_course_file();

inline bool in_course_folder() {
  return std::filesystem::exists(kCourseFile);
}

// The option is a part of the course's folder there, and is required elsewhere.
inline void needed_elsewhere(CLI::Option* option, std::filesystem::path& value, const char* part) {
  if (in_course_folder())
    value = part;
  else
    option->required();
}

// The option is a file of the course's folder, if it is there.
inline void if_there(std::optional<std::filesystem::path>& value, const char* file) {
  if (in_course_folder() && std::filesystem::exists(file)) value = file;
}

}  // namespace grader::tool
