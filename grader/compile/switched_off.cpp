// STAFF ONLY. Looks for words in sources and in what the preprocessor makes of them.
#include "grader/compile/switched_off.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

namespace grader {
namespace {

// Lines that end with a backslash are one with the next: a token may go on there.
std::string spliced(const std::string& source) {
  std::string text;
  for (std::size_t i = 0; i < source.size(); ++i) {
    std::size_t end = i + 1;
    while (source[i] == '\\' && end < source.size() &&
           (source[end] == ' ' || source[end] == '\t' || source[end] == '\r'))
      ++end;
    if (source[i] == '\\' && end < source.size() && source[end] == '\n')
      i = end;
    else
      text += source[i];
  }
  return text;
}

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

// Identifiers and numbers, also those in texts.
template <class Use>
void for_words(std::string_view text, Use use) {
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin;
    while (end < text.size() && is_letter(text[end])) ++end;
    if (end > begin && use(text.substr(begin, end - begin), text.substr(end))) return;
    begin = std::max(end, begin + 1);
  }
}

// "__no_sanitize__" is "no_sanitize".
std::string_view without_underlines(std::string_view word) {
  while (word.starts_with('_')) word.remove_prefix(1);
  while (word.ends_with('_')) word.remove_suffix(1);
  return word;
}

bool is_switch(std::string_view word) {
  word = without_underlines(word);
  return word.starts_with("no_sanitize") || word == "no_address_safety_analysis" ||
         word == "disable_sanitizer_instrumentation";
}

bool is_asm(std::string_view word) {
  return without_underlines(word) == "asm";
}

// An attribute or a directive whose text is written to the assembler as it is. Compilers refuse all texts but
// names of their own in others.
bool takes_assembler(std::string_view word) {
  constexpr std::string_view kWords[] = {"section", "alias", "ifunc", "weakref", "symver", "ident", "sccs"};
  return std::ranges::count(kWords, without_underlines(word)) > 0;
}

// A text comes next, in parentheses or not, behind lines that begin with #, or so far away that nobody looks.
bool is_before_text(std::string_view rest) {
  constexpr std::size_t kMostBetween = 500;
  const bool cut = rest.size() > kMostBetween;
  rest = rest.substr(0, kMostBetween);
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\n("), rest.size()));
    if (!rest.starts_with('#')) break;
    rest.remove_prefix(std::min(rest.find('\n'), rest.size()));
  }
  rest.remove_prefix(std::min(rest.find_first_not_of("uUL8R"), rest.size()));
  return rest.empty() ? cut : rest.starts_with('"');
}

// asm volatile("" ...) keeps the compiler from moving code, and holds none.
bool is_empty_asm(std::string_view rest) {
  for (const std::string_view skip : {"volatile", "__volatile__", "__volatile"}) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    if (rest.starts_with(skip)) rest.remove_prefix(skip.size());
  }
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t("), rest.size()));
  if (!rest.starts_with("\"\"")) return false;
  rest.remove_prefix(2);
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  return rest.starts_with(':') || rest.starts_with(')');
}

// "# 12 "conj_grad.cpp" 2": the number and the name; false for any other line.
bool is_marker(const std::string& line, int& number, std::string& file) {
  if (!line.starts_with("# ")) return false;
  std::istringstream in(line.substr(2));
  std::string rest;
  if (!(in >> number) || !std::getline(in, rest)) return false;
  const std::size_t begin = rest.find('"'), end = rest.rfind('"');
  file = begin < end ? rest.substr(begin + 1, end - begin - 1) : "";
  return true;
}

// A line of the source that gives other names or numbers to the lines after it: whose they are can't be told then.
std::optional<SwitchedOff> renamed_lines(const std::string& source) {
  std::istringstream lines(source);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    std::string_view rest = line;
    const auto skip_blanks = [&] {
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t\f\v\r"), rest.size()));
      for (std::size_t end; rest.starts_with("/*") && (end = rest.find("*/", 2)) != std::string_view::npos;) {
        rest.remove_prefix(end + 2);
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t\f\v\r"), rest.size()));
      }
    };
    skip_blanks();
    if (rest.starts_with("*/")) rest.remove_prefix(2);
    skip_blanks();
    if (rest.starts_with("#"))
      rest.remove_prefix(1);
    else if (rest.starts_with("%:"))
      rest.remove_prefix(2);
    else
      continue;
    skip_blanks();
    if (rest.starts_with("line") || (!rest.empty() && std::isdigit(static_cast<unsigned char>(rest[0])) != 0))
      return SwitchedOff{number, "#line"};
  }
  return {};
}

}  // namespace

// Such a word stands in the source, or macros make it of pieces: with ## or with a macro of a header, whose name is a reserved one.
bool may_switch_off(const std::string& source) {
  const std::string text = spliced(source);
  if (text.find("##") != std::string::npos || text.find("%:%:") != std::string::npos) return true;
  bool may = false;
  for_words(text, [&](std::string_view word, std::string_view) {
    const bool reserved = word.size() > 1 && word[0] == '_' &&
                          (word[1] == '_' || std::isupper(static_cast<unsigned char>(word[1])) != 0);
    may = reserved || word.starts_with("EIGEN_") || is_switch(word) || is_asm(word) || takes_assembler(word);
    return may;
  });
  return may;
}

std::optional<SwitchedOff> find_switch(const std::string& source, const std::string& preprocessed,
                                       const std::string& file) {
  const std::string_view whole = preprocessed;
  int number = 0;
  bool own = false;
  std::optional<SwitchedOff> found;
  for (std::size_t begin = 0, end = 0; begin < whole.size() && !found; begin = end + 1, ++number) {
    end = std::min(whole.find('\n', begin), whole.size());
    const std::string line(whole.substr(begin, end - begin));
    if (std::string name; is_marker(line, number, name)) {
      own = name == file;
      --number;
      continue;
    }
    for_words(line, [&](std::string_view word, std::string_view rest) {
      const auto beyond = [&] {
        return whole.substr(end - rest.size());
      };  // its text may stand in later lines
      // No header has such an attribute; many have assembler.
      if (is_switch(word) || (own && is_asm(word) && !is_empty_asm(rest)) ||
          (own && takes_assembler(word) && is_before_text(beyond())))
        found = SwitchedOff{own ? number : 0, std::string(word)};
      return found.has_value();
    });
  }
  if (!found) found = renamed_lines(source);
  return found ? found : renamed_lines(spliced(source));
}

}  // namespace grader
