// STAFF ONLY. Writes the class's statistics, as parts of its page.
#include <algorithm>
#include <utility>

#include "grader/report/facts/class_statistics.h"
#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"
#include "solver/timing.h"

namespace grader::inline report {
namespace {

constexpr std::size_t kHardest = 10;  // categories are not folded

std::string percent(double share) {
  return shown_points(100 * std::clamp(share, 0.0, 1.0));
}

Html share_bar(double share) {
  return html("<div class=\"share\" aria-hidden=\"true\"><span style=\"width:{}%\"></span></div>",
              {percent(share)});
}

// Draws bars of counts, as high as their share of the largest one.
Html bars_of(const Tenths& tenths) {
  const std::size_t most = std::max<std::size_t>(1, *std::max_element(tenths.begin(), tenths.end()));
  Html bars;
  for (std::size_t i = 0; i < tenths.size(); ++i) {
    const double height = 75.0 * static_cast<double>(tenths[i]) / static_cast<double>(most);
    bars += html(
        "<li><span>{}</span><span class=\"bar\" style=\"height:{}%\" aria-hidden=\"true\"></span><span "
        "class=\"range\">{}&#8211;{}</span></li>\n",
        {tenths[i] > 0 ? std::to_string(tenths[i]) : "", shown_points(height), 10 * i, 10 * (i + 1)});
  }
  return html("<ol class=\"bars\">\n{}</ol>\n", {bars});
}

// Draws "3 0 0 1 0 0 2 0 4 20" as bars without words, and in words for a screen reader.
Html small_bars(const Tenths& tenths) {
  const std::size_t most = std::max<std::size_t>(1, *std::max_element(tenths.begin(), tenths.end()));
  Html bars;
  std::string words;
  for (std::size_t i = 0; i < tenths.size(); ++i) {
    bars += html("<span style=\"height:{}%\"></span>",
                 {percent(static_cast<double>(tenths[i]) / static_cast<double>(most))});
    if (tenths[i] > 0)
      words += (words.empty() ? "" : ", ") + std::to_string(10 * i) + "-" + std::to_string(10 * (i + 1)) +
               " %: " + std::to_string(tenths[i]);
  }
  return html("<div class=\"tenths\" role=\"img\" title=\"{}\" aria-label=\"{}\">{}</div>",
              {words, words, bars});
}

}  // namespace

Html folded(const Html& heading, std::size_t count, const Html& content, std::size_t most_open) {
  if (count == 0) return {};
  return html("<details{}><summary>{} {}</summary>\n{}</details>\n",
              {count > most_open ? Html() : html(" open=\"\""), heading, count, content});
}

Html exercises_part(const std::vector<SubmissionResult>& results) {
  Html table = html(R"(<section id="exercises">
<h2>Exercises</h2>
<p class="quiet">The bars count people by their share of the points, in tenths from the left.</p>
<div class="wide"><table>
<thead><tr><th scope="col">Exercise</th><th scope="col" class="number">Mean</th><th scope="col" class="number">Median</th><th scope="col" class="number">Of</th><th scope="col" class="number">Passed</th><th scope="col">People</th></tr></thead>
<tbody>
)");
  for (const ExerciseStatistics& one : exercise_statistics(results))
    table += html(
        "<tr><th scope=\"row\">{} {}{}</th><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
        "class=\"number\">{}</td><td class=\"number\">{} of {}</td><td>{}</td></tr>\n",
        {one.column.id, one.column.title, one.column.extra_credit ? " (extra credit)" : "",
         shown_points(mean(one.points)), shown_points(timing::median(one.points)),
         shown_points(one.column.max_points), one.passed, one.points.size(), small_bars(one.tenths)});
  return table += html("</tbody>\n</table></div>\n</section>\n");
}

Html distribution_part(const std::vector<SubmissionResult>& results) {
  return html(
      "<section id=\"distribution\">\n<h2>Distribution</h2>\n<p class=\"quiet\">People by their share of all "
      "points, in percent</p>\n{}</section>\n",
      {bars_of(tenths_of_totals(results))});
}

Html sections_part(const std::vector<SubmissionResult>& results, const std::vector<ClassLine>& people) {
  Html rows;
  for (const SectionStatistics& one : section_statistics(results, people))
    rows += html(
        "<tr><th scope=\"row\">{}</th><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
        "class=\"number\">{}</td><td "
        "class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n",
        {one.name.empty() ? "without a section" : one.name, one.people, one.handed_in,
         one.handed_in > 0 ? shown_points(one.first_quartile) : "",
         one.handed_in > 0 ? shown_points(one.median) : "",
         one.handed_in > 0 ? shown_points(one.third_quartile) : ""});
  if (rows.text.empty()) return {};
  return html(R"(<section id="sections">
<h2>Sections</h2>
<p class="quiet">Points of those who handed in.</p>
<div class="wide"><table>
<thead><tr><th scope="col">Section</th><th scope="col" class="number">People</th><th scope="col" class="number">Handed in</th><th scope="col" class="number">First quartile</th><th scope="col" class="number">Median</th><th scope="col" class="number">Third quartile</th></tr></thead>
<tbody>
{}</tbody>
</table></div>
</section>
)",
              {rows});
}

// Puts the categories with most lost points first: a lecturer explains them again.
Html categories_part(const std::vector<SubmissionResult>& results) {
  const std::vector<CategoryStatistics> all = category_statistics(results);
  Html table =
      html(R"(<section id="categories">
<h2>Categories, hardest first</h2>
<p class="quiet">Among the people whose code ran. "Strong less weak": how much oftener the strongest 27 % of the class pass than the weakest 27 %, from -1 to 1. Near 0 a category does not tell them apart; below 0 look at the category.</p>
{}<div class="wide"><table class="class">
<thead><tr><th scope="col" data-sort="text">No.</th><th scope="col" data-sort="text">Category</th><th scope="col" class="number" data-sort="number">Passed</th><th scope="col" class="number" data-sort="number">Points reached</th><th scope="col" class="number" data-sort="number">Strong less weak</th><th scope="col">Share</th></tr></thead>
<tbody>
)",
           {all.size() > kHardest
                ? html("<label class=\"fold\"><input type=\"checkbox\"/> Show all {} categories</label>\n",
                       {all.size()})
                : Html()});
  std::size_t rank = 0;
  for (const CategoryStatistics& category : all) {
    const std::string reached = percent(category.share());
    const std::string apart = category.discrimination ? shown_points(*category.discrimination) : "";
    table += html(
        "<tr{}><td data-value=\"{}\">{}</td><th scope=\"row\" data-value=\"{}\">{}</th><td class=\"number\" "
        "data-value=\"{}\">{} of {}</td><td class=\"number\" data-value=\"{}\">{}%</td><td class=\"number\" "
        "data-value=\"{}\">{}</td><td>{}</td></tr>\n",
        {++rank > kHardest ? html(" class=\"more\"") : Html(), category.number, category.number,
         category.name, category.name, category.passed, category.passed, category.ran, reached, reached,
         apart.empty() ? "-2" : apart, apart, share_bar(category.share())});
  }
  return table += html("</tbody>\n</table></div>\n</section>\n");
}

}  // namespace grader::report
