// STAFF ONLY. Looks for words in sources, before and after the preprocessor.
#include "grader/compile/switched_off.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>
#include <vector>

namespace grader::inline compile {
namespace {

// Joins lines that end with a backslash to the next: a token may go on there.
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

// Visits identifiers and numbers, also those in texts.
template <class Use>
void for_words(std::string_view text, Use use) {
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = begin;
    while (end < text.size() && is_letter(text[end])) ++end;
    if (end > begin && use(text.substr(begin, end - begin), text.substr(end))) return;
    begin = std::max(end, begin + 1);
  }
}

// Makes "no_sanitize" of "__no_sanitize__".
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

// True if the attribute's text is written to the assembler unchanged. In other attributes compilers refuse
// all texts except names that they know.
bool takes_assembler(std::string_view word) {
  constexpr std::string_view kWords[] = {"section", "alias", "ifunc", "weakref", "symver"};
  return std::ranges::count(kWords, without_underlines(word)) > 0;
}

// The text of these directives goes there, too; the preprocessor leaves them unchanged.
bool is_directive_for_assembler(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  if (!line.starts_with('#')) return false;
  line.remove_prefix(1);
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  return line.starts_with("ident") || line.starts_with("sccs");
}

// asm volatile("" ...) keeps the compiler from moving code, and holds no instruction.
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

// Reads the number and the name of "# 12 "conj_grad.cpp" 2"; returns false for any other line.
bool is_marker(const std::string& line, int& number, std::string& file) {
  if (!line.starts_with("# ")) return false;
  std::istringstream in(line.substr(2));
  std::string rest;
  if (!(in >> number) || !std::getline(in, rest)) return false;
  const std::size_t begin = rest.find('"'), end = rest.rfind('"');
  file = begin < end ? rest.substr(begin + 1, end - begin - 1) : "";
  return true;
}

// Reads tokens of preprocessed C++. Texts and characters are skipped, with the brackets in them.
class Tokens {
 public:
  explicit Tokens(std::string_view source) : rest_(source) {}

  std::string_view next() {  // empty: the end
    while (skip_blank() || skip_text('"') || skip_text('\'')) {
    }
    std::size_t end = 0;
    while (end < rest_.size() && is_letter(rest_[end])) ++end;
    if (end > 0 && std::isdigit(static_cast<unsigned char>(rest_[0])) != 0)  // 1'000, but not 1'"'
      while (end + 1 < rest_.size() &&
             (is_letter(rest_[end]) || (rest_[end] == '\'' && is_letter(rest_[end + 1]))))
        ++end;
    if (end == 0) end = rest_.starts_with("<:") || rest_.starts_with(":>") ? 2 : 1;
    const std::string_view token = rest_.substr(0, end);
    rest_.remove_prefix(token.size());
    if (rest_.starts_with('"') && is_raw(token)) skip_raw_text();
    return token;
  }
  std::size_t left() const { return rest_.size(); }

 private:
  static bool is_raw(std::string_view prefix) {
    return prefix == "R" || prefix == "LR" || prefix == "uR" || prefix == "UR" || prefix == "u8R";
  }
  bool skip_blank() {
    const std::size_t size = rest_.size();
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\f\v\r\n"), size));
    return rest_.size() < size;
  }
  bool skip_text(char quote) {  // ends with its line at the latest
    if (!rest_.starts_with(quote)) return false;
    std::size_t end = 1;
    while (end < rest_.size() && rest_[end] != quote && rest_[end] != '\n') end += rest_[end] == '\\' ? 2 : 1;
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return true;
  }
  void skip_raw_text() {  // "x( ... )x"
    const std::size_t open = std::min(rest_.find('('), rest_.size());
    const std::string close = ")" + std::string(rest_.substr(1, open - 1)) + "\"";
    const std::size_t end = rest_.find(close, open);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + close.size());
  }

  std::string_view rest_;
};

// Holds the lines of the student's file in the preprocessed source, and their numbers.
struct OwnLines {
  std::string text;
  std::vector<int> numbers;
};

// Finds such a word in an attribute, __attribute__((...)) or [[...]]. Elsewhere it is a student's name.
std::optional<SwitchedOff> text_for_assembler(const OwnLines& own) {
  int depth = 0;
  std::string_view before;
  Tokens tokens(own.text);
  for (std::string_view token = tokens.next(); !token.empty(); before = token, token = tokens.next()) {
    const bool bracket = token == "[" || token == "<:";
    if (depth == 0) {
      if (token == "(" && without_underlines(before) == "attribute") depth = 1;
      if (bracket && (before == "[" || before == "<:")) depth = 2;
    } else if (token == "(" || bracket) {
      ++depth;
    } else if (token == ")" || token == "]" || token == ":>") {
      --depth;
    } else if (takes_assembler(token)) {
      const auto here = own.text.end() - static_cast<std::ptrdiff_t>(tokens.left() + token.size());
      return SwitchedOff{own.numbers.at(std::count(own.text.begin(), here, '\n')), std::string(token)};
    }
  }
  return {};
}

// Finds a line that gives other names or numbers to the lines after it: then nobody knows whose lines they
// are.
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

// True if the source has such a word, or macros may make one of pieces: with ## or with a reserved macro of a
// header.
bool may_switch_off(const std::string& source) {
  const std::string text = spliced(source);
  if (text.find("##") != std::string::npos || text.find("%:%:") != std::string::npos) return true;
  bool may = false;
  for_words(text, [&](std::string_view word, std::string_view) {
    const bool reserved = word.size() > 1 && word[0] == '_' &&
                          (word[1] == '_' || std::isupper(static_cast<unsigned char>(word[1])) != 0);
    may = reserved || word.starts_with("EIGEN_") || is_switch(word) || is_asm(word) ||
          takes_assembler(word) || word == "ident" || word == "sccs";
    return may;
  });
  return may;
}

std::optional<SwitchedOff> find_switch(const std::string& source, const std::string& preprocessed,
                                       const std::string& file) {
  std::istringstream lines(preprocessed);
  int number = 0;
  bool own = false;
  OwnLines owned;
  std::optional<SwitchedOff> found;
  for (std::string line; !found && std::getline(lines, line); ++number) {
    if (std::string name; is_marker(line, number, name)) {
      own = name == file;
      --number;
      continue;
    }
    if (own) {
      owned.text += line + "\n";
      owned.numbers.push_back(number);
      if (is_directive_for_assembler(line)) found = SwitchedOff{number, "ident"};
    }
    for_words(line, [&](std::string_view word, std::string_view rest) {
      // No header has such an attribute; many have assembler.
      if (is_switch(word) || (own && is_asm(word) && !is_empty_asm(rest)))
        found = SwitchedOff{own ? number : 0, std::string(word)};
      return found.has_value();
    });
  }
  if (!found) found = text_for_assembler(owned);
  if (!found) found = renamed_lines(source);
  return found ? found : renamed_lines(spliced(source));
}

}  // namespace grader::compile
