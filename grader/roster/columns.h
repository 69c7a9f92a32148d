// STAFF ONLY. The columns of a roster, by learning systems' titles.
#pragma once

#include <optional>

#include "grader/roster/person.h"
#include "grader/text/csv.h"

namespace grader::inline roster {

class RosterColumns {
 public:
  // Throws BadInput if no title is known.
  explicit RosterColumns(const Csv& table);

  // Returns nobody for rows that are not about a person: Canvas's points, and rows without id and name.
  // `said` gets a line for each id that a spreadsheet has changed; such an id is left out.
  std::optional<Person> person(const Csv& table, const Csv::Row& row, std::vector<std::string>& said) const;

 private:
  std::array<std::size_t, kIdKinds> ids_;
  std::size_t name_, first_name_, last_name_, section_, group_;
};

}  // namespace grader::roster
