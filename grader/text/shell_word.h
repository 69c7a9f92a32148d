// STAFF ONLY. Writes a word of a shell's command.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace grader::inline text {

// Quotes the word, unless it has only letters, digits and signs that mean nothing to a shell.
inline std::string shell_word(const std::string& word) {
  constexpr std::string_view kPlain = "/._-+,=:@";
  const bool is_plain = std::ranges::all_of(word, [&](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || kPlain.find(c) != std::string_view::npos;
  });
  if (is_plain && !word.empty()) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace grader::text
