// STAFF ONLY. Writes the class page's section of late hand-ins, with the course's deductions.
#include <algorithm>
#include <utility>

#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"
#include "grader/text/time_text.h"

namespace grader::inline report {
namespace {

using Late = std::pair<std::string, Lateness>;

std::string days(double count) {
  return shown_points(count) + (count == 1 ? " day" : " days");
}

}  // namespace

Html late_section(const ClassFacts& facts, const NamesForPeople& people) {
  std::vector<Late> late, marked;
  std::size_t without_time = 0;
  for (const auto& [name, how] : facts.late) {
    without_time += !read_time(how.handed_in);
    if (how.days > 0) late.emplace_back(name, how);
    if (how.marked && (facts.due.empty() || !read_time(how.handed_in))) marked.emplace_back(name, how);
  }
  if (facts.due.empty() && marked.empty()) return {};
  std::stable_sort(late.begin(), late.end(),
                   [](const Late& a, const Late& b) { return a.second.days > b.second.days; });
  Html rows;
  for (const auto& [name, how] : late)
    rows += html(
        "<tr><th scope=\"row\"><a href=\"staff/{}.html\">{}</a></th><td>{}</td><td "
        "class=\"number\">{}</td><td "
        "class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n",
        {name, shown_name(name, people), how.handed_in, days(how.days),
         how.free_days > 0 ? days(how.free_days) : "", shown_points(how.taken)});
  for (const auto& [name, how] : marked)
    rows += html(
        "<tr><th scope=\"row\"><a href=\"staff/{}.html\">{}</a></th><td>{}</td><td colspan=\"3\">marked late "
        "by "
        "Canvas</td></tr>\n",
        {name, shown_name(name, people), how.handed_in});
  const Html table = late.empty() && marked.empty()
                         ? html("<p>Nobody is known to be late.</p>\n")
                         : html(
                               "<div class=\"wide\"><table>\n<thead><tr><th scope=\"col\">Hand-in</th><th "
                               "scope=\"col\">Handed in</th><th scope=\"col\" class=\"number\">Late "
                               "by</th><th scope=\"col\" "
                               "class=\"number\">Free</th><th scope=\"col\" class=\"number\">Points "
                               "taken</th></tr></thead>\n"
                               "<tbody>\n{}</tbody>\n</table></div>\n",
                               {rows});
  const Html unknown =
      without_time == 0 || facts.due.empty()
          ? Html()
          : html("<p>Nobody knows when {} of {} were handed in: their download has no time.</p>\n",
                 {without_time, facts.late.size()});
  const Html due = facts.due.empty() ? html("The course file has no due date, so nothing is taken for it.")
                                     : html("Due {}. Days are those of the calendar.", {facts.due});
  return html("<section id=\"late\">\n<h2>Late</h2>\n<p class=\"quiet\">{}</p>\n{}{}</section>\n",
              {due, table, unknown});
}

}  // namespace grader::report
