// STAFF ONLY. The plan of a run of grading: the submissions, and their rows in a folder of grades. It is made
// once, while no other hairgrade can write to the folder, and then carried out (batch.h).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/class_folder/origins.h"
#include "grader/intake/submission.h"
#include "grader/record/points/rules.h"
#include "grader/record/record.h"
#include "grader/roster/roster.h"

namespace grader::inline class_folder {

struct BatchSettings {
  std::filesystem::path out;
  int jobs = 1;
  bool resume = false;              // keeps results whose fingerprint has not changed
  std::optional<std::string> only;  // grades only the submission with this name, its own or its row's
  CallersWord word = {};            // is the caller's word about submissions that may be replaced
  std::optional<Roster> roster;     // replaces the record's
  bool blind = false;               // names are codes; a record that began so stays so
  std::string hand_in = {};         // is its name in the record, "" if the course has one
  HandInRules rules = {};           // come from the course file: lateness, and how much extra credit counts
  bool regrade = false;             // the record's results change places with new ones once all are there
  bool merge = false;               // only one exercise is graded: earlier results of the others stay
  double seconds_before = 0;        // is the wall time that others have spent on its hand-ins
};

struct Plan {
  std::vector<Submission> submissions;      // have the names of their rows, and are sorted by these
  std::optional<std::string> only = {};     // grades only the submission of this row
  bool blind = false;                       // names are codes
  std::vector<Accounted> listed = {};       // are files of the input that reached no hand-in
  std::vector<std::string> replaced = {};   // a line for each replaced submission of another origin
  std::vector<std::string> taken_for = {};  // say to staff how arguments were read
  std::vector<std::string> notices = {};    // a person must look at these
  std::vector<std::string> remarks = {};    // are other lines for staff
};

// Gives groups their members from the roster, see grader/roster/groups.h; remarks say what was found, and a
// person must look at notices.
void give_members(Intake& intake, const Roster& roster);

// Gives submissions the names that they have in the record (grader/record/same_people.h), and sorts by them;
// `listed` gets them, too. In blind grading names are codes already. Returns a line each for staff. `only`, a
// name of one of them, becomes the record's.
std::vector<std::string> keep_rows(std::vector<Submission>& submissions, std::vector<Accounted>& listed,
                                   Record& record, std::optional<std::string>& only);

// Writes nothing into `record`, which is the folder's. `known` are the people of the class: the new roster,
// or else the record's. Throws BadInput if settings.only names no submission, and Question as settle_origins
// does.
Plan plan_of(Intake intake, Record& record, const std::optional<Roster>& known,
             const BatchSettings& settings);

}  // namespace grader::class_folder
