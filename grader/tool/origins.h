// STAFF ONLY. Whose rows a run may replace in a folder of grades: those of its own origins (grader/intake/origin.h). An archive that
// one student hands in may hold folders with the names of others, and then looks like a class.
//
// A hand-in has the same origin if the argument is the same path. A class has the same one if it is the same path, or a later
// download: of the same kind, and with everybody in it who came in the earlier one, two at least.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/intake/submission.h"

namespace grader {

// A later download of a class gets the earlier one's origin, which its rows have. Throws BadInput, a line that names the rows, if a
// row would be replaced by one of another origin and `replace` is false. If it is true, such rows are told, a line each.
std::vector<std::string> settle_origins(const std::filesystem::path& folder,
                                        std::vector<Submission>& submissions,
                                        const std::optional<std::string>& only, bool replace,
                                        const std::string& hand_in = "");

}  // namespace grader
