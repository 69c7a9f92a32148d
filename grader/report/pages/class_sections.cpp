// STAFF ONLY. Writes sections of the class page: people who are missing, late hand-ins, files without a
// hand-in, and the last run.
#include <algorithm>
#include <utility>

#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"
#include "grader/text/time_text.h"

namespace grader::inline report {
namespace {

Html names_of(const Html& heading, const std::vector<const ClassLine*>& lines) {
  Html items;
  for (const ClassLine* line : lines) {
    const std::string who = line->name.empty() ? line->id : line->name;
    const Html id = line->name.empty() || line->id.empty()
                        ? Html()
                        : html(" <span class=\"quiet\">{}</span>", {line->id});
    if (line->hand_in.empty())
      items += html("<li>{}{}</li>\n", {who, id});
    else
      items += html("<li><a href=\"staff/{}.html\">{}</a>{}: {}</li>\n",
                    {line->hand_in, who.empty() ? line->hand_in : who, id, line->note});
  }
  return folded(heading, lines.size(), html("<ul class=\"notes\">\n{}</ul>\n", {items}));
}

constexpr std::size_t kMostUnfolded = 10;

std::size_t how_many(const std::vector<Accounted>& listed, Accounted::As as) {
  return static_cast<std::size_t>(std::ranges::count(listed, as, &Accounted::as));
}

Html table_of(const std::vector<Accounted>& listed, Accounted::As as, const NamesForPeople& people,
              const Html& heading) {
  Html rows;
  for (const Accounted& file : listed)
    if (file.as == as)
      rows +=
          html("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td></tr>\n",
               {file.path, file.whose.empty() ? "nobody's" : shown_name(file.whose, people), file.reason});
  return folded(heading, how_many(listed, as),
                html("<div class=\"wide\"><table>\n<thead><tr><th scope=\"col\">File</th><th "
                     "scope=\"col\">Whose</th><th scope=\"col\">Why</th></tr></thead>\n<tbody>\n{}</tbody>\n"
                     "</table></div>\n",
                     {rows}),
                kMostUnfolded);
}

using Late = std::pair<std::string, Lateness>;

std::string days(double count) {
  return shown_points(count) + (count == 1 ? " day" : " days");
}

}  // namespace

Html people_section(const std::vector<ClassLine>& people) {
  std::vector<const ClassLine*> absent, strangers;
  for (const ClassLine& line : people)
    if (!line.note.empty()) (line.hand_in.empty() ? absent : strangers).push_back(&line);
  if (absent.empty() && strangers.empty()) return {};
  return html("<section id=\"people\">\n<h2>People</h2>\n{}{}</section>\n",
              {names_of(html("<span class=\"badge quiet\">nothing handed in</span>"), absent),
               names_of(html("<span class=\"badge bad\">graded, but on no roster</span>"), strangers)});
}

Html left_over_section(const std::vector<Accounted>& listed, const NamesForPeople& people) {
  using enum Accounted::As;
  Html lines;
  for (const Accounted& line : listed)
    if (line.as == notice) lines += html("<li>{}</li>\n", {line.reason});
  const Html parts = html(
      "{}{}{}",
      {table_of(listed, left_over, people, html("<span class=\"badge bad\">not graded</span>")),
       folded(html("<span class=\"badge bad\">to look at</span>"), how_many(listed, notice),
              html("<ul class=\"notes\">\n{}</ul>\n", {lines}), kMostUnfolded),
       table_of(listed, older, people, html("<span class=\"badge quiet\">older, does not count</span>"))});
  if (parts.text.empty()) return {};
  return html(
      "<section id=\"left-over\">\n<h2>Left over</h2>\n<p class=\"quiet\">Files of the last run's input "
      "that reached no hand-in that counts; all of them are in <a "
      "href=\"left-over.json\">left-over.json</a>.</p>\n{}</section>\n",
      {parts});
}

Html run_section(const std::optional<LastRun>& run) {
  if (!run || run->is_whole()) return {};
  const std::string done = std::to_string(run->done) + " of " + std::to_string(run->asked);
  const std::string said = run->ended.empty()
                               ? "A run began at " + run->began + " (UTC) and has not ended: " + done +
                                     " hand-ins are done. If it is at work no more, it was killed, and this "
                                     "page may be older than some "
                                     "reports; the same command with --resume goes on."
                               : done + " hand-ins were done when the run was interrupted at " + run->ended +
                                     " (UTC); the same command with --resume goes on.";
  return html("<p class=\"stamp\" id=\"run\">{}</p>\n", {said});
}

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
