// STAFF ONLY. What all gradebooks that are filled in have in common: whose row is whose, points as the column
// wants them, and which cells stay as they are.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grader/gradebook/grade.h"
#include "grader/roster/roster.h"
#include "grader/text/csv.h"
#include "grader/text/number.h"

namespace grader::inline gradebook {

struct FillOptions {
  // The column's title, or its number in Canvas and Blackboard; "": the only one that there is.
  std::string column = {};
  // Points become a share of the column's maximum. Without it a maximum that differs is an error.
  bool scale = false;
  // Finds people whose hand-ins came by another system, by an id that both tables have.
  const Roster* roster = nullptr;
  // Cells that a person filled in are replaced, too.
  bool overwrite = false;
  // The first lines of a report, for systems whose table takes them.
  std::function<std::string(const std::string& hand_in)> first_lines = {};
};

// How a system takes scores.
struct ScoreColumn {
  const char* system;                    // "Moodle's worksheet", for messages
  std::string title;                     // "the column \"Lab 3 (8801)\"", for messages
  std::string excused = {};              // its word; "": it has none
  bool comma = false;                    // of decimals
  const char* beyond_maximum = nullptr;  // why more than the maximum is not entered; null: it is
};

class Filling {
 public:
  // Throws BadInput if no grade has a row: the table is another course's.
  Filling(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options,
          ScoreColumn column);

  // The cell of scores in a row, as it becomes; nothing if it stays, for a reason that is said. Somebody with
  // several rows has the grade in each. `stays`: why the system leaves this cell alone; "": it does not.
  // Throws BadInput, without `scale`, if the grade is out of another maximum; without one points are as they
  // are.
  std::optional<std::string> score(const Csv::Row& row, const std::string& cell,
                                   std::optional<double> maximum, const std::string& stays = "");
  // Likewise a cell of words, where a score is entered.
  std::optional<std::string> feedback(const Csv::Row& row, const std::string& cell);

  void say(std::string line) { notes_.push_back(std::move(line)); }

  // The grade of a row, which is asked once; null if there is none, or more than one.
  const Grade* at(const Csv::Row& row);

  // With all that is said: grades that have no row, rows that have no grade, cells that stay, and what else
  // was said.
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
  std::size_t without_ = 0;
  Gradebook book_;
};

}  // namespace grader::gradebook
