// STAFF ONLY. Writes the page with the cost of grading.
#include "grader/report/pages/costs_page.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "grader/report/pages/pages.h"

namespace grader::inline report {
namespace {

using Values = std::vector<double>;
using Named = std::pair<std::string, Values>;

std::string shown_cost(double value, CostKind kind, bool mean = false) {
  std::array<char, 64> digits;
  std::snprintf(digits.data(), digits.size(), "%.*f", kind != CostKind::count ? 2 : mean ? 1 : 0, value);
  return digits.data();
}

void add_to(Values& sum, const Values& more) {
  sum.resize(std::max(sum.size(), more.size()));
  for (std::size_t i = 0; i < more.size(); ++i) sum[i] += more[i];
}

Values sum_of(const CostsByPart& parts, std::size_t columns) {
  Values sum(columns);
  for (const auto& [part, values] : parts) add_to(sum, values);
  return sum;
}

Values divided(Values values, std::size_t by) {
  for (double& value : values) value /= static_cast<double>(std::max<std::size_t>(by, 1));
  return values;
}

double seconds_of(const Values& values, const std::vector<CostColumn>& columns) {
  double seconds = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (columns[i].kind == CostKind::wall_seconds) seconds += values[i];
  return seconds;
}

// Puts the most expensive first; equal ones are sorted by name.
void sort_by_cost(std::vector<Named>& rows, const std::vector<CostColumn>& columns) {
  std::stable_sort(rows.begin(), rows.end(), [&](const Named& a, const Named& b) {
    return seconds_of(a.second, columns) > seconds_of(b.second, columns);
  });
}

Html number(const std::string& heading, double value, CostKind kind, bool mean, const char* look) {
  return html("<td class=\"number{}\" data-id=\"{}\" data-value=\"{}\">{}</td>",
              {look, heading, std::to_string(value), shown_cost(value, kind, mean)});
}

// Writes the sum and each column. The columns are folded: few readers need them.
Html numbers(const Values& values, const std::vector<CostColumn>& columns, bool mean = false) {
  Html cells = number("Cost", seconds_of(values, columns), CostKind::wall_seconds, mean, "");
  for (std::size_t i = 0; i < columns.size(); ++i)
    cells += number(columns[i].heading, values[i], columns[i].kind, mean, " more");
  return cells;
}

Html share(double part, double whole) {
  const std::string percent =
      shown_cost(whole > 0 ? std::min(100 * part / whole, 100.0) : 0, CostKind::count);
  return html(
      "<td class=\"number\">{} %</td><td><div class=\"share\" aria-hidden=\"true\"><span "
      "style=\"width:{}%\"></span></div></td>",
      {percent, percent});
}

enum class Sorted { never, by_readers };

Html head_of(const char* first, const std::vector<CostColumn>& columns, const Html& more,
             Sorted sorted = Sorted::never) {
  const auto cell = [&](const std::string& heading, const std::string& explanation, const char* kind,
                        const char* look) {
    return html("<th scope=\"col\" class=\"{}\"{}{}>{}</th>",
                {look, sorted == Sorted::by_readers ? html(" data-sort=\"{}\"", {kind}) : Html(),
                 explanation.empty() ? Html() : html(" title=\"{}\"", {explanation}), heading});
  };
  Html cells = cell(first, "", "text", "");
  cells += cell("Cost", "what a submission had to wait for, seconds by the wall clock", "number", "number");
  for (const CostColumn& column : columns)
    cells += cell(column.heading, column.explanation, "number", "number more");
  return html("<thead><tr>{}{}</tr></thead>\n<tbody>\n", {cells, more});
}

Html table_of(const Html& head, const Html& rows) {
  return html("<div class=\"wide\"><table class=\"class\">\n{}{}</tbody>\n</table></div>\n", {head, rows});
}

Html in_all(const Costs& costs, const Values& all) {
  Html rows;
  const auto row = [&](const char* what, const Values& values, bool mean) {
    rows += html("<tr><th scope=\"row\">{}</th>{}</tr>\n", {what, numbers(values, costs.columns, mean)});
  };
  row("All submissions", all, false);
  row("A submission, on average", divided(all, costs.submissions.size()), true);
  row("The reference", sum_of(costs.reference, costs.columns.size()), false);
  Html meanings;
  for (const CostColumn& column : costs.columns)
    meanings += html("<li><strong>{}</strong>: {}</li>\n", {column.heading, column.explanation});
  return html(
      "<section id=\"all\">\n<h2>In all</h2>\n{}<details><summary>What the columns are</summary><ul>\n"
      "<li><strong>Cost</strong>: what a submission had to wait for, seconds by the wall clock</li>\n"
      "{}</ul></details>\n</section>\n",
      {table_of(head_of("", costs.columns, {}), rows), meanings});
}

// Writes an average over the submissions that have the part, and below it the reference's.
Html by_part(const Costs& costs) {
  std::map<std::string, std::pair<Values, std::size_t>> sums;
  for (const auto& [name, parts] : costs.submissions)
    for (const auto& [part, values] : parts) {
      add_to(sums[part].first, values);
      ++sums[part].second;
    }
  std::vector<Named> order;
  double whole = 0;
  for (const auto& [part, sum] : sums) {
    order.emplace_back(part, sum.first);
    whole += seconds_of(sum.first, costs.columns);
  }
  sort_by_cost(order, costs.columns);
  Html rows;
  for (const auto& [part, sum] : order) {
    rows += html("<tr><th scope=\"row\">{}</th>{}{}</tr>\n",
                 {part, numbers(divided(sum, sums[part].second), costs.columns, true),
                  share(seconds_of(sum, costs.columns), whole)});
    if (const auto reference = costs.reference.find(part); reference != costs.reference.end())
      rows += html("<tr class=\"quiet\"><td>the reference</td>{}<td></td><td></td></tr>\n",
                   {numbers(reference->second, costs.columns)});
  }
  const Html more = html("<th scope=\"col\" class=\"number\">Of all</th><th scope=\"col\"></th>");
  return html(
      "<section id=\"parts\">\n<h2>By exercise</h2>\n<p class=\"quiet\">A submission, on average; below "
      "it the reference. {}</p>\n{}</section>\n",
      {"“study” are the studies.", table_of(head_of("Exercise", costs.columns, more), rows)});
}

Html most_in(const CostsByPart& parts, const std::vector<CostColumn>& columns) {
  const auto most = std::max_element(parts.begin(), parts.end(), [&](const auto& a, const auto& b) {
    return seconds_of(a.second, columns) < seconds_of(b.second, columns);
  });
  if (most == parts.end()) return html("<td></td>");
  const double all = seconds_of(sum_of(parts, columns.size()), columns);
  const double share = all > 0 ? 100 * seconds_of(most->second, columns) / all : 0;
  return html("<td>{}, {} %</td>", {most->first, shown_cost(share, CostKind::count)});
}

Html by_submission(const Costs& costs, double whole, const NamesForPeople& people) {
  std::vector<Named> order;
  for (const auto& [name, parts] : costs.submissions)
    order.emplace_back(name, sum_of(parts, costs.columns.size()));
  sort_by_cost(order, costs.columns);
  Html rows;
  for (const auto& [name, values] : order) {
    const auto person = people.find(name);
    const bool known = person != people.end();
    const std::string& shown = known ? person->second : name;
    rows +=
        html("<tr><th scope=\"row\" data-value=\"{}\"><a href=\"staff/{}.html\">{}</a>{}</th>{}{}{}</tr>\n",
             {shown, name, shown, known ? html(" <code class=\"quiet\">{}</code>", {name}) : Html(),
              numbers(values, costs.columns), most_in(costs.submissions.at(name), costs.columns),
              share(seconds_of(values, costs.columns), whole)});
  }
  const Html more = html(
      "<th scope=\"col\">Most of it in</th><th scope=\"col\" class=\"number\">Of all</th><th "
      "scope=\"col\"></th>");
  return html("<section id=\"submissions\">\n<h2>Submissions, most expensive first</h2>\n{}</section>\n",
              {table_of(head_of("Submission", costs.columns, more, Sorted::by_readers), rows)});
}

}  // namespace

std::string costs_page(const Costs& costs, const NamesForPeople& people) {
  Values all(costs.columns.size());
  for (const auto& [name, parts] : costs.submissions) add_to(all, sum_of(parts, costs.columns.size()));
  const double whole = seconds_of(all, costs.columns);
  Html body = html(
      "<header>\n<h1>What grading cost</h1>\n<p class=\"total\"><strong>{}</strong> seconds for {} "
      "submissions</p>\n"
      "<p class=\"quiet\"><a href=\"index.html\">The class</a> &#183; <a "
      "href=\"timing.json\">timing.json</a> "
      "&#183; times differ from run to run; no points depend on them</p>\n"
      "<nav><a href=\"#all\">In all</a> <a href=\"#parts\">By exercise</a> <a "
      "href=\"#submissions\">Submissions</a></nav>\n</header>\n<main>\n",
      {shown_cost(whole, CostKind::count), costs.submissions.size()});
  body += fold("all columns");
  body += in_all(costs, all);
  body += by_part(costs);
  body += by_submission(costs, whole, people);
  body += html("</main>\n");
  return html_page("What grading cost", body, {{sort_script()}});
}

}  // namespace grader::report
