// STAFF ONLY. Writes the class's page.
#include <algorithm>
#include <utility>

#include "grader/report/facts/class_statistics.h"
#include "grader/report/facts/columns.h"
#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"
#include "grader/report/pages/pictures.h"
#include "solver/timing.h"

namespace grader::inline report {
namespace {

using Results = std::vector<SubmissionResult>;

// Holds the readers of a page, with their names and links.
struct Readers {
  bool are_public;
  const NamesForPeople& people;

  std::string page_of(const SubmissionResult& result) const {
    return are_public ? result.name + "/report.html" : "staff/" + result.name + ".html";
  }
  Html link(const SubmissionResult& result, const std::string& exercise, const std::string& text) const {
    return html("<a href=\"{}{}{}\">{}</a>", {page_of(result), exercise.empty() ? "" : "#", exercise, text});
  }
  Html person_link(const SubmissionResult& result) const {
    return link(result, "", shown_name(result.name, people)) += folder_beside(result.name, people);
  }
};

Html list_of(const Html& heading, std::size_t count, const Html& items, const char* look) {
  if (count == 0) return {};
  return html("<details><summary>{} {}</summary><ul class=\"{}\">\n{}</ul></details>\n",
              {heading, count, look, items});
}

// An instructor looks here first: the worst failures come first. It counts people with all their exercises.
Html to_look_at(const Results& results, const Readers& readers) {
  Html groups, notes;
  std::size_t with_note = 0;
  for (const SubmissionResult& result : results) {
    if (result.note.empty()) continue;
    ++with_note;
    notes += html("<li>{}: {}</li>\n", {readers.person_link(result), result.note});
  }
  groups += list_of(html("<span class=\"badge bad\">could not be taken</span>"), with_note, notes, "notes");
  Html by_the_clock;
  std::size_t not_final = 0;
  for (const SubmissionResult& result : results) {
    if (result.ended_by_the_clock.empty()) continue;
    ++not_final;
    by_the_clock +=
        html("<li>{}: {}</li>\n", {readers.person_link(result), in_a_row(result.ended_by_the_clock)});
  }
  groups += list_of(html("<span class=\"badge bad\">not final: ended by the clock, grade again</span>"),
                    not_final, by_the_clock, "notes");
  for (const Status status : {Status::not_taken, Status::unreadable, Status::broke_rules, Status::crashed,
                              Status::out_of_memory, Status::timed_out, Status::does_not_compile,
                              Status::wrong, Status::missing, Status::not_implemented}) {
    Html items;
    std::size_t count = 0;
    for (const SubmissionResult& result : results) {
      if (!result.note.empty()) continue;  // a note stands above, whatever the exercises' status
      Html exercises;
      for (const ExerciseResult& exercise : result.exercises)
        if (exercise.status == status)
          exercises += html(" {}", {readers.link(result, exercise.id, exercise.id)});
      if (exercises.text.empty()) continue;
      ++count;
      items += html("<li>{}{}:{}</li>\n", {shown_name(result.name, readers.people),
                                           folder_beside(result.name, readers.people), exercises});
    }
    groups += list_of(badge(status), count, items, "who");
  }
  if (groups.text.empty()) groups = html("<p>Nothing stands out: all passed, at least in part.</p>\n");
  return html("<section id=\"look\">\n<h2>Worth a look</h2>\n{}</section>\n", {groups});
}

Html class_row(const SubmissionResult& result, const std::vector<Column>& columns, const Readers& readers) {
  Html row = html(
      "<tr><th scope=\"row\" data-value=\"{}\">{}</th><td class=\"number\" "
      "data-value=\"{}\"><strong>{}</strong></td>",
      {shown_name(result.name, readers.people), readers.person_link(result), shown_points(points(result)),
       shown_points(points(result))});
  for (const Column& column : columns) {
    const ExerciseResult* exercise = find_exercise(result, column.id);
    if (!exercise) {
      row += html("<td class=\"quiet\" data-value=\"-1\" title=\"not graded\"></td>");
      continue;
    }
    row += html(
        "<td class=\"number\" data-id=\"{}\" data-value=\"{}\"><a class=\"badge {}\" "
        "href=\"{}#{}\" title=\"{}: "
        "{}\">{}</a></td>",
        {column.id, shown_points(exercise->points), look_of(exercise->status), readers.page_of(result),
         column.id, column.id, to_string(exercise->status), in_short(*exercise)});
  }
  return row += html("<td><a href=\"{}/report.html\">report</a>{}</td></tr>\n",
                     {result.name,
                      result.studied ? html(" <a href=\"{}/study.html\">study</a>", {result.name}) : Html()});
}

Html class_table(const Results& results, const std::vector<Column>& columns, const Readers& readers) {
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
  for (const SubmissionResult& result : results) table += class_row(result, columns, readers);
  return table += html("</tbody>\n</table></div>\n</section>\n");
}

}  // namespace

Html folder_beside(const std::string& name, const NamesForPeople& people) {
  return people.contains(name) ? html(" <code class=\"quiet\">{}</code>", {name}) : Html();
}

std::string class_page(const Results& results, const ClassFacts& facts, const NamesForPeople& people) {
  const std::vector<Column> columns = columns_of(results);
  std::vector<double> totals;
  double reachable = 0;
  for (const SubmissionResult& result : results) {
    totals.push_back(points(result));
    reachable = std::max(reachable, max_points(result));
  }
  const Readers readers{facts.is_public, people};
  const Html pictures = facts.is_public ? Html() : pictures_by_distance(results, {"staff/pictures"}, people);
  const Html link_to_pictures = pictures.text.empty() ? Html() : html("<a href=\"#pictures\">Pictures</a> ");
  const Html files = html(
      "<p class=\"quiet\"><a href=\"grades.csv\">grades.csv</a> &#183; <a "
      "href=\"junit.xml\">junit.xml</a> &#183; <a href=\"costs.html\">what grading cost</a></p>\n<p "
      "class=\"quiet\"><code>hairgrade review</code> with the "
      "name of this folder opens a desk for the decisions.</p>\n");
  Html body = stamps(least_isolation(results), all_with_images(results));
  body += run_section(facts.run);
  body += html(
      "<header>\n<h1>Grades of the class</h1>\n<p class=\"total\"><strong>{}</strong>{} on "
      "average, median {}, {} people</p>\n"
      "{}"
      "<nav><a href=\"#look\">Worth a look</a> <a href=\"#submissions\">Submissions</a> {}<a "
      "href=\"#exercises\">Exercises</a> <a "
      "href=\"#distribution\">Distribution</a> <a "
      "href=\"#categories\">Categories</a></nav>\n</header>\n<main>\n",
      {shown_points(mean(totals)),
       reachable > 0 ? " of " + shown_points(reachable) + " points" : std::string(" points of extra credit"),
       shown_points(timing::median(totals)), results.size(), facts.is_public ? Html() : files,
       link_to_pictures});
  body += people_section(facts.people);
  body += left_over_section(facts.listed, people);
  body += late_section(facts, people);
  body += to_look_at(results, readers);
  body += class_table(results, columns, readers);
  body += pictures;
  body += exercises_part(results);
  body += distribution_part(results);
  body += sections_part(results, facts.people);
  body += categories_part(results);
  body += alike_part(results, people);
  body += about_section(results);
  body += html("</main>\n");
  return html_page("Grades of the class", body, {{sort_script()}}, Pictures::beside);
}

}  // namespace grader::report
