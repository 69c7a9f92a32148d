// STAFF ONLY. The files of the input that are in no hand-in that counts, for the record, pages and programs:
// DIR/left-over.json.
#pragma once

#include <string>
#include <vector>

#include "grader/intake/submission.h"

namespace grader::inline intake {

inline constexpr const char* kLeftOver = "left-over.json";

// Writes the line for staff about a file that is left over.
std::string line_about(const Accounted& left_over);

// Lists all files except those of hand-ins, and the notices about no file.
std::vector<Accounted> listed(const Intake& intake);

// Writes an object: "left_over", "older" and "made", each a list of {"path", "reason", "whose"}; and
// "notices", lines for staff.
std::string left_over_json(const std::vector<Accounted>& listed);

}  // namespace grader::intake
