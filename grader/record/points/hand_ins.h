// STAFF ONLY. The hand-ins of a course, from the course file: eight weeks are several hand-ins with one
// record.
//
// {"exercises": {}, "hand_in": {"zone": "Europe/Berlin", "late_per_cent_a_day": 10, "free_days_in_all": 5},
//  "hand_ins": {"week 1": {"exercises": ["S1"], "due": "2025-03-04 23:59"},
//   "week 3": {"exercises": ["H1"], "due": "2025-03-18 23:59", "column": "Week 3 (4711)", "free_days": 1}}}
//
// "hand_in" has the common rules (rules.h), and each hand-in can add to them or replace them. An exercise is
// in one hand-in. Without "hand_ins" the course has one, of all exercises, and no name.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/course/course.h"
#include "grader/record/points/rules.h"

namespace grader::inline record {

struct CourseHandIn {
  std::string name;  // "": the course has one
  HandInRules rules;
};

// Sorts by name. Throws BadInput, a line that names the place and what would be right.
std::vector<CourseHandIn> read_hand_ins(const Course& course,
                                        const std::optional<std::filesystem::path>& course_json);

// Returns the one with this name. Throws BadInput with all names.
CourseHandIn read_hand_in(const Course& course, const std::optional<std::filesystem::path>& course_json,
                          const std::string& name);

// Throws BadInput if `name` is not in `names`, or if it is set and `names` is empty. `where` has the names.
void check_hand_in(const std::string& name, const std::vector<std::string>& names, const std::string& where);

// Returns the folder of its pages below the record's: ASCII letters, digits, '-' and '_'. "" for "".
std::string folder_of_hand_in(const std::string& name);

}  // namespace grader::record
