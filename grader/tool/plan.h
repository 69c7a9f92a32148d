// STAFF ONLY. The plan of a run of grading: the submissions, and the rows of a folder of grades that they
// get. It is made once, while no other hairgrade can write to the folder, and then carried out (batch.h).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/intake/submission.h"
#include "grader/record/record.h"
#include "grader/record/rules.h"
#include "grader/roster/roster.h"
#include "grader/tool/origins.h"

namespace grader::inline tool {

struct BatchSettings {
  std::filesystem::path out;
  int jobs = 1;
  bool resume = false;              // keep results whose fingerprint has not changed
  std::optional<std::string> only;  // grade only the submission of this name, its own or its row's
  CallersWord word = {};            // about rows that may be replaced
  std::optional<Roster> roster;     // replaces the record's
  bool blind = false;               // names are codes; a record that began so stays so
  std::string hand_in = {};         // its name in the record, "" where the course has one
  HandInRules rules = {};           // of the course file: lateness, and how much extra credit counts
  bool merge = false;               // only one exercise is graded: keep the earlier results of the others
};

struct Plan {
  std::vector<Submission> submissions;      // named as their rows, and sorted by that
  std::optional<std::string> only = {};     // grade only the submission of this row
  bool blind = false;                       // names are codes
  std::vector<Accounted> listed = {};       // files of the input that reached no hand-in
  std::vector<std::string> replaced = {};   // a line for each row of another origin that is given up
  std::vector<std::string> taken_for = {};  // lines for staff: how arguments were read,
  std::vector<std::string> notices = {};    // where a person must look,
  std::vector<std::string> remarks = {};    // and others
};

// Writes nothing into `record`, which is that of the folder. `known` are the people of the class: the new
// roster, or else the record's. Throws BadInput if settings.only names no submission, and Question as
// settle_origins does.
Plan plan_of(Intake intake, Record& record, const std::optional<Roster>& known,
             const BatchSettings& settings);

}  // namespace grader::tool
