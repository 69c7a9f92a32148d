// STAFF ONLY. Divides a source into words and signs.
#include "grader/mutants/words.h"

#include <array>
#include <cctype>
#include <string_view>

namespace grader::inline mutants {
namespace {

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool is_of_name(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Longer ones come first.
constexpr std::array<std::string_view, 22> kSigns = {
    "<<=", ">>=", "...", "->", "++", "--", "<=", ">=", "==", "!=", "&&",
    "||",  "+=",  "-=",  "*=", "/=", "%=", "::", "<<", ">>", "|=", "&="};

std::size_t end_of_sign(const std::string& source, std::size_t at) {
  for (const std::string_view sign : kSigns)
    if (source.compare(at, sign.size(), sign) == 0) return at + sign.size();
  return at + 1;
}

std::size_t end_of_number(const std::string& source, std::size_t at) {
  std::size_t end = at;
  while (end < source.size()) {
    const char c = source[end];
    // 1e-5, 0x1p-5
    const char mark = source.compare(at, 2, "0x") == 0 ? 'p' : 'e';
    const bool of_exponent = (c == '+' || c == '-') && end > at && source[end - 1] == mark;
    if (!is_of_name(c) && c != '.' && c != '\'' && !of_exponent) break;
    ++end;
  }
  return end;
}

// Returns the place behind a comment, a text in quotes or a line of the preprocessor that begins at `at`;
// `at` itself if there is none.
std::size_t behind_what_is_no_code(const std::string& source, std::size_t at) {
  const auto behind = [&](const char* end, std::size_t from) {
    const std::size_t found = source.find(end, from);
    return found == std::string::npos ? source.size() : found + std::string_view(end).size();
  };
  const char c = source[at];
  if (source.compare(at, 2, "//") == 0 || c == '#') return behind("\n", at);
  if (source.compare(at, 2, "/*") == 0) return behind("*/", at + 2);
  if (c != '"' && c != '\'') return at;
  std::size_t end = at + 1;
  while (end < source.size() && source[end] != c) end += source[end] == '\\' ? 2 : 1;
  return end + 1;
}

}  // namespace

std::vector<Word> words_of(const std::string& source) {
  std::vector<Word> words;
  for (std::size_t at = 0; at < source.size();) {
    if (std::isspace(static_cast<unsigned char>(source[at]))) {
      ++at;
      continue;
    }
    if (const std::size_t behind = behind_what_is_no_code(source, at); behind != at) {
      at = behind;
      continue;
    }
    const bool number =
        is_digit(source[at]) || (source[at] == '.' && at + 1 < source.size() && is_digit(source[at + 1]));
    Word word{number ? Word::Kind::number : Word::Kind::sign, "", at};
    std::size_t end = at;
    if (number) {
      end = end_of_number(source, at);
    } else if (is_of_name(source[at])) {
      word.kind = Word::Kind::name;
      while (end < source.size() && is_of_name(source[end])) ++end;
    } else {
      end = end_of_sign(source, at);
    }
    word.text = source.substr(at, end - at);
    words.push_back(word);
    at = end;
  }
  return words;
}

}  // namespace grader::mutants
