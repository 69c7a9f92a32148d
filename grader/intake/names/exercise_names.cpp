// STAFF ONLY. Finds the exercise file that a name means.
#include "grader/intake/names/exercise_names.h"

#include <algorithm>
#include <array>

namespace grader::inline intake {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

// Returns the letters and digits alone.
std::string skeleton(std::string_view lower) {
  std::string bare;
  for (const char c : lower)
    if (is_digit(c) || (c >= 'a' && c <= 'z')) bare += c;
  return bare;
}

}  // namespace

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  });
  return lower;
}

Numbered without_number(std::string_view name) {
  constexpr std::size_t kMostDigits = 9;
  std::string_view rest = name;
  const bool bracket = rest.ends_with(')');
  if (bracket) rest.remove_suffix(1);
  std::string_view before = rest;
  while (!before.empty() && is_digit(before.back())) before.remove_suffix(1);
  const std::string digits(rest.substr(before.size()));
  if (digits.empty() || digits.size() > kMostDigits || (bracket && !before.ends_with('('))) return {name};
  if (bracket) before.remove_suffix(1);
  if (bracket && before.ends_with(' ')) before.remove_suffix(1);
  return {before, std::stoi(digits), bracket};
}

std::optional<Likeness> exercise_file(std::string_view name, const FileNames& exercise_files) {
  using Degree = Likeness::Degree;
  constexpr std::size_t kLongest = 255;
  if (name.size() > kLongest) return {};
  if (exercise_files.count(name) > 0) return Likeness{std::string(name), Degree::itself, -1};
  const std::string lower = in_lower_case(name);
  const std::size_t dot = lower.find_last_of('.');
  if (dot == std::string::npos || dot == 0) return {};
  const std::string_view ending = std::string_view(lower).substr(dot);
  Numbered copy = without_number(std::string_view(lower).substr(0, dot));
  if (!copy.bracket && !copy.name.ends_with('-')) copy = {std::string_view(lower).substr(0, dot)};
  if (copy.number >= 0 && !copy.bracket) copy.name.remove_suffix(1);
  const std::string renamed = std::string(copy.name) + std::string(ending);
  for (const std::string& file : exercise_files)
    if (in_lower_case(file) == renamed) return Likeness{file, Degree::renamed, copy.number};

  constexpr std::array<std::string_view, 14> kEndings{".cpp", ".cc",  ".cxx",  ".c",   ".h",  ".hpp", ".txt",
                                                      ".pdf", ".doc", ".docx", ".rtf", ".md", ".c++", ".cp"};
  if (std::ranges::find(kEndings, ending) == kEndings.end()) return {};
  std::string bare = skeleton(std::string_view(lower).substr(0, lower.find('.')));
  for (const std::string& file : exercise_files) {
    const std::string wanted = skeleton(in_lower_case(std::string_view(file).substr(0, file.find('.'))));
    // Similar names are "conjgradfinal2", "myconjgrad".
    constexpr std::size_t kMostBeside = 8;
    const std::size_t at = bare.find(wanted);
    if (at != std::string::npos && bare.size() <= wanted.size() + kMostBeside)
      return Likeness{file, Degree::like, -1};
  }
  return {};
}

}  // namespace grader::intake
