#include "digest.h"

#include <algorithm>
#include <cstdio>
#include <set>
#include <sstream>

namespace checks {
namespace {

constexpr std::size_t kMostLetters = 160;  // a line is cut after these
constexpr int kMostLines = 6;              // the first failure's message has no more
constexpr std::size_t kMostNames = 300;    // letters for the names of all others

bool is_wrong(const Finding& one) {
  return one.state == Finding::State::failed || one.state == Finding::State::broke_off;
}

std::string count_in_words(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

// Words of an assertion or of a sanitizer, which show how a check broke off, and the hint for them.
struct Ending {
  const char *words, *hint;
};
constexpr const char* kOutside =
    "a place outside of a vector or matrix: a loop's bound, `i + 1` or `i - 1`, the 3 of 3 i, a branch for "
    "another case, or an argument in another's place?";
constexpr Ending kEndings[] = {
    {"Assertion `(i>=0)",
     "a column or a row outside of a matrix, such as `scratch` or memory of your own: its number, or how "
     "many there are?"},
    {"Assertion `row >= 0",
     "an entry (row, column) outside of a matrix: a loop's bound, `i + 1` or `i - 1` at an end, or a number "
     "written out?"},
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
    if (text.find(one.words) != std::string::npos) return one.hint;
  return "";
}

// The lines of a failure, the input first.
std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("check.cpp:") != std::string::npos && line.find(": ") != std::string::npos)
      all.insert(all.begin(), "for " + line.substr(line.find(": ") + 2));  // a SCOPED_TRACE
    else if (!line.empty() && line != "Failed" && line != "Google Test trace:")
      all.push_back(line);
  }
  return all;
}

// The row that names this check, "HasItsOrder/0" as HasItsOrder, or else the first. Null if there is none.
const Row* row_of(const Category& category, const std::string& check) {
  for (const Row& row : category.rows)
    if (std::ranges::find(row.checks, check.substr(0, check.find('/'))) != row.checks.end()) return &row;
  return category.rows.empty() ? nullptr : &category.rows.front();
}

void tell_failure(std::ostream& out, const Asked& asked, const Finding& one, bool full) {
  out << one.full_name() << " (exercises/" << asked.exercise << "/" << one.file << ":" << one.line << ")"
      << (one.state == Finding::State::broke_off ? " broke off:" : ":") << "\n";
  int lines = 0;
  std::string hint = one.hint;
  const Category* category = category_of(asked.categories, one.suite);
  for (const std::string& failure : one.failures) {
    if (hint.empty()) hint = hint_of_place(failure);
    for (const std::string& line : lines_of(failure)) {
      if (!full && ++lines > kMostLines) break;
      const bool cut = !full && line.size() > kMostLetters;
      out << "  " << line.substr(0, cut ? kMostLetters : line.size()) << (cut ? " ..." : "") << "\n";
    }
    if (!full) break;
  }
  if (!hint.empty()) out << "  Hint: " << hint << "\n";
  const Row* row = category == nullptr ? nullptr : row_of(*category, one.name);
  // A crash says where it was; only a row about crashes knows more.
  if (row != nullptr && !row->look.empty() && (one.state == Finding::State::failed || row->id == "crash"))
    out << "  Where to look: " << row->look << "\n";
}

std::string names_of(const std::vector<const Finding*>& findings) {
  std::string names;
  for (const Finding* one : findings) {
    if (names.size() > kMostNames) return names + ", ...";
    names += (names.empty() ? "" : ", ") + one->full_name();
  }
  return names;
}

std::string in_words(double points) {
  std::ostringstream text;
  text << points << (points == 1 ? " point" : " points");
  return text.str();
}

// A category's state: how many checks it has, how many of them fail, and how many wait.
struct Stand {
  std::size_t checks = 0, wrong = 0, waiting = 0;

  Stand(const Asked& asked, const Category& category, const std::vector<Finding>& findings) {
    for (const Finding& one : findings) {
      if (category_of(asked.categories, one.suite) != &category) continue;
      ++checks;
      wrong += is_wrong(one) ? 1 : 0;
      waiting += one.state == Finding::State::waits ? 1 : 0;
    }
  }

  std::string in_words() const {
    if (checks == 0) return "in grading alone";
    if (wrong == checks) return "fails";
    if (wrong > 0) return "fails, " + std::to_string(wrong) + " of " + count_in_words(checks, "check");
    return waiting > 0 ? "waits" : "passes";
  }
};

// Writes one line: the categories that fail, and the points of all others.
void sum_up_categories(std::ostream& out, const Asked& asked, const std::vector<Finding>& findings) {
  std::string failing;
  double passing = 0, waiting = 0, alone = 0;
  for (const Category& category : asked.categories) {
    const Stand stand(asked, category, findings);
    if (stand.wrong > 0)
      failing += (failing.empty() ? "" : "; ") + category.title + ", " + in_words(category.points);
    else
      (stand.checks == 0 ? alone : stand.waiting > 0 ? waiting : passing) += category.points;
  }
  out << (failing.empty() ? "" : "At stake: " + failing + ". ") << "Passing: " << in_words(passing);
  if (waiting > 0) out << "; waiting: " << in_words(waiting);
  if (alone > 0) out << "; in grading alone: " << in_words(alone);
  out << "\n";
}

void tell_categories(std::ostream& out, const Asked& asked, const std::vector<Finding>& findings) {
  out << "points  category\n";
  for (const Category& category : asked.categories) {
    char line[256];
    std::snprintf(line, sizeof line, "%6g  %-44s  %s\n", category.points, category.title.c_str(),
                  Stand(asked, category, findings).in_words().c_str());
    out << line;
  }
}

}  // namespace

std::string digest(const Asked& asked, const std::vector<Finding>& findings, bool full) {
  std::vector<const Finding*> wrong;
  std::set<std::string> needed;
  std::size_t waiting = 0, unasked = 0;
  for (const Finding& one : findings) {
    if (is_wrong(one)) wrong.push_back(&one);
    if (one.state != Finding::State::waits) continue;
    ++waiting;
    if (one.waits_for.empty())
      ++unasked;
    else
      needed.insert(one.waits_for);
  }
  std::ostringstream out;
  if (wrong.empty() && waiting == 0) {
    out << asked.exercise << ": all " << count_in_words(findings.size(), "check") << " pass\n";
    return out.str();
  }
  out << asked.exercise << ": " << findings.size() - wrong.size() - waiting << " of "
      << count_in_words(findings.size(), "check") << " pass";
  if (!wrong.empty()) out << ", " << wrong.size() << " fail";
  if (waiting > 0) out << ", " << waiting << " wait";
  out << "\n";
  for (const Finding* one : wrong) {
    tell_failure(out, asked, *one, full);
    if (!full) break;
    out << "\n";
  }
  if (!full && wrong.size() > 1)
    out << "These fail, too: " << names_of({wrong.begin() + 1, wrong.end()}) << "\n";
  if (!needed.empty()) {
    std::string names;
    for (const std::string& function : needed) names += (names.empty() ? "" : ", ") + function;
    out << "First make " << names << " pass: " << count_in_words(waiting - unasked, "check")
        << (waiting - unasked == 1 ? " waits" : " wait") << " for it\n";
  }
  if (unasked > 0) out << count_in_words(unasked, "check") << " did not run: too many never ended\n";
  if (full)
    tell_categories(out, asked, findings);
  else
    sum_up_categories(out, asked, findings);
  if (!full && !wrong.empty()) out << "All of it: " << asked.program << " --full\n";
  return out.str();
}

}  // namespace checks
