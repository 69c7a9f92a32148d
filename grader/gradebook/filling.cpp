// STAFF ONLY. Finds the rows of grades.
#include "grader/gradebook/filling.h"

#include <algorithm>

#include "grader/course/input.h"
#include "grader/intake/names/names.h"
#include "grader/report/facts/text.h"
#include "grader/text/letters.h"

namespace grader::inline gradebook {
namespace {

std::string called(const Grade& grade) {
  return grade.owner.name.empty() ? grade.hand_in : grade.hand_in + " (" + composed(grade.owner.name) + ")";
}

bool is_blank(const std::string& cell) {
  const std::string text = composed(cell);
  return text.empty() || text == "-";
}

bool are_equal(const std::string& one, const std::string& other) {
  const std::optional<double> number = number_in(one);
  return composed(one) == composed(other) || (number && number == number_in(other));
}

std::string points_for(const Grade& grade, std::optional<double> maximum, const ScoreColumn& column,
                       bool scale) {
  if (!maximum || *maximum == grade.max_points) return shown_points(grade.points);
  if (!scale)
    throw BadInput(column.title + ": is out of " + shown_points(*maximum) +
                   " points, and the grades are out of " + shown_points(grade.max_points) +
                   "; change it there, or give --scale for shares of its points");
  return shown_points(grade.max_points > 0 ? grade.points / grade.max_points * *maximum : 0);
}

}  // namespace

std::size_t wanted_column(const Csv& table, const std::function<std::optional<bool>(std::size_t)>& is_wanted,
                          const std::string& none, const std::string& missing, const std::string& several) {
  const Cells& head = table.rows.front().cells;
  std::vector<std::size_t> found;
  std::string known;
  for (std::size_t i = 0; i < head.size(); ++i) {
    const std::optional<bool> wanted = is_wanted(i);
    if (!wanted) continue;
    known += (known.empty() ? "\"" : ", \"") + composed(head[i]) + "\"";
    if (*wanted) found.push_back(i);
  }
  if (found.size() == 1) return found.front();
  throw BadInput(
      place_of(table, table.rows.front()) + ": " +
      (known.empty() ? none : (found.empty() ? missing : several) + "; give --column with one of " + known));
}

Filling::Filling(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options,
                 ScoreColumn column)
    : exported_(exported), options_(options), column_(std::move(column)), rows_(exported) {
  book_.said = rows_.said();
  const auto row_of = [&](const Owner& owner, const std::string& system) {
    Roster::Match match = rows_.find(owner, system);
    // A participant's number belongs to one assignment: in another one's worksheet it is somebody else's.
    if (system == "moodle" && match.has_other_name) match.person.reset();
    if (match.person || !options.roster) return match;
    const Roster::Match on_roster = options.roster->find(owner, system);
    return on_roster.person ? rows_.find(options.roster->people()[*on_roster.person]) : on_roster;
  };
  std::string first;
  std::map<std::string, std::vector<std::string>> not_final;
  for (const Grade& grade : grades) {
    const bool members = !grade.owner.members.empty();
    for (const Owner& owner : members ? grade.owner.members : std::vector{grade.owner}) {
      const Roster::Match match = row_of(owner, grade.system);
      const std::string who =
          called(grade) + (members ? ", " + composed(owner.name.empty() ? owner.id : owner.name) : "");
      if (match.person) by_person_[*match.person].push_back(&grade);
      if (!match.person) {
        book_.said.push_back(who + ": has no row in " + exported.file + ", " + match.told +
                             "; enter it by hand");
        if (first.empty()) first = who + ": " + match.told;
        book_.all_entered = false;
      } else if (!match.told.empty()) {
        book_.said.push_back(who + ": " + match.told);
      }
    }
    if (!grade.not_final.empty()) not_final[grade.not_final].push_back(called(grade));
  }
  for (const auto& [why, names] : not_final)
    book_.said.push_back(some_of(names) + (names.size() > 1 ? ": are" : ": is") + " not final, since " + why);
  if (by_person_.empty() && !grades.empty())
    throw BadInput(exported.file + ": nobody who has a grade here is in it (" + first +
                   "); give the table of this course and assignment, or --roster with ids of both");
  for (const auto& [person, theirs] : by_person_)
    if (theirs.size() > 1) {
      book_.all_entered = false;
      book_.said.push_back(exported.file + ", line " + std::to_string(rows_.people()[person].line) +
                           ": left as it is, for " + called(*theirs[0]) + " and " + called(*theirs[1]) +
                           " are both this person's; enter it by hand");
    }
}

const Grade* Filling::of(const Csv::Row& row) const {
  const std::optional<std::size_t> person = rows_.at_line(row.line);
  const auto found = person ? by_person_.find(*person) : by_person_.end();
  return found == by_person_.end() || found->second.size() > 1 ? nullptr : found->second.front();
}

const Grade* Filling::at(const Csv::Row& row) {
  const Grade* grade = of(row);
  if (grade == nullptr)
    without_.push_back("line " + std::to_string(row.line) + " (" + printable(row.at(0)) + ")");
  return grade;
}

// A cell that differs from our earlier gradebook was changed by a person.
bool Filling::may_replace(const Csv::Row& row, const Grade& grade, const std::string& cell,
                          const std::string& by) {
  const auto is_cell = [&](const std::string& text) { return are_equal(cell, text); };
  if (options_.overwrite || is_blank(cell) || is_cell(by) || std::ranges::any_of(grade.entered, is_cell))
    return true;
  say(place_of(exported_, row) + ": \"" + legible(composed(cell)) + "\" stays, which a person entered, and " +
      grade.hand_in + "'s \"" + legible(by, 40) +
      "\" is not entered; give --overwrite to replace such cells");
  book_.all_entered = false;
  return false;
}

std::optional<std::string> Filling::score(const Csv::Row& row, const std::string& cell,
                                          std::optional<double> maximum, const std::string& stays) {
  const Grade* grade = at(row);
  if (!grade) return {};
  std::string text = grade->excused ? column_.excused : points_for(*grade, maximum, column_, options_.scale);
  std::string why = stays;
  if (why.empty() && text.empty())
    why = std::string("it is excused, which ") + column_.system + " has no word for";
  const std::optional<double> points = number_in(text);
  if (why.empty() && column_.beyond_maximum && maximum && points && *points > *maximum)
    why = text + " is more than the maximum of " + shown_points(*maximum) + column_.beyond_maximum;
  if (!why.empty()) {
    say(place_of(exported_, row) + ": " + grade->hand_in + "'s grade is not entered: " + why);
    book_.all_entered = false;
    return {};
  }
  if (column_.comma) std::ranges::replace(text, '.', ',');
  if (!may_replace(row, *grade, cell, text)) return {};
  ++book_.written;
  book_.given.insert(grade->hand_in);
  if (std::ranges::count(grade->entered, text) == 0) book_.entered.emplace_back(grade->hand_in, text);
  return text;
}

std::optional<std::string> Filling::feedback(const Csv::Row& row, const std::string& cell) {
  const Grade& grade = *of(row);
  std::string text = options_.first_lines ? options_.first_lines(grade.hand_in) : "";
  if (text.empty() || !may_replace(row, grade, cell, text)) return {};
  if (std::ranges::count(grade.entered, text) == 0) book_.entered.emplace_back(grade.hand_in, text);
  return text;
}

Gradebook Filling::book(std::string csv) {
  if (!without_.empty())
    book_.said.push_back(std::to_string(without_.size()) +
                         (without_.size() == 1 ? " person has" : " people have") +
                         " no grade here, and their cells stay as they were: " + some_of(without_));
  book_.said.insert(book_.said.end(), notes_.begin(), notes_.end());
  book_.csv = std::move(csv);
  return std::move(book_);
}

}  // namespace grader::gradebook
