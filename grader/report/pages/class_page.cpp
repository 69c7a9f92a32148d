// STAFF ONLY. Writes the class's page.
#include <algorithm>
#include <utility>

#include "grader/report/facts/alike.h"
#include "grader/report/facts/class_statistics.h"
#include "grader/report/facts/columns.h"
#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"
#include "grader/report/pages/pictures.h"
#include "grader/report/pages/studies_section.h"
#include "solver/timing.h"

namespace grader::inline report {
namespace {

using Results = std::vector<SubmissionResult>;

// Holds the readers of a page, with their names and links.
struct Readers {
  bool are_public;
  const NamesForPeople& people;

  std::string page_of(const std::string& name) const {
    return are_public ? name + "/report.html" : "staff/" + name + ".html";
  }
  Html link(const std::string& name, const std::string& exercise, const std::string& text) const {
    return html("<a href=\"{}{}{}\">{}</a>", {page_of(name), exercise.empty() ? "" : "#", exercise, text});
  }
  // Leads to the first exercise that it is about.
  Html decided_link(const SubmissionResult& result, const Decided& decided) const {
    return link(result.name, decided.place.substr(0, decided.place.find('.')), in_short(decided));
  }
  Html person_link(const SubmissionResult& result) const {
    return link(result.name, "", shown_name(result.name, people)) += folder_beside(result.name, people);
  }
};

// An instructor looks here first: conflicts, then the worst failures. It counts people with all their
// exercises; an exercise that a person gave points of was looked at.
Html to_look_at(const Results& results, const Readers& readers) {
  Html groups;
  const auto add = [&](const Html& heading, const char* look, const auto& line_of) {
    Html lines;
    std::size_t count = 0;
    for (const SubmissionResult& result : results) {
      const Html line = line_of(result);
      if (line.text.empty()) continue;
      ++count;
      lines += html("<li>{}: {}</li>\n", {readers.person_link(result), line});
    }
    groups += folded(heading, count, html("<ul class=\"{}\">\n{}</ul>\n", {look, lines}));
  };
  const auto bad = [](const char* words) { return html("<span class=\"badge bad\">{}</span>", {words}); };
  add(bad("conflict with a person's decision"), "notes", [](const auto& result) {
    Html all;
    for (const Decided& decided : result.decided)
      if (!decided.conflict.empty()) all += html("{}{}", {all.text.empty() ? "" : "; ", decided.conflict});
    return all;
  });
  add(bad("could not be taken"), "notes", [](const auto& result) { return html("{}", {result.note}); });
  add(bad("not final: ended by the clock, grade again"), "notes",
      [](const auto& result) { return html("{}", {in_a_row(result.ended_by_the_clock)}); });
  for (const Status status : {Status::not_taken, Status::unreadable, Status::broke_rules, Status::crashed,
                              Status::out_of_memory, Status::timed_out, Status::does_not_compile,
                              Status::wrong, Status::missing, Status::not_implemented, Status::not_given})
    add(badge(status), "who", [&](const auto& result) {
      Html all;
      for (const ExerciseResult& one : result.exercises)
        // A note stands above, whatever the exercises' status.
        if (one.status == status && !one.points_set && result.note.empty())
          all += html("{}{}", {all.text.empty() ? "" : " ", readers.link(result.name, one.id, one.id)});
      return all;
    });
  if (groups.text.empty()) groups = html("<p>Nothing stands out: all passed, at least in part.</p>\n");
  return html("<section id=\"look\">\n<h2>Worth a look</h2>\n{}</section>\n", {groups});
}

Html alike_part(const Results& results, const Readers& readers) {
  Html items;
  for (const FailAlike& group : who_fail_alike(results)) {
    Html people;
    for (const std::string& name : group.people)
      people += html("{}{}", {people.text.empty() ? "" : ", ",
                              readers.link(name, group.exercise, called(name, readers.people))});
    std::vector<std::string> lost = group.categories;
    for (std::size_t i = 0; i < lost.size(); ++i)
      if (const std::string size = in_words(group.sizes[i]); !size.empty()) lost[i] += " (" + size + ")";
    items += html("<details><summary>{} people lose {}</summary><p>{}</p></details>\n",
                  {group.people.size(), in_a_row(lost), people});
  }
  if (items.text.empty()) return {};
  return html(R"(<section id="alike">
<h2>Who fail alike</h2>
<p class="quiet">The same categories of an exercise, by errors of the same size: one misunderstanding, one source (hairgrade similar), or a limit of ours that is wrong.</p>
{}</section>
)",
              {items});
}

Html class_row(const SubmissionResult& result, const std::vector<Column>& columns, const Readers& readers,
               bool with_decided) {
  Html row = html(
      "<tr><th scope=\"row\" data-value=\"{}\">{}</th><td class=\"number\" "
      "data-value=\"{}\"><strong>{}</strong></td>",
      {shown_name(result.name, readers.people), readers.person_link(result), shown_points(points(result)),
       is_excused_from_all(result) ? "exc" : shown_points(points(result))});
  for (const Column& column : columns) {
    const ExerciseResult* exercise = find_exercise(result, column.id);
    if (!exercise) {
      row += html("<td class=\"quiet\" data-value=\"-1\" title=\"not graded\"></td>");
      continue;
    }
    row += html(
        "<td class=\"number\" data-id=\"{}\" data-value=\"{}\"><a class=\"badge {}\" "
        "href=\"{}#{}\" title=\"{}: {}{}\">{}</a></td>",
        {column.id, shown_points(exercise->points), look_of(exercise->status), readers.page_of(result.name),
         column.id, column.id, to_string(exercise->status),
         exercise->points_set ? "; a person set points" : "", in_short(*exercise)});
  }
  if (with_decided) {
    Html all;
    for (const Decided& decided : result.decided)
      all += html(
          "<span class=\"{}\" title=\"{}\">{}</span> ",
          {decided.conflict.empty() ? "" : "badge bad", decided.text, readers.decided_link(result, decided)});
    row += html("<td class=\"decided\">{}</td>", {all});
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
  const bool with_decided =
      std::ranges::any_of(results, [](const auto& result) { return !result.decided.empty(); });
  table += html("{}<th scope=\"col\">Report</th></tr></thead>\n<tbody>\n",
                {with_decided ? html("<th scope=\"col\">Decided</th>") : Html()});
  for (const SubmissionResult& result : results) table += class_row(result, columns, readers, with_decided);
  return table += html("</tbody>\n</table></div>\n</section>\n");
}

}  // namespace

Html folder_beside(const std::string& name, const NamesForPeople& people) {
  return people.contains(name) ? html(" <code class=\"quiet\">{}</code>", {name}) : Html();
}

std::string class_page(const Results& results, const ClassFacts& facts, const NamesForPeople& people) {
  const std::vector<Column> columns = columns_of(results);
  const std::vector<double> totals = totals_of(results);
  double reachable = 0;
  for (const SubmissionResult& result : results) reachable = std::max(reachable, max_points(result));
  const Readers readers{facts.is_public, people};
  const Html pictures = facts.is_public ? Html() : pictures_by_distance(results, {"staff/pictures"}, people);
  const Html link_to_pictures = pictures.text.empty() ? Html() : html("<a href=\"#pictures\">Pictures</a> ");
  const Html alike = alike_part(results, readers);
  const Html files = html(
      "<p class=\"quiet\"><a href=\"grades.csv\">grades.csv</a> &#183; <a href=\"costs.html\">what grading "
      "cost</a></p>\n<p "
      "class=\"quiet\"><code>hairgrade review</code> with the "
      "name of this folder opens a desk for the decisions.</p>\n");
  Html body = stamps(least_isolation(results), all_with_images(results));
  body += run_section(facts.run);
  body += html(
      "<header>\n<h1>Grades of the class</h1>\n<p class=\"total\"><strong>{}</strong>{} on "
      "average, median {}, {} people{}</p>\n"
      "{}"
      "<nav><a href=\"#look\">Worth a look</a> <a href=\"#submissions\">Submissions</a> {}<a "
      "href=\"#exercises\">Exercises</a> <a "
      "href=\"#distribution\">Distribution</a> {}<a "
      "href=\"#categories\">Categories</a></nav>\n</header>\n<main>\n",
      {shown_points(mean(totals)),
       reachable > 0 ? " of " + shown_points(reachable) + " points" : std::string(" points of extra credit"),
       shown_points(timing::median(totals)), results.size(),
       totals.size() < results.size()
           ? ", " + std::to_string(results.size() - totals.size()) + " of them excused and in no mean"
           : "",
       facts.is_public ? Html() : files, link_to_pictures,
       alike.text.empty() ? Html() : html("<a href=\"#alike\">Who fail alike</a> ")});
  body += to_look_at(results, readers);
  body += people_section(facts.people);
  body += left_over_section(facts.listed, people);
  body += late_section(facts, people);
  body += class_table(results, columns, readers);
  body += pictures;
  std::vector<Studied> studies;
  for (const auto& [name, study] : facts.studies) studies.push_back({shown_name(name, people), study});
  body += studies_section(studies);
  body += exercises_part(results);
  body += distribution_part(results);
  body += sections_part(results, facts.people);
  body += alike;
  body += categories_part(results);
  body += about_section(results);
  body += html("</main>\n");
  return html_page("Grades of the class", body, {{sort_script()}}, Pictures::beside);
}

}  // namespace grader::report
