// STAFF ONLY. Finds all small changes of a source.
#include "grader/mutants/mutation.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace grader::inline mutants {
namespace {

// A source is divided into words and signs; comments, texts in quotes and lines of the preprocessor are
// skipped.
struct Word {
  enum class Kind { name, number, sign };
  Kind kind;
  std::string text;
  std::size_t at;  // is its first byte in the source
};
using Kind = Word::Kind;

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

// Maps an operator between two values to its replacements.
const std::map<std::string, std::vector<std::string>> kBetween = {
    {"+", {"-"}},        {"-", {"+"}},        {"*", {"/"}},        {"/", {"*"}},        {"<", {"<=", ">"}},
    {">", {">=", "<"}},  {"<=", {"<", ">="}}, {">=", {">", "<="}}, {"==", {"!="}},      {"!=", {"=="}},
    {"&&", {"||"}},      {"||", {"&&"}},      {"+=", {"-=", "="}}, {"-=", {"+=", "="}}, {"*=", {"/=", "="}},
    {"/=", {"*=", "="}}, {"%", {"/"}}};

const std::map<std::string, std::string> kNames = {{"true", "false"},
                                                   {"false", "true"},
                                                   {"min", "max"},
                                                   {"max", "min"},
                                                   {"sin", "cos"},
                                                   {"cos", "sin"},
                                                   {"sqrt", ""},
                                                   {"abs", ""},
                                                   {"head", "tail"},
                                                   {"tail", "head"},
                                                   {"norm", "squaredNorm"},
                                                   {"squaredNorm", "norm"},
                                                   {"break", "continue"},
                                                   {"continue", "break"}};

// Lists names that are easily confused.
const std::map<std::string, std::string> kAlike = {{"x", "v"},
                                                   {"v", "x"},
                                                   {"i", "j"},
                                                   {"j", "i"},
                                                   {"b", "x"},
                                                   {"h", "1"},
                                                   {"rows", "cols"},
                                                   {"cols", "rows"},
                                                   {"A", "A_transposed"},
                                                   {"A_transposed", "A"},
                                                   {"rows_", "cols_"},
                                                   {"cols_", "rows_"}};

bool is_comparison(const std::string& sign) {
  return sign == "<" || sign == ">" || sign == "<=" || sign == ">=" || sign == "==" || sign == "!=";
}

class Mutations {
 public:
  explicit Mutations(const std::string& source) : source_(source), words_(words_of(source)) {}

  std::vector<Mutation> take() {
    int types = 0;  // counts open < of templates
    for (i_ = 0; i_ < words_.size(); ++i_) {
      if (skip_declaration()) continue;
      if (text(i_) == "<" && !is_spaced(i_)) ++types;
      if (types > 0) {
        if (text(i_) == ">") --types;
        if (text(i_) == ">>") types -= 2;
        continue;
      }
      if (words_[i_].kind == Kind::sign) sign();
      if (words_[i_].kind == Kind::number) number();
      if (words_[i_].kind == Kind::name) name();
      if (begins_statement()) statement();
    }
    return std::move(found_);
  }

 private:
  const std::string& text(std::size_t i) const {
    static const std::string none;
    return i < words_.size() ? words_[i].text : none;
  }
  bool is_value_before(std::size_t i) const {
    if (i == 0) return false;
    const Word& before = words_[i - 1];
    return before.kind == Kind::number || (before.kind == Kind::name && before.text != "return") ||
           before.text == ")" || before.text == "]";
  }

  bool is_spaced(std::size_t i) const {
    const auto is_space = [&](std::size_t at) {
      return at < source_.size() && (source_[at] == ' ' || source_[at] == '\n');
    };
    return words_[i].at > 0 && is_space(words_[i].at - 1) && is_space(words_[i].at + words_[i].text.size());
  }

  // True if it is declared there: int a, Matrix* b, Vector<3>& c.
  bool follows_type(std::size_t i) const {
    if (i == 0) return true;
    const Word& before = words_[i - 1];
    if (before.kind == Kind::name) return before.text != "return";
    return (before.text == "*" || before.text == "&" || before.text == ">" || before.text == ">>") &&
           !is_spaced(i - 1);
  }

  void replace(std::size_t i, const std::string& instead, const char* kind) {
    found_.push_back({words_[i].at, words_[i].text.size(), instead, kind});
  }

  // Skips using, namespace, template, ...: nothing that runs.
  bool skip_declaration() {
    static const std::set<std::string> skipped = {"using",         "namespace", "template",
                                                  "static_assert", "struct",    "class"};
    if (words_[i_].kind != Kind::name || !skipped.contains(words_[i_].text)) return false;
    while (i_ < words_.size() && text(i_) != ";" && text(i_) != "{") ++i_;
    return true;
  }

  void sign() {
    const std::string& sign = words_[i_].text;
    if (is_value_before(i_)) {
      // The * and & of types have a space at one side alone, as clang-format writes them.
      if (const auto others = kBetween.find(sign); others != kBetween.end() && is_spaced(i_))
        for (const std::string& other : others->second)
          replace(i_, other, is_comparison(sign) ? "comparison" : "operator");
    } else if (sign == "-" || sign == "!") {
      replace(i_, "", "sign");
    }
    // Changes an index, [i] to [i + 1]. Arguments, as in segment<3>(i), are left to changed constants.
    if (sign == "[" && is_value_before(i_) && text(i_ - 1) != "auto") {
      const std::size_t close = closing(i_, "[", "]");
      const bool declares = text(close + 1) == "=" && text(close + 2) == "{";
      if (close < words_.size() && close > i_ + 1 && !declares)
        found_.push_back({words_[close].at, 0, " + 1", "index"});
    }
    if (sign == ",") arguments();
  }

  // Changes (a, b) to (b, a), if both are names.
  void arguments() {
    const auto alone = [&](std::size_t i) {
      const auto beside = [](const std::string& sign) { return sign == "(" || sign == "," || sign == ")"; };
      return i > 0 && i + 1 < words_.size() && words_[i].kind == Kind::name && beside(text(i - 1)) &&
             beside(text(i + 1));
    };
    if (i_ < 2 || !alone(i_ - 1) || !alone(i_ + 1) || text(i_ - 1) == text(i_ + 1)) return;
    const std::size_t at = words_[i_ - 1].at;
    found_.push_back(
        {at, words_[i_ + 1].at + text(i_ + 1).size() - at, text(i_ + 1) + ", " + text(i_ - 1), "argument"});
  }

  void number() {
    const std::string& number = words_[i_].text;
    const bool whole = number.find_first_not_of("0123456789") == std::string::npos;
    if (text(i_ - 1) == "[" && text(i_ + 1) == "]" && text(i_ + 2) == "=" && text(i_ + 3) == "{") return;
    if (whole) {
      replace(i_, std::to_string(std::stoll(number) + 1), "constant");
      if (number != "0") replace(i_, std::to_string(std::stoll(number) - 1), "constant");
    } else if (std::stod(number) == 0) {
      replace(i_, "1.0", "constant");
    } else {
      replace(i_, (number.find('e') != std::string::npos ? "(1e6 * " : "(2 * ") + number + ")", "constant");
    }
  }

  void name() {
    const std::string& name = words_[i_].text;
    if (name == "if" && text(i_ + 1) == "(") {
      const std::size_t open = i_ + 1, close = closing(open, "(", ")");
      const bool declares =
          source_.substr(words_[open].at, words_[close].at - words_[open].at).find(';') != std::string::npos;
      if (close < words_.size() && !declares)
        found_.push_back(
            {words_[open].at, words_[close].at + 1 - words_[open].at,
             "(!" + source_.substr(words_[open].at, words_[close].at + 1 - words_[open].at) + ")",
             "condition"});
    }
    if (const auto alike = kAlike.find(name);
        alike != kAlike.end() && !follows_type(i_) && text(i_ + 1) != "(")
      replace(i_, alike->second, "name");
    const auto other = kNames.find(name);
    if (other == kNames.end()) return;
    const bool loop = name == "break" || name == "continue";
    if (other->second.empty() && text(i_ - 1) == "::")  // std::abs(x) to (x)
      found_.push_back({words_[i_ - 2].at, words_[i_].at + name.size() - words_[i_ - 2].at, "", "function"});
    else if (!other->second.empty())
      replace(i_, other->second, loop ? "statement" : "function");
  }

  bool begins_statement() const {
    if (i_ == 0 || words_[i_].kind != Kind::name) return false;
    const std::string& before = text(i_ - 1);
    return before == ";" || before == "{" || before == "}" || before == ")" || before == "else";
  }

  // Removes "a.b = c;", "f(a);", "a += b;". Without "return" a program fails to compile, or is all wrong.
  void statement() {
    static const std::set<std::string> kept = {"return", "if",   "for",   "while",  "do",   "else",
                                               "const",  "auto", "throw", "switch", "case", "double",
                                               "int",    "bool", "std",   "Eigen"};
    static const std::set<std::string> second = {
        ".", "[", "=", "+=", "-=", "*=", "/=", "(", "->", "++", "--"};
    if (kept.contains(words_[i_].text) || !second.contains(text(i_ + 1))) return;
    std::size_t end = i_;
    for (int depth = 0; end < words_.size(); ++end) {
      // This is a constructor with a body.
      if (depth == 0 && text(end) == "{" && words_[end - 1].text == ")") return;
      if (depth == 0 && text(end) == ":" && words_[end - 1].text == ")") return;
      if (text(end) == "(" || text(end) == "[" || text(end) == "{") ++depth;
      if (text(end) == ")" || text(end) == "]" || text(end) == "}") --depth;
      if (depth < 0 || (depth == 0 && text(end) == ";")) break;
    }
    if (text(end - 1) == "delete" || text(end - 1) == "default") return;  // declares, and does nothing
    if (text(end) == ";") found_.push_back({words_[i_].at, words_[end].at - words_[i_].at, "", "statement"});
  }

  std::size_t closing(std::size_t open, const char* opens, const char* closes) const {
    int depth = 0;
    for (std::size_t i = open; i < words_.size(); ++i) {
      if (text(i) == opens) ++depth;
      if (text(i) == closes && --depth == 0) return i;
    }
    return words_.size();
  }

  const std::string& source_;
  std::vector<Word> words_;
  std::vector<Mutation> found_;
  std::size_t i_ = 0;
};

}  // namespace

std::vector<Mutation> mutations_of(const std::string& source) {
  return Mutations(source).take();
}

std::vector<Mutation> drawn(std::vector<Mutation> all, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::map<std::string, std::vector<Mutation>> kinds;
  for (Mutation& mutation : all) kinds[mutation.kind].push_back(std::move(mutation));
  // std::shuffle does not serve: its order depends on the library.
  for (auto& [kind, of_kind] : kinds)
    for (std::size_t i = of_kind.size(); i > 1; --i) std::swap(of_kind[i - 1], of_kind[random() % i]);
  std::vector<Mutation> order;
  while (order.size() < all.size())
    for (auto& [kind, of_kind] : kinds) {
      if (of_kind.empty()) continue;
      order.push_back(std::move(of_kind.back()));
      of_kind.pop_back();
    }
  return order;
}

std::string mutated(const std::string& source, const Mutation& mutation) {
  return source.substr(0, mutation.at) + mutation.instead + source.substr(mutation.at + mutation.length);
}

std::string line_of(const std::string& source, const Mutation& mutation) {
  const std::size_t before = source.rfind('\n', mutation.at);
  const std::size_t first = source.find_first_not_of(" \t\n", before == std::string::npos ? 0 : before);
  const std::size_t end = std::min(source.find('\n', first), source.size());
  return source.substr(first, end - first);
}

std::string change_of(const std::string& source, const Mutation& mutation) {
  // Several lines count as one.
  std::string gone;
  for (const char c : source.substr(mutation.at, mutation.length))
    if (c != '\n' && !(c == ' ' && gone.ends_with(' '))) gone += c;
  if (gone.empty()) return "`" + mutation.instead + "` added";
  return mutation.instead.empty() ? "`" + gone + "` left out"
                                  : "`" + gone + "` to `" + mutation.instead + "`";
}

int occurrence_of(const std::string& source, const Mutation& mutation) {
  const std::string change = change_of(source, mutation);
  const std::size_t begin = source.rfind('\n', mutation.at) + 1;  // npos + 1 is 0
  const std::vector<Mutation> all = mutations_of(source);
  return 1 + static_cast<int>(std::ranges::count_if(all, [&](const Mutation& other) {
           return other.at >= begin && other.at < mutation.at && change_of(source, other) == change;
         }));
}

int line_number(const std::string& source, const Mutation& mutation) {
  return 1 + static_cast<int>(
                 std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(mutation.at), '\n'));
}

}  // namespace grader::mutants
