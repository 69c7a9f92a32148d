// STAFF ONLY. A table of times of hand-ins, for downloads that have none (Canvas, Moodle): a row for each
// person, as in a roster (roster.h), and a column of times. Moodle's grading worksheet is such a table, in
// any language whose times are read (text/time_text.h).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/roster/roster.h"

namespace grader::inline roster {

class Times {
 public:
  // Throws BadInput as Roster does, and for a table without a column of times or without one that is read.
  explicit Times(Csv table);

  // The time as the table has it; "-" for somebody in it without one, and "" for somebody who is not in it or
  // has one that can't be read. Of a group the latest of its members'. People are found as on a roster; with
  // one, also by the ids that both tables have.
  std::string find(const std::string& hand_in, const Owner& owner, const std::string& system,
                   const Roster* roster);

  // For staff, a line each, once all hand-ins were looked for: what was guessed, hand-ins that are not found,
  // times that are not read, and people with a time and no hand-in.
  std::vector<std::string> said() const;

 private:
  std::string time_of(std::size_t person);

  Csv table_;
  std::size_t column_;
  Roster people_;
  std::vector<bool> found_;  // by person
  std::vector<std::string> said_;
};

Times read_times(const std::filesystem::path& file);

}  // namespace grader::roster
