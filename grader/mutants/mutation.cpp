// STAFF ONLY.
#include "grader/mutants/mutation.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>

#include "grader/mutants/words.h"

namespace grader {
namespace {

using Kind = Word::Kind;

// What takes the place of an operator between two values.
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

bool is_comparison(const std::string& sign) {
  return sign == "<" || sign == ">" || sign == "<=" || sign == ">=" || sign == "==" || sign == "!=";
}

class Mutations {
 public:
  explicit Mutations(const std::string& source) : source_(source), words_(words_of(source)) {}

  std::vector<Mutation> take() {
    for (i_ = 0; i_ < words_.size(); ++i_) {
      if (skip_declaration()) continue;
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

  void replace(std::size_t i, const std::string& instead, const char* kind) {
    found_.push_back({words_[i].at, words_[i].text.size(), instead, kind});
  }

  // using, namespace, template, ...: nothing that runs.
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
      if (const auto others = kBetween.find(sign); others != kBetween.end())
        for (const std::string& other : others->second)
          replace(i_, other, is_comparison(sign) ? "comparison" : "operator");
    } else if (sign == "-" || sign == "!") {
      replace(i_, "", "sign");
    }
    // An index: [i] to [i + 1], and an argument that follows: segment<3>(i) is the matter of constants.
    if (sign == "[" && is_value_before(i_)) {
      const std::size_t close = closing(i_, "[", "]");
      if (close < words_.size() && close > i_ + 1) found_.push_back({words_[close].at, 0, " + 1", "index"});
    }
  }

  void number() {
    const std::string& number = words_[i_].text;
    const bool whole = number.find_first_not_of("0123456789") == std::string::npos;
    if (whole && text(i_ - 1) == "<" && text(i_ + 1) == ">") return;  // of a type
    if (whole)
      replace(i_, number == "1" ? "2" : std::to_string(std::stoll(number) + 1), "constant");
    else if (number.find('e') != std::string::npos)
      replace(i_, "(1e6 * " + number + ")", "constant");
    else
      replace(i_, "(2 * " + number + ")", "constant");
  }

  void name() {
    const std::string& name = words_[i_].text;
    if (name == "if" && text(i_ + 1) == "(") {
      const std::size_t open = i_ + 1, close = closing(open, "(", ")");
      if (close < words_.size())
        found_.push_back(
            {words_[open].at, words_[close].at + 1 - words_[open].at,
             "(!" + source_.substr(words_[open].at, words_[close].at + 1 - words_[open].at) + ")",
             "condition"});
    }
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

  // "a.b = c;", "f(a);", "a += b;", "return a;" within loops is left: it does not compile, or all is wrong.
  void statement() {
    static const std::set<std::string> kept = {"return", "if",   "for",   "while",  "do",   "else",
                                               "const",  "auto", "throw", "switch", "case", "double",
                                               "int",    "bool", "std",   "Eigen"};
    static const std::set<std::string> second = {
        ".", "[", "=", "+=", "-=", "*=", "/=", "(", "->", "++", "--"};
    if (kept.contains(words_[i_].text) || !second.contains(text(i_ + 1))) return;
    std::size_t end = i_;
    for (int depth = 0; end < words_.size(); ++end) {
      if (text(end) == "(" || text(end) == "[" || text(end) == "{") ++depth;
      if (text(end) == ")" || text(end) == "]" || text(end) == "}") --depth;
      if (depth < 0 || (depth == 0 && text(end) == ";")) break;
    }
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

std::vector<Mutation> some_of(std::vector<Mutation> all, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::map<std::string, std::vector<Mutation>> kinds;
  for (Mutation& mutation : all) kinds[mutation.kind].push_back(std::move(mutation));
  // Not std::shuffle, whose order is each library's own.
  for (auto& [kind, of_kind] : kinds)
    for (std::size_t i = of_kind.size(); i > 1; --i) std::swap(of_kind[i - 1], of_kind[random() % i]);
  std::vector<Mutation> some;
  for (bool more = true; more && some.size() < count;) {
    more = false;
    for (auto& [kind, of_kind] : kinds) {
      if (of_kind.empty() || some.size() == count) continue;
      some.push_back(std::move(of_kind.back()));
      of_kind.pop_back();
      more = true;
    }
  }
  std::ranges::sort(some, {}, [](const Mutation& mutation) { return mutation.at; });
  return some;
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
  // Over several lines: as one.
  std::string gone;
  for (const char c : source.substr(mutation.at, mutation.length))
    if (c != '\n' && !(c == ' ' && gone.ends_with(' '))) gone += c;
  if (gone.empty()) return "`" + mutation.instead + "` added";
  return mutation.instead.empty() ? "`" + gone + "` left out"
                                  : "`" + gone + "` to `" + mutation.instead + "`";
}

int line_number(const std::string& source, const Mutation& mutation) {
  return 1 + static_cast<int>(
                 std::count(source.begin(), source.begin() + static_cast<std::ptrdiff_t>(mutation.at), '\n'));
}

}  // namespace grader
