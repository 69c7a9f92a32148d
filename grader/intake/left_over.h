// STAFF ONLY. The files of the input that reached no hand-in that counts, as JSON for pages and programs: DIR/left-over.json.
#pragma once

#include <string>

#include "grader/intake/submission.h"

namespace grader {

inline constexpr const char* kLeftOver = "left-over.json";

// An object: "left_over", "older" and "made", each a list of {"path", "reason", "whose"}; and "notices", lines for staff.
std::string left_over_json(const Intake& intake);

}  // namespace grader
