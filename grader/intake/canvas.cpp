// STAFF ONLY.
#include "grader/intake/canvas.h"

#include <algorithm>
#include <cstdlib>

namespace grader {
namespace {

// The number of digits at `at`.
std::size_t digits_at(std::string_view name, std::size_t at) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const auto begin = name.begin() + static_cast<std::ptrdiff_t>(at);
  return static_cast<std::size_t>(std::find_if_not(begin, name.end(), is_digit) - begin);
}

// "conj_grad-1.cpp" is version 1 of "conj_grad.cpp".
void take_version(CanvasName& name, const FileNames& exercise_files) {
  constexpr std::size_t most_digits = 6;
  if (exercise_files.count(name.file) > 0) return;
  const std::size_t dash = name.file.rfind('-');
  if (dash == std::string::npos) return;
  const std::size_t digits = digits_at(name.file, dash + 1);
  const std::string file = name.file.substr(0, dash) + name.file.substr(dash + 1 + digits);
  if (digits == 0 || digits > most_digits || exercise_files.count(file) == 0) return;
  name.version = std::atoi(name.file.c_str() + dash + 1);
  name.file = file;
}

// With the student's name up to `at`; nothing if "_DIGITS_DIGITS_FILE" does not begin there.
std::optional<CanvasName> split_at(std::string_view name, std::size_t at) {
  constexpr std::string_view late = "_LATE";
  const std::size_t first = digits_at(name, at + 1);
  const std::size_t second_at = at + 1 + first;
  if (first == 0 || second_at >= name.size() || name[second_at] != '_') return {};
  const std::size_t second = digits_at(name, second_at + 1);
  const std::size_t file_at = second_at + 1 + second;
  if (second == 0 || file_at + 1 >= name.size() || name[file_at] != '_') return {};
  std::string_view person = name.substr(0, at);
  if (person.ends_with(late)) person.remove_suffix(late.size());
  if (person.empty()) return {};
  return CanvasName{std::string(person) + std::string(name.substr(at, first + 1)),
                    std::string(name.substr(file_at + 1))};
}

}  // namespace

std::optional<CanvasName> canvas_name(std::string_view name, const FileNames& exercise_files) {
  std::optional<CanvasName> any;
  for (std::size_t at = name.find('_'); at != std::string_view::npos; at = name.find('_', at + 1)) {
    std::optional<CanvasName> found = split_at(name, at);
    if (!found) continue;
    take_version(*found, exercise_files);
    if (exercise_files.count(found->file) > 0) return found;
    if (!any) any = found;
  }
  return any;
}

std::optional<CanvasName> canvas_exercise_file(std::string_view name, const FileNames& exercise_files) {
  std::optional<CanvasName> found = canvas_name(name, exercise_files);
  if (found && exercise_files.count(found->file) == 0) found.reset();
  return found;
}

}  // namespace grader
