// STAFF ONLY. Reads about.txt.
#include "grader/report/facts/about.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

#include "grader/text/letters.h"

namespace grader::inline report {
namespace {

struct Question {
  const char *whole, *word;  // the question of the handout, and its shortest form
  std::string About::*answer;
};
constexpr std::array<Question, 3> kQuestions = {
    {{"hours of work, about", "hours", &About::hours},
     {"hardest exercise, and why", "hardest", &About::hardest},
     {"unclear in texts, headers or checks", "unclear", &About::unclear}}};
constexpr double kMostHours = 1000;
constexpr std::size_t kLongest = 2000;  // bounds an answer, in bytes

bool is_version(const std::string& text) {
  return text.size() == 8 && text.find_first_not_of("0123456789abcdef") == text.npos;
}

}  // namespace

About read_about(const std::string& text) {
  About about;
  std::string About::*asked = nullptr;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = std::min(line.find(':'), line.size());
    const std::string before = lowered(line.substr(0, colon)),
                      behind = composed(line.substr(std::min(colon + 1, line.size())));
    if (before == "handout" && is_version(behind)) {
      about.handout = behind;
      continue;
    }
    for (const Question& question : kQuestions)
      if (colon < line.size() && (before == question.whole || before == question.word)) {
        asked = question.answer;
        line = behind;
        break;
      }
    if (asked != nullptr) about.*asked += " " + line;
  }
  for (const Question& question : kQuestions)
    about.*question.answer = legible(composed(about.*question.answer), kLongest);
  return about;
}

std::optional<double> hours_of(const About& about) {
  std::string text = about.hours;
  for (char& letter : text)
    if (letter == ',') letter = '.';
  const std::size_t at = text.find_first_of("0123456789");
  if (at == std::string::npos) return {};
  double hours = 0;
  if (std::from_chars(text.data() + at, text.data() + text.size(), hours, std::chars_format::fixed).ec !=
      std::errc())
    return {};
  return hours <= kMostHours ? std::optional(hours) : std::nullopt;
}

}  // namespace grader::report
