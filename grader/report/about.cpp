// STAFF ONLY. Reads about.txt.
#include "grader/report/about.h"

#include <array>
#include <charconv>
#include <sstream>

#include "grader/text/letters.h"

namespace grader {
namespace {

struct Question {
  const char* word;
  std::string About::*answer;
};
constexpr std::array<Question, 4> kQuestions = {{{"hours", &About::hours},
                                                 {"hardest", &About::hardest},
                                                 {"unclear", &About::unclear},
                                                 {"handout", &About::handout}}};
constexpr double kMostHours = 1000;
constexpr std::size_t kLongest = 2000;  // of an answer, in bytes

}  // namespace

About read_about(const std::string& text) {
  About about;
  std::string About::*asked = nullptr;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string low = lowered(line);
    const std::size_t colon = line.find(':');
    for (const Question& question : kQuestions)
      if (low.starts_with(question.word) && colon != std::string::npos) {
        asked = question.answer;
        line = line.substr(colon + 1);
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

}  // namespace grader
