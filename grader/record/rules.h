// STAFF ONLY. The rules of a hand-in, from the course file's "hand_in": when it is due, what lateness costs, and how much extra credit
// counts. They change totals and no category, so that they can change without grading again.
//
//   {"hand_in": {"due": "2025-03-04 23:59", "zone": "Europe/Berlin", "grace_minutes": 10, "free_days": 1,
//                "late_per_cent_a_day": 10, "late_of": "reached", "late_per_cent_at_most": 50, "total_per_cent_at_most": 110}}
//
// The due date is one of the clock in the course's zone (zone.h), and so are times without an offset. A late day ends when that clock
// shows the due time again, so that a change of the clock costs nobody a day. Within the due minute is not late.
//
// "late_of": per cent of the points that the student has "reached", or of all that are "reachable"; never below 0 in all.
//
// Without "total_per_cent_at_most" the total counts up to 100 per cent: extra credit makes up for points that were lost elsewhere, and
// a total beyond the full points would be refused or cut by most gradebooks.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "grader/result/fields.h"
#include "grader/result/lateness.h"
#include "grader/result/result.h"

namespace grader {

enum class LateOf { reached, reachable };

std::string to_string(LateOf of);

struct HandInRules {
  std::string due = {};   // "": there is no date, and nobody is late
  std::string zone = {};  // "": times are taken as they are shown, and offsets are not looked at
  int grace_minutes = 0, free_days = 0;
  double late_per_cent_a_day = 0, late_per_cent_at_most = 100;
  LateOf late_of = LateOf::reached;
  double total_per_cent_at_most = 100;

  bool operator==(const HandInRules&) const = default;
};

template <>
inline constexpr LateOf kLast<LateOf> = LateOf::reachable;
template <>
struct Fields<HandInRules> {
  static const Rows<HandInRules>& rows();
};

// Reads those of a course file; the default ones without "hand_in". Throws BadInput, a line that names the place and what would be right.
HandInRules read_rules(const std::optional<std::filesystem::path>& course_json);

// How many days of the calendar `handed_in` (grader/text/time_text.h) is late; 0: it is not. Nothing without both times.
std::optional<int> late_days(const HandInRules& rules, const std::string& handed_in);

// Of a result before any rule.
Lateness lateness(const HandInRules& rules, SubmissionResult result, const std::string& handed_in,
                  double more_days);

// The result with a line for each rule that changes its total. `more_days`: what a person has given.
SubmissionResult under(const HandInRules& rules, SubmissionResult result, const std::string& handed_in,
                       double more_days);

}  // namespace grader
