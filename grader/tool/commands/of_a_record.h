// STAFF ONLY. The options and steps that commands about a course share: its own folder, and its record.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grader/record/record.h"

namespace grader::inline tool {

// A course's own folder has a file course.json. Commands that start there know its parts, so they need no
// options for them.
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

struct OfARecord {
  std::filesystem::path folder;
  std::string hand_in;  // is its name; "" if the course has one
  std::string name;     // names a student
};

// Add the options and the argument that these commands share.
void add_folder(CLI::App& command, OfARecord& options);  // also adds the hand-in
void add_hand_in(CLI::App& command, std::string& hand_in);
void add_name(CLI::App& command, OfARecord& options);
// Adds the place of a comment or a request.
inline constexpr const char* kWhole = "all";
void add_place_of_words(CLI::App& command, std::string& place);

// Throws BadInput, with a way out, for a folder without a record, and for a hand-in that its record lacks.
std::unique_ptr<Record> open_record(const std::filesystem::path& folder, const std::string& hand_in);

// Opens all hand-ins of a record.
std::vector<std::unique_ptr<Record>> open_hand_ins(const std::filesystem::path& folder);

// Returns the hand-in that a name means: a folder's, or, unless grading is blind, a person's name, id or
// e-mail address on the roster or in the download. Throws BadInput if several hand-ins are meant.
std::string hand_in_called(Record& record, const std::string& name);

// Lists hand-ins whose time nobody knows; "" if there are none.
std::string without_time(Record& record, const std::vector<std::string>& names);

// Lets `change` change the record, then makes all files again. If another hairgrade grades into the folder,
// it waits after the change, so that an interruption loses none. Returns hairgrade's exit code.
int change_record(const OfARecord& options,
                  const std::function<void(Record&, const std::string& name)>& change);

}  // namespace grader::tool
