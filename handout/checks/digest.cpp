#include "digest.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "hint.h"

namespace checks {
namespace {

constexpr std::size_t kMostLetters = 160;  // of a line
constexpr int kMostLines = 8;              // of the first failure's message
constexpr std::size_t kMostNames = 300;    // letters of the names of all others

bool fits_one(const char* name, const char* pattern, const char* end) {
  if (pattern == end) return *name == '\0';
  if (*pattern == '*')
    return fits_one(name, pattern + 1, end) || (*name != '\0' && fits_one(name + 1, pattern, end));
  return *name == *pattern && fits_one(name + 1, pattern + 1, end);
}

bool is_wrong(const Finding& one) {
  return one.state == Finding::State::failed || one.state == Finding::State::broke_off;
}

std::string count_in_words(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

// The message, line by line, and the hint in it.
struct Message {
  std::vector<std::string> lines;
  std::string hint;
};

// The number behind the last `words` of a line, if there is one.
std::optional<double> number_behind(const std::string& line, const std::string& words) {
  const std::size_t at = line.rfind(words);
  if (at == std::string::npos) return std::nullopt;
  const char* begin = line.c_str() + at + words.size();
  char* end = nullptr;
  const double value = std::strtod(begin, &end);
  return end == begin ? std::nullopt : std::optional(value);
}

// True if the numbers say how often something was done.
bool counts(const std::vector<std::string>& lines) {
  return std::ranges::any_of(lines, [](const std::string& line) {
    for (const char* word : {"steps", "products", "sweeps", "iterations", "evaluations", "calls"})
      if (line.find(word) != std::string::npos) return true;
    return false;
  });
}

std::string hint_of_count(double actual, double expected) {
  if (actual == expected + 1) return "one too many";
  return actual == expected - 1 ? "one too few" : "";
}

// GoogleTest's messages of EXPECT_NEAR, "a evaluates to 2," line by line, and of EXPECT_EQ, "Which is: 2" or the number itself: what
// was got, and what was expected. A plain `product` may be off by a factor.
std::string hint_of_two_values(const std::vector<std::string>& lines, bool product) {
  std::vector<double> near, equal;
  for (const std::string& line : lines) {
    if (const auto value = number_behind(line, " evaluates to ")) near.push_back(*value);
    if (const auto value = number_behind(line, "Which is: "))
      equal.push_back(*value);
    else if (const auto constant = number_behind(line, "  ");
             constant && line.find_first_not_of(" 0123456789.e+-") == std::string::npos)
      equal.push_back(*constant);
  }
  if (near.size() == 3) return hint_of_one(near[0], near[1], product);
  if (equal.size() != 2) return "";
  return counts(lines) ? hint_of_count(equal[0], equal[1]) : hint_of_one(equal[0], equal[1], product);
}

// A check that broke off has these words in it, of an assertion of Eigen's or the library's, or of the sanitizer.
struct Ending {
  const char *words, *told;
};
constexpr const char* kOutside =
    "a place outside of a vector or matrix: a loop's bound, `i + 1` or `i - 1`, the 3 of 3 i, or a branch "
    "for another case?";
constexpr Ending kEndings[] = {
    {"Assertion `(i>=0)",
     "a column or a row outside of a matrix, such as `scratch` or memory of your own: its number, or how "
     "many there are?"},
    {"Assertion `row >= 0",
     "an entry (row, column) outside of a matrix: a loop's bound, or `i + 1` or `i - 1` at an end?"},
    {"RowsAtCompileTime", "a vector of another size than the three numbers of a particle?"},
    {"expr.rows()==1 || expr.cols()==1",
     "a matrix where a vector is due: arguments in another order, or all of `scratch` for a column of it?"},
    {"Assertion `index >= 0", kOutside},
    {"Assertion `startRow >= 0", kOutside},
    {"Assertion '__n < this->size()", kOutside},
    {"-buffer-overflow", kOutside},
    {"using an empty matrix", "the largest or smallest of no numbers?"}};

std::string hint_of_place(const std::string& text) {
  for (const Ending& one : kEndings)
    if (text.find(one.words) != std::string::npos) return one.told;
  return "";
}

Message message_of(const std::string& text, bool product) {
  Message message;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string hint = "hint       = ";
    if (line.starts_with(hint) && message.hint.empty())
      message.hint = line.substr(hint.size());
    else if (line.find("_check.cpp:") != std::string::npos && line.find(": ") != std::string::npos)
      message.lines.push_back("for " + line.substr(line.find(": ") + 2));  // a SCOPED_TRACE
    else if (!line.empty() && line != "Failed" && line != "Google Test trace:")
      message.lines.push_back(line);
  }
  if (message.hint.empty()) message.hint = hint_of_place(text);
  if (message.hint.empty()) message.hint = hint_of_two_values(message.lines, product);
  return message;
}

// The first row that fits the check, or null.
template <class Row>
const Row* first_that_fits(const std::vector<Row>& rows, const Finding& one) {
  const auto found =
      std::ranges::find_if(rows, [&](const Row& row) { return fits(one.full_name(), row.checks); });
  return found == rows.end() ? nullptr : &*found;
}

const Symptom* symptom_of(const Asked& asked, const Finding& one) {
  return first_that_fits(asked.symptoms, one);
}

void tell_failure(std::ostream& out, const Asked& asked, const TextTables& tables, const Finding& one,
                  bool full) {
  out << one.full_name() << " (checks/" << one.file << ":" << one.line << ")"
      << (one.state == Finding::State::broke_off ? " broke off:" : ":") << "\n";
  int lines = 0;
  std::string hint;
  for (const std::string& failure : one.failures) {
    const Message message = message_of(failure, one.suite.ends_with("Energy"));
    if (hint.empty()) hint = message.hint;
    for (const std::string& line : message.lines) {
      if (!full && ++lines > kMostLines) break;
      const bool cut = !full && line.size() > kMostLetters;
      out << "  " << line.substr(0, cut ? kMostLetters : line.size()) << (cut ? " ..." : "") << "\n";
    }
    if (!full) break;
  }
  if (!hint.empty()) out << "  Hint: " << hint << "\n";
  const Symptom* symptom = symptom_of(asked, one);
  if (symptom == nullptr) return;
  // A crash says where it was; only a row about crashes knows more.
  if (one.state == Finding::State::failed || symptom->seen.find("crash") != std::string::npos)
    for (const TextTables::Row& row : tables.symptoms)
      if (row.seen.starts_with(symptom->seen)) out << "  Where to look: " << row.look << "\n";
}

std::string names_of(const std::vector<const Finding*>& findings) {
  std::string names;
  for (const Finding* one : findings) {
    if (names.size() > kMostNames) return names + ", ...";
    names += (names.empty() ? "" : ", ") + one->full_name();
  }
  return names;
}

std::string state_of(const Category& category, const Asked& asked, const std::vector<Finding>& findings) {
  std::size_t all = 0, wrong = 0, waiting = 0;
  for (const Finding& one : findings) {
    if (category_of(asked, one) != &category) continue;
    ++all;
    wrong += is_wrong(one) ? 1 : 0;
    waiting += one.state == Finding::State::waits ? 1 : 0;
  }
  if (wrong > 0)
    return wrong == all ? "fails" : "fails, " + std::to_string(wrong) + " of " + count_in_words(all, "check");
  if (waiting > 0) return "waits";
  return all == 0 ? "" : "passes";
}

void tell_categories(std::ostream& out, const Asked& asked, const TextTables& tables,
                     const std::vector<Finding>& findings) {
  if (asked.categories.empty() || tables.categories.empty()) return;
  out << "points  category\n";
  for (const TextTables::Category& row : tables.categories) {
    const auto category = std::ranges::find(asked.categories, row.title, &Category::title);
    const std::string state = category == asked.categories.end() ? "" : state_of(*category, asked, findings);
    char line[256];
    std::snprintf(line, sizeof line, "%6s  %-44s  %s\n", row.points.c_str(), row.title.c_str(),
                  state.empty() ? "in grading alone" : state.c_str());
    out << line;
  }
}

}  // namespace

const Category* category_of(const Asked& asked, const Finding& one) {
  return first_that_fits(asked.categories, one);
}

bool fits(const std::string& name, const std::string& patterns) {
  std::istringstream all(patterns);
  for (std::string one; std::getline(all, one, ':');)
    if (fits_one(name.c_str(), one.data(), one.data() + one.size())) return true;
  return false;
}

std::string digest(const Asked& asked, const TextTables& tables, const std::vector<Finding>& findings,
                   bool full) {
  std::vector<const Finding*> wrong, waiting;
  std::map<std::string, int> waits_for;
  for (const Finding& one : findings) {
    if (is_wrong(one)) wrong.push_back(&one);
    if (one.state != Finding::State::waits) continue;
    waiting.push_back(&one);
    ++waits_for[one.waits_for];
  }
  std::ostringstream out;
  if (wrong.empty() && waiting.empty()) {
    out << asked.exercise << ": all " << count_in_words(findings.size(), "check") << " pass\n";
    return out.str();
  }
  out << asked.exercise << ": " << findings.size() - wrong.size() - waiting.size() << " of "
      << count_in_words(findings.size(), "check") << " pass";
  if (!wrong.empty()) out << ", " << wrong.size() << " fail";
  if (!waiting.empty()) out << ", " << waiting.size() << " wait";
  out << "\n\n";
  for (const Finding* one : wrong) {
    tell_failure(out, asked, tables, *one, full);
    if (!full) break;
    out << "\n";
  }
  if (!full && wrong.size() > 1)
    out << "These fail, too: " << names_of({wrong.begin() + 1, wrong.end()}) << "\n";
  for (const auto& [function, count] : waits_for) {
    if (function.empty())
      out << count_in_words(static_cast<std::size_t>(count), "check")
          << " did not run: too many never ended\n";
    else
      out << "First make " << function
          << " pass: " << count_in_words(static_cast<std::size_t>(count), "check")
          << (count == 1 ? " waits" : " wait") << " for it\n";
  }
  if (!full && !wrong.empty()) out << "All of it: " << asked.program << " --full\n";
  out << "\n";
  tell_categories(out, asked, tables, findings);
  return out.str();
}

std::string list(const Asked& asked, const std::vector<Finding>& findings) {
  std::string lines;
  for (const Finding& one : findings) {
    const Category* category = category_of(asked, one);
    const Symptom* symptom = symptom_of(asked, one);
    lines += one.full_name() + "\t" + (category == nullptr ? "" : category->title) + "\t" +
             (symptom == nullptr ? "" : symptom->seen) + "\n";
  }
  return lines;
}

}  // namespace checks
