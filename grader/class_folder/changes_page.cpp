// STAFF ONLY. Writes changes of points by category, and by student.
#include "grader/class_folder/changes_page.h"

#include <map>

#include "grader/report/facts/text.h"
#include "grader/report/pages/pages.h"
#include "grader/report/report.h"

namespace grader::inline class_folder {
namespace {

struct InCategory {
  std::string title;
  std::size_t more = 0, less = 0;
};

std::string shown(const std::optional<double>& points) {
  return points ? shown_points(*points) : "not there";
}

Html table(const char* head, const Html& rows) {
  return html(
      "<div class=\"wide\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n",
      {Html{head}, rows});
}

}  // namespace

std::string shown_change(const PointsChange& change) {
  return shown(change.before) + " -> " + shown(change.after);
}

ClassChanges class_changes(Record& record) {
  ClassChanges all;
  for (const std::string& name : record.names())
    if (std::vector<PointsChange> theirs = changes(record.log(name)); !theirs.empty())
      all.emplace_back(name, std::move(theirs));
  return all;
}

void write_changes_page(const std::filesystem::path& folder, const ClassChanges& all,
                        const NamesForPeople& people) {
  const std::filesystem::path file = folder / kChangesPage;
  if (all.empty()) {
    std::filesystem::remove(file);
    return;
  }
  std::map<std::string, InCategory> categories;
  Html students;
  for (const auto& [name, theirs] : all) {
    std::string line;
    for (const PointsChange& one : theirs) {
      InCategory& category = categories[one.place];
      category.title = one.title;
      (one.after.value_or(0) > one.before.value_or(0) ? category.more : category.less) += 1;
      line += (line.empty() ? "" : "; ") + one.place + " " + shown_change(one);
    }
    students += html("<tr><th scope=\"row\"><a href=\"staff/{}.html\">{}</a></th><td>{}</td></tr>\n",
                     {name, shown_name(name, people), line});
  }
  Html rows;
  for (const auto& [place, one] : categories)
    rows += html(
        "<tr><th scope=\"row\">{}</th><td>{}</td><td class=\"number\">{}</td><td "
        "class=\"number\">{}</td></tr>\n",
        {place, one.title, one.more, one.less});
  write_file(
      file,
      html_page("What the last grading changed",
                html("<header>\n<h1>What the last grading changed</h1>\n<p class=\"quiet\"><a "
                     "href=\"index.html\">The class</a> &#183; computed points, without people's "
                     "decisions</p>\n</header>\n<main>\n<section>\n<h2>By category</h2>\n{}</section>\n"
                     "<section>\n<h2>By student</h2>\n{}</section>\n</main>\n",
                     {table("<th scope=\"col\">Category</th><th scope=\"col\">Title</th><th "
                            "scope=\"col\" class=\"number\">Have more</th><th scope=\"col\" "
                            "class=\"number\">Have less</th>",
                            rows),
                      table("<th scope=\"col\">Student</th><th scope=\"col\">Changes</th>", students)})));
}

}  // namespace grader::class_folder
