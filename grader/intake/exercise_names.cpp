// STAFF ONLY. Which exercise file a name means.
#include "grader/intake/exercise_names.h"

#include <algorithm>
#include <array>

namespace grader {
namespace {

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  std::ranges::transform(lower, lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  });
  return lower;
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::string_view without_digits_at_end(std::string_view text) {
  while (!text.empty() && is_digit(text.back())) text.remove_suffix(1);
  return text;
}

// "conj_grad (1)", "conj_grad(1)", "conj_grad-1": the stem of the file that it copies. Others are unchanged.
std::string_view without_copy_number(std::string_view stem) {
  std::string_view rest = stem;
  const bool bracket = rest.ends_with(')');
  if (bracket) rest.remove_suffix(1);
  const std::string_view before = without_digits_at_end(rest);
  if (before.size() == rest.size() || !before.ends_with(bracket ? '(' : '-')) return stem;
  rest = before.substr(0, before.size() - 1);
  if (bracket && rest.ends_with(' ')) rest.remove_suffix(1);
  return rest;
}

// The letters and digits alone.
std::string skeleton(std::string_view lower) {
  std::string bare;
  for (const char c : lower)
    if (is_digit(c) || (c >= 'a' && c <= 'z')) bare += c;
  return bare;
}

}  // namespace

std::optional<Likeness> exercise_file(std::string_view name, const FileNames& exercise_files) {
  using Degree = Likeness::Degree;
  constexpr std::size_t kLongest = 255;
  if (name.size() > kLongest) return {};
  if (exercise_files.count(name) > 0) return Likeness{std::string(name), Degree::itself};
  const std::string lower = in_lower_case(name);
  const std::size_t dot = lower.find_last_of('.');
  if (dot == std::string::npos || dot == 0) return {};
  const std::string_view ending = std::string_view(lower).substr(dot);
  const std::string renamed =
      std::string(without_copy_number(std::string_view(lower).substr(0, dot))) + std::string(ending);
  for (const std::string& file : exercise_files)
    if (in_lower_case(file) == renamed) return Likeness{file, Degree::renamed};

  constexpr std::array<std::string_view, 14> kEndings{".cpp", ".cc",  ".cxx",  ".c",   ".h",  ".hpp", ".txt",
                                                      ".pdf", ".doc", ".docx", ".rtf", ".md", ".c++", ".cp"};
  if (std::ranges::find(kEndings, ending) == kEndings.end()) return {};
  std::string bare = skeleton(std::string_view(lower).substr(0, lower.find('.')));
  for (const std::string& file : exercise_files) {
    const std::string wanted = skeleton(in_lower_case(std::string_view(file).substr(0, file.find('.'))));
    // "conjgradfinal2", "myconjgrad"
    constexpr std::size_t kMostBeside = 8;
    const std::size_t at = bare.find(wanted);
    if (at != std::string::npos && bare.size() <= wanted.size() + kMostBeside)
      return Likeness{file, Degree::like};
  }
  return {};
}

}  // namespace grader
