// STAFF ONLY.
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "grader/report/columns.h"
#include "grader/report/pages.h"
#include "grader/report/pictures.h"
#include "grader/report/text.h"
#include "solver/timing.h"

namespace grader {
namespace {

using Results = std::vector<SubmissionResult>;

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

std::string percent(double share) {
  return shown_points(100 * std::clamp(share, 0.0, 1.0));
}

Html share_bar(double share) {
  return html("<div class=\"share\" aria-hidden=\"true\"><span style=\"width:{}%\"></span></div>",
              {percent(share)});
}

Html staff_link(const SubmissionResult& result, const std::string& exercise, const std::string& text) {
  return html("<a href=\"staff/{}.html{}{}\">{}</a>",
              {result.name, exercise.empty() ? "" : "#", exercise, text});
}

Html means_table(const Results& results, const std::vector<Column>& columns) {
  Html table = html(R"(<section id="exercises">
<h2>Exercises</h2>
<div class="wide"><table>
<thead><tr><th scope="col">Exercise</th><th scope="col" class="number">Mean</th><th scope="col" class="number">Median</th><th scope="col" class="number">Of</th><th scope="col" class="number">Passed</th><th scope="col">Mean share</th></tr></thead>
<tbody>
)");
  for (const Column& column : columns) {
    std::vector<double> values;
    std::size_t passed = 0;
    for (const SubmissionResult& result : results) {
      const ExerciseResult* exercise = find_exercise(result, column.id);
      if (!exercise) continue;
      values.push_back(exercise->points);
      passed += exercise->status == Status::passed;
    }
    table += html(
        "<tr><th scope=\"row\">{} {}{}</th><td class=\"number\">{}</td><td class=\"number\">{}</td><td "
        "class=\"number\">{}</td><td class=\"number\">{} of {}</td><td>{}</td></tr>\n",
        {column.id, column.title, column.extra_credit ? " (extra credit)" : "", shown_points(mean(values)),
         shown_points(timing::median(values)), shown_points(column.max_points), passed, values.size(),
         share_bar(column.max_points > 0 ? mean(values) / column.max_points : 0)});
  }
  return table += html("</tbody>\n</table></div>\n</section>\n");
}

// Totals in tenths of the points to reach; extra credit beyond them counts in the last.
Html distribution(const Results& results) {
  std::array<std::size_t, 10> counts{};
  for (const SubmissionResult& result : results) {
    const double share = max_points(result) > 0 ? points(result) / max_points(result) : 0;
    ++counts[static_cast<std::size_t>(std::clamp(share * 10, 0.0, 9.0))];
  }
  const std::size_t most = std::max<std::size_t>(1, *std::max_element(counts.begin(), counts.end()));
  Html bars = html(
      "<section id=\"distribution\">\n<h2>Distribution</h2>\n<p class=\"quiet\">Submissions by their share "
      "of all points, in "
      "percent</p>\n<ol class=\"bars\">\n");
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double height = 75.0 * static_cast<double>(counts[i]) / static_cast<double>(most);
    bars += html(
        "<li><span>{}</span><span class=\"bar\" style=\"height:{}%\" aria-hidden=\"true\"></span><span "
        "class=\"range\">{}&#8211;{}</span></li>\n",
        {counts[i] > 0 ? std::to_string(counts[i]) : "", shown_points(height), 10 * i, 10 * (i + 1)});
  }
  return bars += html("</ol>\n</section>\n");
}

Html list_of(const Html& heading, std::size_t count, const Html& items, const char* look) {
  if (count == 0) return {};
  return html("<details><summary>{} {}</summary><ul class=\"{}\">\n{}</ul></details>\n",
              {heading, count, look, items});
}

// What an instructor looks at first: what went wrong in the worst way comes first.
Html to_look_at(const Results& results) {
  Html groups, notes;
  std::size_t with_note = 0;
  for (const SubmissionResult& result : results) {
    if (result.note.empty()) continue;
    ++with_note;
    notes += html("<li>{}: {}</li>\n", {staff_link(result, "", result.name), result.note});
  }
  groups += list_of(html("<span class=\"badge bad\">could not be taken</span>"), with_note, notes, "notes");
  Html by_the_clock;
  std::size_t not_final = 0;
  for (const SubmissionResult& result : results) {
    if (result.ended_by_the_clock.empty()) continue;
    ++not_final;
    by_the_clock +=
        html("<li>{}: {}</li>\n", {staff_link(result, "", result.name), in_a_row(result.ended_by_the_clock)});
  }
  groups += list_of(html("<span class=\"badge bad\">not final: ended by the clock, grade again</span>"),
                    not_final, by_the_clock, "notes");
  for (const Status status :
       {Status::unreadable, Status::broke_rules, Status::crashed, Status::out_of_memory, Status::timed_out,
        Status::does_not_compile, Status::wrong, Status::missing, Status::not_implemented}) {
    Html items;
    std::size_t count = 0;
    for (const SubmissionResult& result : results) {
      for (const ExerciseResult& exercise : result.exercises) {
        if (exercise.status != status) continue;
        ++count;
        items += html("<li>{}</li>\n", {staff_link(result, exercise.id, result.name + ", " + exercise.id)});
      }
    }
    groups += list_of(badge(status), count, items, "who");
  }
  if (groups.text.empty()) groups = html("<p>Nothing stands out: all passed, at least in part.</p>\n");
  return html("<section id=\"look\">\n<h2>Worth a look</h2>\n{}</section>\n", {groups});
}

struct Category {
  std::string number, name;
  double points = 0, max_points = 0;
  std::size_t passed = 0, count = 0;
  double share() const { return max_points > 0 ? points / max_points : 1; }
};

// What to explain again in class: the categories in which most points are lost come first.
Html categories_table(const Results& results) {
  std::map<std::pair<std::string, std::size_t>, Category> found;
  for (const SubmissionResult& result : results) {
    for (const ExerciseResult& exercise : result.exercises) {
      for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
        const CaseResult& one = exercise.cases[i];
        Category& category = found[{exercise.id, i}];
        category.number = exercise.id + "." + std::to_string(i + 1);
        category.name = one.name;
        category.points += one.points;
        category.max_points += one.max_points;
        category.passed += one.status == Status::passed;
        ++category.count;
      }
    }
  }
  std::vector<Category> categories;
  for (auto& [key, category] : found) categories.push_back(std::move(category));
  std::stable_sort(categories.begin(), categories.end(),
                   [](const Category& a, const Category& b) { return a.share() < b.share(); });
  Html table = html(R"(<section id="categories">
<h2>Categories, hardest first</h2>
<p class="quiet">Among the submissions whose code ran.</p>
<div class="wide"><table>
<thead><tr><th scope="col">No.</th><th scope="col">Category</th><th scope="col" class="number">Passed</th><th scope="col" class="number">Points reached</th><th scope="col">Share</th></tr></thead>
<tbody>
)");
  for (const Category& category : categories) {
    table += html(
        "<tr><td>{}</td><th scope=\"row\">{}</th><td class=\"number\">{} of {}</td><td "
        "class=\"number\">{}%</td><td>{}</td></tr>\n",
        {category.number, category.name, category.passed, category.count,
         std::to_string(static_cast<int>(100 * std::clamp(category.share(), 0.0, 1.0))),
         share_bar(category.share())});
  }
  return table += html("</tbody>\n</table></div>\n</section>\n");
}

Html class_row(const SubmissionResult& result, const std::vector<Column>& columns) {
  Html row = html(
      "<tr><th scope=\"row\" data-value=\"{}\">{}</th><td class=\"number\" "
      "data-value=\"{}\"><strong>{}</strong></td>",
      {result.name, staff_link(result, "", result.name), shown_points(points(result)),
       shown_points(points(result))});
  for (const Column& column : columns) {
    const ExerciseResult* exercise = find_exercise(result, column.id);
    if (!exercise) {
      row += html("<td class=\"quiet\" data-value=\"-1\" title=\"not graded\"></td>");
      continue;
    }
    row += html(
        "<td class=\"number\" data-value=\"{}\"><a class=\"badge {}\" href=\"staff/{}.html#{}\" title=\"{}: "
        "{}\">{}</a></td>",
        {shown_points(exercise->points), look_of(exercise->status), result.name, column.id, column.id,
         to_string(exercise->status), in_short(*exercise)});
  }
  return row += html("<td><a href=\"{}/report.html\">report</a>{}</td></tr>\n",
                     {result.name,
                      result.studied ? html(" <a href=\"{}/study.html\">study</a>", {result.name}) : Html()});
}

Html class_table(const Results& results, const std::vector<Column>& columns) {
  Html table = html(R"(<section id="submissions">
<h2>Submissions</h2>
<div class="wide"><table class="class">
<thead><tr><th scope="col" data-sort="text">Submission</th><th scope="col" class="number" data-sort="number">Total</th>)");
  for (const Column& column : columns) {
    table += html("<th scope=\"col\" class=\"number\" data-sort=\"number\" title=\"{}{}\">{}<br/>{}{}</th>",
                  {column.title, column.extra_credit ? ", extra credit" : "", column.id,
                   column.extra_credit ? "+" : "of ", shown_points(column.max_points)});
  }
  table += html("<th scope=\"col\">Student&#39;s</th></tr></thead>\n<tbody>\n");
  for (const SubmissionResult& result : results) table += class_row(result, columns);
  return table += html("</tbody>\n</table></div>\n</section>\n");
}

}  // namespace

std::string class_page(const Results& results) {
  const std::vector<Column> columns = columns_of(results);
  std::vector<double> totals;
  double reachable = 0;
  for (const SubmissionResult& result : results) {
    totals.push_back(points(result));
    reachable = std::max(reachable, max_points(result));
  }
  const Html pictures = pictures_by_distance(results, {"staff/pictures"});
  const Html link_to_pictures = pictures.text.empty() ? Html() : html("<a href=\"#pictures\">Pictures</a> ");
  Html body = stamps(least_isolation(results), all_with_images(results));
  body += html(
      "<header>\n<h1>Grades of the class</h1>\n<p class=\"total\"><strong>{}</strong> of {} points on "
      "average, median {}, {} submissions</p>\n"
      "<p class=\"quiet\"><a href=\"grades.csv\">grades.csv</a> &#183; <a "
      "href=\"junit.xml\">junit.xml</a> &#183; <a href=\"costs.html\">what grading cost</a></p>\n"
      "<nav><a href=\"#look\">Worth a look</a> <a href=\"#submissions\">Submissions</a> {}<a "
      "href=\"#exercises\">Exercises</a> <a "
      "href=\"#distribution\">Distribution</a> <a "
      "href=\"#categories\">Categories</a></nav>\n</header>\n<main>\n",
      {shown_points(mean(totals)), shown_points(reachable), shown_points(timing::median(totals)),
       results.size(), link_to_pictures});
  body += to_look_at(results);
  body += class_table(results, columns);
  body += pictures;
  body += means_table(results, columns);
  body += distribution(results);
  body += categories_table(results);
  body += html("</main>\n");
  body += sort_script();
  return html_page("Grades of the class", body, Scripts::on, Pictures::beside);
}

}  // namespace grader
