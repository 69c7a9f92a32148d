// STAFF ONLY. Whose rows a run may replace in a folder of grades. An archive that one student hands in may
// hold folders with the names of others, or names as a learning system gives them, and then looks like a
// class. Names and numbers prove nothing: classmates know them.
//
// A hand-in replaces the row of its own path alone. In a folder with rows a class needs one of these to
// replace or add any:
//   - the path of the earlier class,
//   - most of the earlier class's hand-ins as they were, two at least, of those that no two have: nobody knows the bytes of most others,
//   - the caller's word (--class).
// If nobody of the earlier class is in it, --class alone says that it is a further one: people may have other
// numbers now. A row whose hand-in comes again with the same bytes loses nothing, whatever it came in.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/intake/submission.h"

namespace grader::inline tool {

struct CallersWord {
  IntakeChoices choices = {};
  bool class_over_rows = false;  // a class may replace and add rows
  bool replace = false;          // all rows may be replaced
};

// Lines for staff.
struct Settled {
  std::vector<std::string> replaced = {};  // a line for each row of another origin that the caller gives up
  std::vector<std::string> missing = {};  // a line about those of an earlier download who are not in this one
};

// A later download of a class gets the earlier one's origin, which its rows have. Throws Question, a line
// that names the rows, if the caller must say that they may be replaced or added. With `only` the row of this
// name alone is graded.
Settled settle_origins(const std::filesystem::path& folder, std::vector<Submission>& submissions,
                       const std::optional<std::string>& only, const CallersWord& word,
                       const std::string& hand_in = "");

}  // namespace grader::tool
