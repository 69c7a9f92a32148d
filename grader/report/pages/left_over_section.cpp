// STAFF ONLY. Writes the class page's sections of files without a hand-in, and of the last run.
#include <algorithm>

#include "grader/report/pages/pages.h"

namespace grader::inline report {
namespace {

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

}  // namespace

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

}  // namespace grader::report
