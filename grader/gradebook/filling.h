// STAFF ONLY. What all gradebooks that are filled in have in common: whose row is whose, and points as the column wants them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/gradebook/grade.h"
#include "grader/roster/roster.h"
#include "grader/text/csv.h"
#include "grader/text/number.h"

namespace grader {

struct FillOptions {
  // The column's title, or its number in Canvas; "": the only one that there is.
  std::string column;
  // Points become a share of the column's maximum. Without it a maximum that differs is an error.
  bool scale = false;
  // Finds people whose hand-ins came by another system, by an id that both tables have.
  const Roster* roster = nullptr;
};

class Filling {
 public:
  Filling(const Csv& exported, const std::vector<Grade>& grades, const FillOptions& options);

  // The grade for a row of the table; null if there is none, or more than one.
  const Grade* at(const Csv::Row& row) const;

  // The points for a column with this maximum, with at most two decimals and a point. Throws BadInput, without `scale`, if the grade is
  // out of another one. No maximum: as they are.
  std::string points(const Grade& grade, std::optional<double> maximum, const std::string& where) const;

  // Grades that have no row, each a line, and how many rows have no grade.
  std::vector<std::string> said(std::size_t rows_without) const;

 private:
  std::map<std::size_t, std::vector<const Grade*>> by_line_;
  std::vector<std::string> said_;
  bool scale_;
};

}  // namespace grader
