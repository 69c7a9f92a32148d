// STAFF ONLY. Writes the class page's section of people who are missing, or on no roster.
#include "grader/report/pages/pages.h"

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

}  // namespace grader::report
