// STAFF ONLY. The common part of gradebooks that are filled in: it matches rows and grades, writes points as
// the column wants them, and keeps other cells.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "grader/intake/names/owner.h"
#include "grader/roster/roster.h"
#include "grader/text/csv.h"

namespace grader::inline gradebook {

// This is a grade for a learning system.
struct Grade {
  std::string hand_in;  // is the submission's name, and its folder among the reports
  Owner owner;
  std::string system;  // is the layout of the hand-in, see Roster::find
  double points = 0, max_points = 0;
  std::vector<std::pair<std::string, double>> exercises{};  // id, points
  bool excused = false;
  std::string not_final{};             // why, "the clock ended a part of it"; "": it is final
  std::vector<std::string> entered{};  // are cells that gradebooks got so far
};

// This is a file for a learning system.
struct Gradebook {
  std::string csv;
  std::vector<std::string>
      said{};  // for staff, a line each: omissions, effects of the importer, rules without a source
  std::size_t written = 0;                                     // counts its grades
  std::set<std::string> given{};                               // are the hand-ins that these are of
  bool all_entered = true;                                     // false: a person must read the lines
  std::vector<std::pair<std::string, std::string>> entered{};  // hand-in, cell
};

struct FillOptions {
  // This is the column's title, or its number in Canvas and Blackboard; "": the only column.
  std::string column = {};
  // Scales points to the column's maximum. Without it a maximum that differs is an error.
  bool scale = false;
  // Finds people whose hand-ins came by another system, by an id that both tables have.
  const Roster* roster = nullptr;
  // Also replaces cells that a person filled in.
  bool overwrite = false;
  // Returns the first lines of a report, for systems whose table takes them.
  std::function<std::string(const std::string& hand_in)> first_lines = {};
};

// Describes how a system takes scores.
struct ScoreColumn {
  const char* system;                    // "Moodle's worksheet", for messages
  std::string title;                     // "the column \"Lab 3 (8801)\"", for messages
  std::string excused = {};              // is its word; "": it has none
  bool comma = false;                    // separates decimals
  const char* beyond_maximum = nullptr;  // why more than the maximum is not entered; null: it is
};

// Returns the place of the one title that is wanted. `is_wanted` returns nothing for a column that is not for
// grades. Throws BadInput: `none` if no column is for grades, and else a line with all of them, which begins
// with `missing` if none is wanted, or with `several`.
std::size_t wanted_column(const Csv& table, const std::function<std::optional<bool>(std::size_t)>& is_wanted,
                          const std::string& none, const std::string& missing, const std::string& several);

class Filling {
 public:
  // Throws BadInput if no grade has a row: the table is another course's.
  Filling(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options,
          ScoreColumn column);

  // Returns the new cell of scores in a row; nothing if the cell stays, and then a line gives the reason. A
  // person with several rows has the grade in each. `stays` says why the system leaves this cell alone; "":
  // it does not. Throws BadInput, without `scale`, if the grade has another maximum; if the column has none,
  // points stay unchanged.
  std::optional<std::string> score(const Csv::Row& row, const std::string& cell,
                                   std::optional<double> maximum, const std::string& stays = "");
  // Does the same for a cell of words, if a score is entered.
  std::optional<std::string> feedback(const Csv::Row& row, const std::string& cell);

  void say(std::string line) { notes_.push_back(std::move(line)); }

  // Returns the grade of a row, and marks it as used; null if there is none, or more than one.
  const Grade* at(const Csv::Row& row);

  // Returns the gradebook with its lines: grades without a row, rows without a grade, cells that stay, and
  // other remarks.
  Gradebook book(std::string csv);

 private:
  const Grade* of(const Csv::Row& row) const;
  bool may_replace(const Csv::Row& row, const Grade& grade, const std::string& cell, const std::string& by);

  const Csv& exported_;
  const FillOptions& options_;
  const ScoreColumn column_;
  const Roster rows_;
  std::map<std::size_t, std::vector<const Grade*>> by_person_;
  std::vector<std::string> notes_;
  std::vector<std::string> without_;  // rows without a grade, for people
  Gradebook book_;
};

// The assignment's column is found by its number or title, and never made. Titles, the row of points and all
// cells that are no score of this column stay; "EX" and "N/A" do, too. Throws BadInput for a table that is no
// export of Canvas.
Gradebook fill_canvas(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options);

// Titles are in the downloader's language: if they are not English, columns are found by form
// (roster/worksheet.h), and `options.column` names the one of grades if that fails. Rows that Moodle locks,
// and grades beyond its maximum, stay unchanged and are reported.
Gradebook fill_moodle(const Csv& worksheet, const std::vector<Grade>& grades, const FillOptions& options);

// Keeps the download's encoding and separator; rows without a grade keep their bytes. The column is found by
// its number or title, and has a number. Words stay in cells, but for "Needs Grading"; if there is a
// column "Feedback to Learner", the first lines of the report go there.
Gradebook fill_blackboard(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options);

// Writes Brightspace's import: its ids as exported, the points of an existing item, and its mark at the
// end of each row.
Gradebook fill_brightspace(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options);

// Writes Autolab's bulk grades: no titles; e-mail, a value for each of the lab's problems in their order,
// "excused". `problems` are ids of exercises, or "total".
Gradebook autolab_rows(const std::vector<Grade>& grades, const std::vector<std::string>& problems,
                       const Roster* roster);

// Lists everybody of the exported table, or without one everybody with a grade, for people. No source
// confirms an import by `system`, and the table says so.
Gradebook plain_rows(const std::string& system, const Csv* exported, const std::vector<Grade>& grades,
                     const FillOptions& options);

}  // namespace grader::gradebook
