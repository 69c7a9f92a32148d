// STAFF ONLY. Writes rows of grades.
#include "grader/gradebook/filling.h"

#include <algorithm>

#include "grader/course/input.h"
#include "grader/report/facts/text.h"
#include "grader/text/letters.h"

namespace grader::inline gradebook {
namespace {

constexpr std::string_view kPointsGrade = " points grade";

// Finds "Lab 3 Points Grade", which the maximum may follow.
std::size_t item_column(const Csv& table, const std::string& wanted) {
  const std::string item = lowered(wanted);
  const auto is_wanted = [&](std::size_t i) -> std::optional<bool> {
    const std::string title = lowered(table.rows.front().cells[i]);
    const std::size_t end = title.find(kPointsGrade);
    if (end == title.npos) return {};
    return item.empty() || item == title || item == title.substr(0, end) ||
           item == title.substr(0, end + kPointsGrade.size());
  };
  return wanted_column(
      table, is_wanted,
      "no title ends with \"Points Grade\"; export the grade item with its points from Brightspace",
      "no item is \"" + composed(wanted) + "\"", "has several items");
}

// Reads "<Numeric MaxPoints:10 Weight:5>".
std::optional<double> maximum_in(const std::string& title) {
  constexpr std::string_view kWord = "MaxPoints:";
  const std::size_t at = title.find(kWord);
  if (at == title.npos) return {};
  const std::size_t begin = at + kWord.size();
  return number_in(title.substr(begin, title.find_first_not_of("0123456789.,", begin) - begin));
}

}  // namespace

Gradebook fill_brightspace(const Csv& exported, const std::vector<Grade>& grades,
                           const FillOptions& options) {
  const Csv::Row& head = exported.rows.front();
  std::vector<std::size_t> keys;
  for (const char* title : {"OrgDefinedId", "Username"})
    if (const std::size_t column = column_of(exported, title); column != kNoColumn) keys.push_back(column);
  if (keys.empty())
    throw BadInput(
        place_of(exported, head) +
        ": no title is OrgDefinedId or Username; export the grades from Brightspace with one of them");
  const std::size_t item = item_column(exported, options.column);
  const std::string title = "the column \"" + composed(head.cells[item]) + "\"";
  if (starts_formula(head.cells[item]))
    throw BadInput(place_of(exported, head) + ": a spreadsheet would run " + title +
                   "; rename the item in Brightspace");
  const std::optional<double> maximum = maximum_in(head.cells[item]);
  Filling filling(exported, grades, options, {.system = "Brightspace's import", .title = title});
  const auto keys_in = [&](const Csv::Row& row) {
    Cells cells;
    for (const std::size_t key : keys) cells.push_back(row.at(key));
    return cells;
  };
  Cells titles = keys_in(head);
  titles.insert(titles.end(), {head.cells[item], "End-of-Line Indicator"});
  std::string csv = csv_line(titles);
  for (std::size_t i = 1; i < exported.rows.size(); ++i) {
    const Csv::Row& row = exported.rows[i];
    Cells cells = keys_in(row);
    const bool formula = std::ranges::any_of(cells, starts_formula);
    const std::optional<std::string> points =
        filling.score(row, row.at(item), maximum,
                      formula ? "a spreadsheet would run the id as a formula; enter it by hand" : "");
    if (!points) continue;
    if (maximum && *number_in(*points) > *maximum)
      filling.say(place_of(exported, row) + ": " + *points + " points are cut to " + shown_points(*maximum) +
                  " by Brightspace");
    cells.insert(cells.end(), {*points, "#"});
    csv += csv_line(cells);
  }
  if (!maximum)
    filling.say(title +
                " has no maximum in its title, so nothing tells whether the grades fit; Brightspace "
                "cuts what is more");
  filling.say(
      "not certain: the mark \"#\" at the end of each row, and in front of ids, is seen in exports, and is "
      "not documented");
  return filling.book(std::move(csv));
}

Gradebook autolab_rows(const std::vector<Grade>& grades, const std::vector<std::string>& problems,
                       const Roster* roster) {
  Gradebook book;
  std::map<std::string, std::vector<std::pair<const Grade*, std::string>>> by_email;
  for (const Grade& grade : grades) {
    const bool members = !grade.owner.members.empty();
    for (const Owner& owner : members ? grade.owner.members : std::vector{grade.owner}) {
      std::string email = owner.email.empty() && owner.id.find('@') != owner.id.npos ? owner.id : owner.email;
      if (email.empty() && roster)
        if (const Roster::Match match = roster->find(owner, grade.system); match.person)
          email = roster->people()[*match.person].email();
      const bool formula = starts_formula(email);
      book.all_entered &= !email.empty() && !formula;
      if (email.empty() || formula)
        book.said.push_back(grade.hand_in +
                            (formula ? ": a spreadsheet would run the e-mail address as a formula"
                                     : ": has no e-mail address") +
                            ", by which Autolab knows people; enter it by hand");
      else
        by_email[lowered(email)].emplace_back(&grade, email);
    }
  }
  for (const auto& [key, theirs] : by_email) {
    if (theirs.size() > 1) {
      book.all_entered = false;
      book.said.push_back(key + ": has several grades, " + theirs[0].first->hand_in + " and " +
                          theirs[1].first->hand_in + "; enter one by hand");
      continue;
    }
    const auto& [grade, email] = theirs.front();
    Cells cells{email};
    for (const std::string& problem : problems) {
      const auto found = std::ranges::find(grade->exercises, problem, &std::pair<std::string, double>::first);
      cells.push_back(grade->excused                    ? ""
                      : problem == "total"              ? shown_points(grade->points)
                      : found == grade->exercises.end() ? ""
                                                        : shown_points(found->second));
    }
    cells.emplace_back(grade->excused ? "excused" : "");
    book.csv += csv_line(cells);
    ++book.written;
    book.given.insert(grade->hand_in);
  }
  std::string order;
  for (const std::string& problem : problems) order += (order.empty() ? "" : ", ") + problem;
  book.said.push_back("Autolab reads values in the order of the lab's problems, which must be " + order);
  return book;
}

Gradebook plain_rows(const std::string& system, const Csv* exported, const std::vector<Grade>& grades,
                     const FillOptions& options) {
  const std::string not_for_import = "no import by " + system + " is confirmed: enter by hand";
  Gradebook book;
  book.csv = csv_line({"name", "id", "e-mail", "points", "of", "status", not_for_import});
  const auto add = [&](const std::string& name, const std::string& id, const std::string& email,
                       const Grade* grade) {
    Cells cells{composed(name), id, email, "", "", "no grade", ""};
    if (grade) {
      cells[3] = grade->excused ? "" : shown_points(grade->points);
      cells[4] = shown_points(grade->max_points);
      cells[5] = grade->excused ? "excused" : !grade->not_final.empty() ? "not final" : "graded";
      ++book.written;
      book.given.insert(grade->hand_in);
    }
    book.csv += csv_line(cells);
  };
  if (exported) {
    Filling filling(*exported, grades, options, {.system = system.c_str(), .title = exported->file});
    const Roster people(*exported);
    std::map<std::size_t, const Csv::Row*> rows;
    for (const Csv::Row& row : exported->rows) rows[row.line] = &row;
    for (const Person& person : people.people())
      add(person.name, person.shown_id(), person.email(), filling.at(*rows.at(person.line)));
    Gradebook filled = filling.book(std::move(book.csv));
    filled.written = book.written;
    filled.given = std::move(book.given);
    book = std::move(filled);
  } else {
    for (const Grade& grade : grades) {
      if (grade.owner.members.empty())
        add(grade.owner.name.empty() ? grade.hand_in : grade.owner.name, grade.owner.id, grade.owner.email,
            &grade);
      for (const Owner& member : grade.owner.members) add(member.name, member.id, member.email, &grade);
    }
  }
  book.said.push_back(not_for_import);
  return book;
}

}  // namespace grader::gradebook
