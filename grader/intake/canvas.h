// STAFF ONLY. Names of files in a download from Canvas, which lie in one folder for all students:
//
//   doejane_12347_678901_conj_grad.cpp          student doejane, whose number is 12347; a file's number; its name
//   doejane_LATE_12347_678902_conj_grad-1.cpp   handed in late, and once more after conj_grad.cpp
//   doejane_12347_678901_handin.zip             an archive; it is a submission by its whole name
#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace grader {

using FileNames = std::set<std::string, std::less<>>;

struct CanvasName {
  std::string student;  // "doejane_12347"
  std::string file;     // "conj_grad.cpp"
  int version = 0;      // 1 for "conj_grad-1.cpp"
};

// Nothing if a name has not this form. `version` is only taken off the names of exercise files.
std::optional<CanvasName> canvas_name(std::string_view name, const FileNames& exercise_files);

// The same, if it is one of an exercise file's.
std::optional<CanvasName> canvas_exercise_file(std::string_view name, const FileNames& exercise_files);

}  // namespace grader
