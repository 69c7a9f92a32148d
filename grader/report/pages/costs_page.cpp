// STAFF ONLY. Writes the page with the cost of grading.

#include <algorithm>
#include <utility>
#include <vector>

#include "grader/report/pages/pages.h"
#include "hair/io/plot/page.h"

namespace grader::inline report {
namespace {

using Named = std::pair<std::string, double>;

// The cost is the time that a submission had to wait, in seconds by the wall clock.
double cost_of(const ExerciseTiming& timing) {
  return timing.compile_seconds + timing.suite_seconds;
}

double cost_of(const TimingByExercise& parts) {
  double seconds = 0;
  for (const auto& [part, timing] : parts) seconds += cost_of(timing);
  return seconds;
}

std::string percent_of(double part, double whole) {
  return hair::printed("%.0f", whole > 0 ? std::min(100 * part / whole, 100.0) : 0);
}

// Puts the most expensive first; equal ones are sorted by name.
std::vector<Named> by_cost(const std::map<std::string, double>& costs) {
  std::vector<Named> order(costs.begin(), costs.end());
  std::ranges::stable_sort(order, std::greater(), &Named::second);
  return order;
}

Html cost_cell(double seconds) {
  return html("<td class=\"number\" data-value=\"{}\">{}</td>",
              {std::to_string(seconds), hair::printed("%.2f", seconds)});
}

Html share_cells(double part, double whole) {
  const std::string percent = percent_of(part, whole);
  return html(
      "<td class=\"number\">{} %</td><td><div class=\"share\" aria-hidden=\"true\"><span "
      "style=\"width:{}%\"></span></div></td>",
      {percent, percent});
}

Html table_of(const Html& head, const Html& rows) {
  return html(
      "<div class=\"wide\"><table class=\"class\">\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>\n"
      "</table></div>\n",
      {head, rows});
}

// Writes an average over the submissions that have the part, and beside it the reference's cost.
Html by_part(const ClassCosts& costs, double whole) {
  std::map<std::string, double> sums;
  std::map<std::string, int> counts;
  for (const auto& [name, parts] : costs.submissions)
    for (const auto& [part, timing] : parts) {
      sums[part] += cost_of(timing);
      ++counts[part];
    }
  Html rows;
  for (const auto& [part, sum] : by_cost(sums)) {
    const auto reference = costs.reference.find(part);
    rows +=
        html("<tr><th scope=\"row\">{}</th>{}{}{}</tr>\n",
             {part, cost_cell(sum / counts[part]),
              reference != costs.reference.end() ? cost_cell(cost_of(reference->second)) : html("<td></td>"),
              share_cells(sum, whole)});
  }
  const Html head = html(
      "<th scope=\"col\">Exercise</th><th scope=\"col\" class=\"number\">Seconds, on average</th>"
      "<th scope=\"col\" class=\"number\">The reference</th><th scope=\"col\" class=\"number\">Of all</th>"
      "<th scope=\"col\"></th>");
  return html("<section id=\"parts\">\n<h2>By exercise</h2>\n<p class=\"quiet\">{}</p>\n{}</section>\n",
              {"“study” are the studies.", table_of(head, rows)});
}

Html most_in(const TimingByExercise& parts) {
  const auto most =
      std::ranges::max_element(parts, {}, [](const auto& part) { return cost_of(part.second); });
  if (most == parts.end()) return html("<td></td>");
  return html("<td>{}, {} %</td>", {most->first, percent_of(cost_of(most->second), cost_of(parts))});
}

Html by_submission(const ClassCosts& costs, double whole, const NamesForPeople& people) {
  std::map<std::string, double> sums;
  for (const auto& [name, parts] : costs.submissions) sums[name] = cost_of(parts);
  Html rows;
  for (const auto& [name, seconds] : by_cost(sums)) {
    const std::string shown = shown_name(name, people);
    rows +=
        html("<tr><th scope=\"row\" data-value=\"{}\"><a href=\"staff/{}.html\">{}</a>{}</th>{}{}{}</tr>\n",
             {shown, name, shown, folder_beside(name, people), cost_cell(seconds),
              most_in(costs.submissions.at(name)), share_cells(seconds, whole)});
  }
  const Html head = html(
      "<th scope=\"col\" data-sort=\"text\">Submission</th><th scope=\"col\" class=\"number\" "
      "data-sort=\"number\">Seconds</th><th scope=\"col\">Most of it in</th><th scope=\"col\" "
      "class=\"number\">Of all</th><th scope=\"col\"></th>");
  return html("<section id=\"submissions\">\n<h2>Submissions, most expensive first</h2>\n{}</section>\n",
              {table_of(head, rows)});
}

}  // namespace

std::string costs_page(const ClassCosts& costs, const NamesForPeople& people) {
  double whole = 0;
  for (const auto& [name, parts] : costs.submissions) whole += cost_of(parts);
  Html body = html(
      "<header>\n<h1>What grading cost</h1>\n<p class=\"total\"><strong>{}</strong> seconds by the clock for "
      "{} submissions, {} for the reference</p>\n"
      "<p class=\"quiet\"><a href=\"index.html\">The class</a> &#183; <a "
      "href=\"timing.json\">timing.json</a> tells the parts, and CPU seconds "
      "&#183; times differ from run to run; no points depend on them</p>\n"
      "<nav><a href=\"#parts\">By exercise</a> <a href=\"#submissions\">Submissions</a></nav>\n"
      "</header>\n<main>\n",
      {hair::printed("%.0f", whole), costs.submissions.size(),
       hair::printed("%.2f", cost_of(costs.reference))});
  body += by_part(costs, whole);
  body += by_submission(costs, whole, people);
  body += html("</main>\n");
  return html_page("What grading cost", body, {{sort_script()}});
}

}  // namespace grader::report
