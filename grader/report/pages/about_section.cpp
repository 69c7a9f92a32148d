// STAFF ONLY. Writes the class page's section with the answers of about.txt.
#include <algorithm>
#include <map>

#include "grader/report/facts/about.h"
#include "grader/report/facts/class_statistics.h"
#include "grader/report/facts/columns.h"
#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"
#include "grader/text/letters.h"
#include "solver/timing.h"

namespace grader::inline report {
namespace {

// Sorts answers by their text, so that their order does not show the authors.
Html answers(const char* question, std::vector<std::string> texts) {
  std::erase(texts, "");
  std::ranges::sort(texts);
  Html items;
  for (const std::string& text : texts) items += html("<li>{}</li>\n", {text});
  return folded(html("{}:", {question}), texts.size(), html("<ul>\n{}</ul>\n", {items}));
}

// Returns "H6 12, H4 5": the exercises that answers name, the most frequent first.
std::string named_exercises(const std::vector<std::string>& texts,
                            const std::vector<SubmissionResult>& results) {
  std::vector<std::pair<std::size_t, std::string>> counts;
  for (const Column& column : columns_of(results)) {
    const auto count = static_cast<std::size_t>(
        std::ranges::count_if(texts, [&](const std::string& text) { return has_word(text, column.id); }));
    if (count > 0) counts.emplace_back(count, column.id);
  }
  std::ranges::stable_sort(counts, std::greater(), [](const auto& one) { return one.first; });
  std::string line;
  for (const auto& [count, id] : counts)
    line += (line.empty() ? "" : ", ") + id + " " + std::to_string(count);
  return line;
}

}  // namespace

Html about_section(const std::vector<SubmissionResult>& results) {
  std::vector<std::string> hours, hardest, unclear;
  std::vector<double> numbers;
  std::map<std::string, std::size_t> handouts;
  std::size_t people = 0;
  for (const SubmissionResult& result : results) {
    const About about = read_about(result.about);
    if (!about.handout.empty()) ++handouts[about.handout];
    if (about.hours.empty() && about.hardest.empty() && about.unclear.empty()) continue;
    ++people;
    hours.push_back(about.hours);
    hardest.push_back(about.hardest);
    unclear.push_back(about.unclear);
    if (const std::optional<double> number = hours_of(about)) numbers.push_back(*number);
  }
  if (people == 0 && handouts.size() < 2) return {};
  Html lines;
  if (!numbers.empty())
    lines += html("<p>Hours: median {}, from {} to {}.</p>\n",
                  {shown_points(timing::median(numbers)), shown_points(std::ranges::min(numbers)),
                   shown_points(std::ranges::max(numbers))});
  if (const std::string named = named_exercises(hardest, results); !named.empty())
    lines += html("<p>Named as the hardest: {}.</p>\n", {named});
  if (handouts.size() > 1) {
    std::string versions;
    for (const auto& [version, count] : handouts)
      versions += (versions.empty() ? "" : ", ") + version + " (" + std::to_string(count) + ")";
    lines += html("<p>Made with several handouts: {}.</p>\n", {versions});
  }
  lines += answers("Hours", hours);
  lines += answers("Hardest", hardest);
  lines += answers("Unclear", unclear);
  return html(
      "<section id=\"about\">\n<h2>What people say</h2>\n<p class=\"quiet\">{} of {} answered about.txt. No "
      "name stands beside an answer.</p>\n{}</section>\n",
      {people, results.size(), lines});
}

}  // namespace grader::report
