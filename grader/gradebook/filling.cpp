// STAFF ONLY. Grades find their rows.
#include "grader/gradebook/filling.h"

#include <algorithm>

#include "grader/course/input.h"
#include "grader/report/text.h"
#include "grader/text/letters.h"

namespace grader {
namespace {

std::string called(const Grade& grade) {
  return grade.owner.name.empty() ? grade.hand_in : grade.hand_in + " (" + composed(grade.owner.name) + ")";
}

}  // namespace

Filling::Filling(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options)
    : said_(exported.said), scale_(options.scale) {
  const Roster rows(exported);
  const auto row_of = [&](const Owner& owner, const std::string& system) {
    Roster::Match match = rows.find(owner, system);
    if (match.person || !options.roster) return match;
    const Roster::Match on_roster = options.roster->find(owner, system);
    return on_roster.person ? rows.find(options.roster->people()[*on_roster.person]) : on_roster;
  };
  for (const Grade& grade : grades) {
    const bool members = !grade.owner.members.empty();
    for (const Owner& owner : members ? grade.owner.members : std::vector{grade.owner}) {
      const Roster::Match match = row_of(owner, grade.system);
      const std::string who =
          called(grade) + (members ? ", " + composed(owner.name.empty() ? owner.id : owner.name) : "");
      if (match.person) by_line_[rows.people()[*match.person].line].push_back(&grade);
      if (!match.person)
        said_.push_back(who + ": has no row in " + exported.file + ", " + match.told + "; enter it by hand");
      else if (!match.told.empty())
        said_.push_back(who + ": " + match.told);
    }
    if (grade.not_final)
      said_.push_back(called(grade) + ": is not final, since the clock ended a part of it");
  }
  for (const auto& [line, theirs] : by_line_)
    if (theirs.size() > 1)
      said_.push_back(exported.file + ", line " + std::to_string(line) + ": left as it is, for " +
                      called(*theirs[0]) + " and " + called(*theirs[1]) +
                      " are both this person's; enter it by hand");
}

const Grade* Filling::at(const Csv::Row& row) const {
  const auto found = by_line_.find(row.line);
  return found == by_line_.end() || found->second.size() > 1 ? nullptr : found->second.front();
}

std::string Filling::points(const Grade& grade, std::optional<double> maximum,
                            const std::string& where) const {
  if (!maximum || *maximum == grade.max_points) return shown_points(grade.points);
  if (!scale_)
    throw BadInput(where + ": is out of " + shown_points(*maximum) + " points, and the grades are out of " +
                   shown_points(grade.max_points) +
                   "; change it there, or give --scale for shares of its points");
  return shown_points(grade.max_points > 0 ? grade.points / grade.max_points * *maximum : 0);
}

std::vector<std::string> Filling::said(std::size_t rows_without) const {
  std::vector<std::string> all = said_;
  if (rows_without > 0)
    all.push_back(std::to_string(rows_without) + (rows_without == 1 ? " person has" : " people have") +
                  " no grade here; their cells stay as they were");
  return all;
}

}  // namespace grader
