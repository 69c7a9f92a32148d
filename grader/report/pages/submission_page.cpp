// STAFF ONLY. Writes the page of a submission, for the student or for staff.
#include <algorithm>
#include <sstream>

#include "grader/report/facts/columns.h"
#include "grader/report/facts/student_text.h"
#include "grader/report/facts/student_view.h"
#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"
#include "grader/report/pages/pictures.h"
#include "hair/view/view_page.h"

namespace grader::inline report {
namespace {

enum class Reader { student, staff };

// Long logs begin with the cause; the rest stays in staff/NAME.json.
constexpr std::size_t most_log = 20000;

const char* whose(Reader reader) {
  return reader == Reader::student ? "Yours" : "The student's";
}

PicturePlace place_in(const std::string& staff, const std::string& name) {
  return {staff + "pictures", staff + "runs/" + name};
}

std::string points_of(double points, double max_points) {
  return shown_points(points) + " / " + shown_points(max_points);
}

Html block(const std::string& heading, const std::string& text) {
  if (text.empty()) return {};
  const bool cut = text.size() > most_log;
  return html("<h3>{}</h3>\n<pre>{}{}</pre>\n",
              {heading, text.substr(0, most_log), cut ? "\n... (cut here)" : ""});
}

// Leaves out the lines that the compiler's messages have already.
std::string rest_of(const std::string& log, const std::string& messages) {
  std::string rest;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);)
    if (("\n" + messages + "\n").find("\n" + line + "\n") == std::string::npos) rest += line + "\n";
  return rest;
}

// Students read only that a category broke off; their exercise says how.
Html badge_of(const CaseResult& one, Reader reader) {
  if (reader == Reader::staff || one.status != Status::crashed) return badge(one.status);
  return html("<span class=\"badge bad\">broke off</span>");
}

Html case_row(const std::string& number, const CaseResult& one, Reader reader) {
  Html row =
      html("<tr><td>{}</td><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td><td>{}",
           {number, one.name, badge_of(one, reader), points_of(one.points, one.max_points), one.feedback});
  if (!one.hint.empty()) row += html("<br/>{}", {one.hint});  // students have it in the sentence
  if (reader == Reader::staff && one.cases > 0)
    row += html("<br/><span class=\"quiet\">{} of {} cases hold</span>",
                {std::to_string(one.held), std::to_string(one.cases)});
  if (reader == Reader::staff && !one.detail.empty()) row += html("<pre>{}</pre>", {one.detail});
  return row += html("</td></tr>\n");
}

Html cases_table(const Html& rows) {
  return html(R"(<div class="wide"><table class="cases">
<thead><tr><th scope="col">No.</th><th scope="col" class="category">Category</th><th scope="col" class="status">Status</th><th scope="col" class="number">Points</th><th scope="col" class="saw">What we saw</th></tr></thead>
<tbody>
{}</tbody>
</table></div>
)",
              {rows});
}

// Categories without a loss are folded; the others stand open.
Html cases_of(const ExerciseResult& exercise, Reader reader) {
  Html lost, passed;
  std::size_t count = 0;
  for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
    const CaseResult& one = exercise.cases[i];
    const bool is_passed = one.status == Status::passed;
    count += is_passed ? 1 : 0;
    (is_passed ? passed : lost) += case_row(exercise.id + "." + std::to_string(i + 1), one, reader);
  }
  Html all;
  if (!lost.text.empty()) all += cases_table(lost);
  if (count > 0)
    all += html("<details><summary>{} of {} categories pass</summary>\n{}</details>\n",
                {count, exercise.cases.size(), cases_table(passed)});
  return all;
}

Html words_of_staff(const ExerciseResult& exercise) {
  Html all;
  for (const Said& said : exercise.said)
    all += html("<div class=\"note\">{}{}{}</div>\n",
                {about(said, exercise), said.code.empty() ? Html() : html("<pre>{}</pre>", {said.code}),
                 html("<p>{}</p>", {said.text})});
  return all;
}

Html exercise_section(const ExerciseResult& exercise, Reader reader, const PicturePlace& place) {
  Html section =
      html(R"(<section id="{}">
<h2>{} {}</h2>
<div class="line">{}<span>{} points{}</span><code class="quiet">{}</code></div>
<p>{}</p>
)",
           {exercise.id, exercise.id, exercise.title, badge(exercise.status),
            points_of(exercise.points, exercise.max_points), exercise.extra_credit ? ", extra credit" : "",
            exercise.file, exercise.feedback.empty() ? sentence_for(exercise.status) : exercise.feedback});
  section += words_of_staff(exercise);
  section += block("What the compiler says", exercise.compiler_messages);
  section += cases_of(exercise, reader);
  section +=
      moments(exercise, "The whole run in pictures",
              run_breaks_off(exercise) ? RunEnding::breaks_off : RunEnding::whole, whose(reader), place);
  if (exercise.pictures.empty() && run_breaks_off(exercise))
    section += html("<p class=\"quiet\">The whole run broke off before its first picture.</p>\n");
  if (reader == Reader::staff) {
    section += block("What compiler, linker and worker printed",
                     rest_of(exercise.staff_log, exercise.compiler_messages));
    section += source_part(exercise);
  }
  return section += html("</section>\n");
}

// Shows all exercises at a glance.
Html overview(const SubmissionResult& result) {
  if (result.exercises.size() < 2) return {};
  Html table = html("<div class=\"wide\"><table class=\"overview\">\n<tbody>\n");
  for (const ExerciseResult& exercise : result.exercises)
    table += html(
        "<tr><th scope=\"row\"><a href=\"#{}\">{} {}</a></th><td>{}</td><td class=\"number\">{}</td></tr>\n",
        {exercise.id, exercise.id, exercise.title, badge(exercise.status),
         (exercise.extra_credit ? "+ " : "") + points_of(exercise.points, exercise.max_points)});
  return table += html("</tbody>\n</table></div>\n");
}

Html total_line(const SubmissionResult& result) {
  const double extra = extra_credit_counted(result);
  const std::string total = shown_total(points(result), max_points(result));
  const std::size_t blank = total.find(' ');
  const bool in_part = extra > 0 && max_points(result) > 0;
  Html all = html("<p class=\"total\"><strong>{}</strong>{}{}</p>\n",
                  {total.substr(0, blank), total.substr(blank),
                   in_part ? ", " + shown_points(extra) + " of them extra credit" : ""});
  if (const std::string to_come = not_given_yet(result); !to_come.empty())
    all += html("<p class=\"adjustment\">Not final: {}</p>\n", {to_come});
  for (const Adjustment& adjustment : result.adjustments)
    all += html("<p class=\"adjustment\">{}: {} points</p>\n",
                {adjustment.reason, shown_points(adjustment.points)});
  return all;
}

Html sections_of(const SubmissionResult& result, Reader reader, const PicturePlace& place) {
  Html body;
  for (const Decided& decided : result.decided)
    if (!decided.conflict.empty()) body += html("<p class=\"stamp\">{}</p>\n", {decided.conflict});
  if (!result.note.empty()) body += html("<p class=\"note\">{}</p>\n", {result.note});
  for (const std::string& remark : result.remarks) body += html("<p class=\"note\">{}</p>\n", {remark});
  body += overview(result);
  // The overview has the course's order; below it exercises that lost points come first.
  using enum Status;
  for (const bool later : {false, true})
    for (const ExerciseResult& exercise : result.exercises) {
      const Status status = exercise.status;
      if ((status == passed || status == excused || status == given || status == not_given) == later)
        body += exercise_section(exercise, reader, place);
    }
  return body;
}

Html body_of(const SubmissionResult& result, Reader reader, const NamesForPeople& people) {
  Html body = stamps(result.isolation, result.images);
  body += html("<header>\n<h1>{}</h1>\n", {shown_name(result.name, people)});
  body += total_line(result);
  if (reader == Reader::staff) {
    body += html(
        "<p class=\"quiet\">{}<a href=\"../index.html\">The class</a> &#183; <a "
        "href=\"../{}/report.html\">The student&#39;s report</a> &#183; fingerprint <code>{}</code></p>\n",
        {people.contains(result.name) ? html("<code>{}</code> &#183; ", {result.name}) : Html(), result.name,
         result.fingerprint.substr(0, 16)});
  }
  body += html("</header>\n<main>\n");
  body += sections_of(
      result, reader,
      reader == Reader::student ? PicturePlace{.is_for_student = true} : place_in("", result.name));
  if (result.studied)
    body += html("<p><a href=\"{}study.html\">Error against run time</a> of small scenes, beside ours.</p>\n",
                 {reader == Reader::staff ? "../" + result.name + "/" : std::string()});
  return body += html("</main>\n");
}

}  // namespace

const char* look_of(Status status) {
  switch (status) {
    case Status::passed:
    case Status::given:
      return "good";
    case Status::partly:
      return "part";
    case Status::missing:
    case Status::not_implemented:
    case Status::excused:
    case Status::not_given:
      return "none";
    default:
      return "bad";
  }
}

Html stamps(Isolation isolation, bool images) {
  Html all;
  const std::string said = said_of(isolation);
  if (isolation == Isolation::none)
    all += html(
        "<p class=\"stamp\" role=\"note\">{}. These results are not protected against what the code may have "
        "done.</p>\n",
        {said});
  if (isolation == Isolation::container)
    all += html("<p class=\"stamp\" role=\"note\">{}: each program had a user and a folder of its own.</p>\n",
                {said});
  if (!images)
    all += html(
        "<p class=\"stamp\" role=\"note\">Graded without pictures. What these "
        "would show is not in the points.</p>\n");
  return all;
}

Html badge(Status status) {
  return html("<span class=\"badge {}\">{}</span>", {look_of(status), to_string(status)});
}

std::string student_page(const SubmissionResult& result, const NamesForPeople& people) {
  const SubmissionResult shown = for_student(result);
  const auto differs = [](const PictureResult& picture) { return !picture.heat.empty(); };
  Scripts scripts;
  if (std::ranges::any_of(shown.exercises, [&](const ExerciseResult& exercise) {
        return std::ranges::any_of(exercise.pictures, differs);
      }))
    scripts.texts = {hair::viewer_script()};
  return html_page("Report for " + shown_name(result.name, people), body_of(shown, Reader::student, people),
                   scripts);
}

std::string staff_page(const SubmissionResult& result, const NamesForPeople& people) {
  return html_page(shown_name(result.name, people) + " (staff)", body_of(result, Reader::staff, people), {},
                   Pictures::beside);
}

Html staff_part(const SubmissionResult& result, const std::string& exercise, const std::string& staff) {
  const ExerciseResult* one = find_exercise(result, exercise);
  const PicturePlace place = place_in(staff, result.name);
  return one ? exercise_section(*one, Reader::staff, place) : sections_of(result, Reader::staff, place);
}

}  // namespace grader::report
