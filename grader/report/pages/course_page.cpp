// STAFF ONLY. Writes the page of a course with several hand-ins.
#include "grader/report/facts/class_facts.h"
#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"

namespace grader::inline report {
namespace {

Html cell_of(const CourseTable::HandIn& hand_in, const std::string& name,
             const std::optional<CourseTable::Cell>& cell) {
  if (!cell) return html("<td class=\"quiet\" data-value=\"-1\" title=\"nothing handed in\"></td>");
  return html("<td class=\"number\" data-value=\"{}\"><a href=\"{}/staff/{}.html\">{}</a></td>",
              {shown_points(cell->points), hand_in.folder, name, shown_points(cell->points)});
}

Html row_of(const CourseTable& course, const CourseTable::Row& row, const NamesForPeople& people) {
  const CourseTable::Cell total = course.total(row);
  Html line = html(
      "<tr><th scope=\"row\" data-value=\"{}\">{}{}</th><td class=\"number\" "
      "data-value=\"{}\"><strong>{}</strong> of "
      "{}</td>",
      {shown_name(row.name, people), shown_name(row.name, people), folder_beside(row.name, people),
       shown_points(total.points), shown_points(total.points), shown_points(total.max_points)});
  for (std::size_t i = 0; i < course.hand_ins.size(); ++i)
    line += cell_of(course.hand_ins[i], row.name, row.cells[i]);
  return line += html("</tr>\n");
}

}  // namespace

CourseTable::Cell CourseTable::total(const Row& row) const {
  Cell sum;
  double most_extra = 0, most = 0;
  for (std::size_t i = 0; i < hand_ins.size(); ++i) {
    const Cell cell = row.cells[i].value_or(Cell{0, hand_ins[i].max_points, 0});
    sum.points += cell.points;
    sum.max_points += cell.max_points;
    sum.extra_credit += cell.extra_credit;
    if (cell.max_points <= 0) continue;  // a share of it may be infinite
    most_extra += cell.max_points * hand_ins[i].extra_credit_share;
    most += cell.max_points * hand_ins[i].total_share;
  }
  if (sum.max_points <= 0) return sum;
  const double others = sum.points - sum.extra_credit;
  sum.extra_credit = counted(sum.extra_credit, others, most_extra, most);
  sum.points = others + sum.extra_credit;
  return sum;
}

std::string course_page(const CourseTable& course, const std::vector<ClassLine>& lines,
                        const NamesForPeople& people) {
  std::vector<ClassLine> absent;  // people on no roster are on the pages of hand-ins
  for (const ClassLine& line : lines)
    if (line.hand_in.empty()) absent.push_back(line);
  Html body = html(
      "<header>\n<h1>Grades of the course</h1>\n<p class=\"total\">{} hand-ins, {} people</p>\n<p "
      "class=\"quiet\"><a "
      "href=\"grades.csv\">grades.csv</a></p>\n</header>\n<main>\n",
      {course.hand_ins.size(), course.rows.size()});
  body += people_section(absent);
  body += html(R"(<section id="hand-ins">
<h2>People and hand-ins</h2>
<div class="wide"><table class="class">
<thead><tr><th scope="col" data-sort="text">Submission</th><th scope="col" class="number" data-sort="number">Total</th>)");
  for (const CourseTable::HandIn& hand_in : course.hand_ins)
    body += html(
        "<th scope=\"col\" class=\"number\" data-sort=\"number\"><a href=\"{}/index.html\">{}</a><br/>of "
        "{}</th>",
        {hand_in.folder, hand_in.name, shown_points(hand_in.max_points)});
  body += html("</tr></thead>\n<tbody>\n");
  for (const CourseTable::Row& row : course.rows) body += row_of(course, row, people);
  body += html("</tbody>\n</table></div>\n</section>\n</main>\n");
  return html_page("Grades of the course", body, {{sort_script()}}, Pictures::beside);
}

}  // namespace grader::report
