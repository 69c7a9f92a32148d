// STAFF ONLY. Decides which submissions a run may replace in a folder of grades. An archive that one student
// hands in may hold folders with the names of others, or names as a learning system gives them, and then
// looks like a class. Names and numbers prove nothing: classmates know them.
//
// A hand-in replaces the submission of its own path alone. A class may replace or add submissions in a folder
// that has some if
// - it has the path of the earlier class, or
// - it has most of the earlier class's unique hand-ins unchanged, at least two: nobody else knows their
// bytes, or
// - the caller says so (--class).
// If nobody of the earlier class is in it, only --class makes it a further class: people may have other
// numbers now. A submission that comes again with the same bytes loses nothing, whatever it came in.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/intake/submission.h"

namespace grader::inline class_folder {

struct CallersWord {
  IntakeChoices choices = {};
  bool class_over_rows = false;  // a class may replace and add submissions
  bool replace = false;          // all submissions may be replaced
};

// Holds lines for staff.
struct Settled {
  std::vector<std::string> replaced = {};  // a line for each replaced submission of another origin
  std::vector<std::string> missing = {};   // a line about students of an earlier download that this one lacks
};

// A later download of a class gets the earlier one's origin, which its submissions have. Throws Question, a
// line that names the submissions, if the caller must confirm that they may be replaced or added. With `only`
// just the submission of this name is graded.
Settled settle_origins(const std::filesystem::path& folder, std::vector<Submission>& submissions,
                       const std::optional<std::string>& only, const CallersWord& word,
                       const std::string& hand_in = "");

}  // namespace grader::class_folder
