// STAFF ONLY. A table of times of hand-ins, for downloads that have none (Canvas, Moodle): a row for each
// person, as in a roster (roster.h), and a column of times. Moodle's grading worksheet is such a table, in
// any language whose times are read (text/time_text.h).
#pragma once

#include <string>
#include <vector>

#include "grader/roster/roster.h"

namespace grader::inline roster {

class Times {
 public:
  // Throws BadInput as Roster does, and for a table without a column of times or without a readable time.
  explicit Times(Csv table);

  // Returns the time as the table has it; "-" for a person without one, and "" for a person who is missing or
  // whose time can't be read. For a group it is the members' latest. People are found as on a roster; with
  // one, also by the ids that both tables have.
  std::string find(const std::string& hand_in, const Owner& owner, const std::string& system,
                   const Roster* roster);

  // Returns lines for staff, after the search for all hand-ins: guesses, hand-ins that were not found,
  // unreadable times, and people with a time and no hand-in.
  std::vector<std::string> said() const;

 private:
  std::string time_of(std::size_t person);

  Csv table_;
  std::size_t column_;
  Roster people_;
  std::vector<bool> found_;  // by person
  std::vector<std::string> said_;
};

}  // namespace grader::roster
