// STAFF ONLY. The rules of a hand-in, from the course file's "hand_in": the due date, the cost of lateness,
// and the share of extra credit that counts. They change totals and no category, so that they can change
// without grading again.
//
//   {"hand_in": {"due": "2025-03-04 23:59", "zone": "Europe/Berlin", "grace_minutes": 10, "free_days": 1,
//                "late_per_cent_a_day": 10, "late_of": "reached", "late_per_cent_at_most": 50,
//                "extra_credit_share": 0.2, "total_per_cent_at_most": 110}}
//
// The due date and times without an offset are on the clock of the course's zone (zone.h). A late day ends
// when that clock shows the due time again, so that a change of the clock costs nobody a day. The due minute
// itself is not late. "late_of": per cent of the points that the student has "reached", or of all that are
// "reachable"; never below 0 in all.
//
// "extra_credit_share": extra credit counts up to this share of the full points; a tenth without it, so that
// nobody mistakes a broken program's full points for a bug of the grader.
//
// Without "total_per_cent_at_most" the total counts up to 100 per cent: extra credit makes up for lost
// points, and most gradebooks would refuse or cut a total beyond the full points.
//
// "by_hand": {"oral": {"points": 10, "title": "Oral examination"}} adds a place to each result that a person
// gives points at. The total is not final before. Neither lateness nor the share of extra credit concerns it.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "grader/result/fields.h"
#include "grader/result/result.h"

namespace grader::inline record {

inline constexpr double kExtraCreditShare = 0.1;
// This is the share in a record that began before shares did.
inline constexpr double kAllExtraCredit = std::numeric_limits<double>::infinity();

enum class LateOf { reached, reachable };

std::string to_string(LateOf of);

struct ByHand {
  double points = 0;
  std::string title = {};  // "": its id

  bool operator==(const ByHand&) const = default;
};

struct HandInRules {
  std::string due = {};                     // "": there is no date, and nobody is late
  std::string zone = {};                    // "": times are taken as they are shown, and offsets are ignored
  std::vector<std::string> exercises = {};  // are those of a hand-in with a name, else empty
  std::string column = {};                  // is in the learning system's gradebook
  int grace_minutes = 0, free_days = 0;
  int free_days_in_all = 0;  // are the course's: hand-ins use them in the order of their due dates
  double late_per_cent_a_day = 0, late_per_cent_at_most = 100;
  LateOf late_of = LateOf::reached;
  std::optional<double> extra_credit_share = {};  // nothing: the record's
  double total_per_cent_at_most = 100;
  std::map<std::string, ByHand> by_hand = {};  // by id

  bool operator==(const HandInRules&) const = default;
};

}  // namespace grader::record

namespace grader {

template <>
inline constexpr LateOf kLast<LateOf> = LateOf::reachable;
template <>
struct Fields<ByHand> {
  static const Rows<ByHand>& rows();
};
template <>
struct Fields<HandInRules> {
  static const Rows<HandInRules>& rows();
};

}  // namespace grader

namespace grader::inline record {

// Reads the rules of an object like "hand_in" over `rules`. Throws BadInput, a line that names the place
// and what would be right.
void read_rules(const JsonValue& json, HandInRules& rules);

// Returns the result with the places for points by hand, where none are given yet.
SubmissionResult with_by_hand(const HandInRules& rules, SubmissionResult result);

// Returns the result with the extra credit that counts, and with a remark if that is not all. All of it
// counts where no other points can be reached.
SubmissionResult with_counted_extra_credit(const HandInRules& rules, SubmissionResult result);

// Returns how many days of the calendar `handed_in` (grader/text/time_text.h) is late; 0: it is not. Nothing
// without both times.
std::optional<int> late_days(const HandInRules& rules, const std::string& handed_in);

// These days are for one student, beyond the hand-in's own free ones.
struct MoreDays {
  double given = 0;     // by a person
  int left_of_all = 0;  // are the course's free days that earlier hand-ins left
};

// Returns how many of the course's free days a hand-in uses that is `late` days late.
int used_of_all(const HandInRules& rules, int late, const MoreDays& more);

// Takes a result before any rule.
Lateness lateness(const HandInRules& rules, SubmissionResult result, const std::string& handed_in,
                  const MoreDays& more);

// Returns the result with a line for each rule that changes its total.
SubmissionResult under(const HandInRules& rules, SubmissionResult result, const std::string& handed_in,
                       const MoreDays& more);

}  // namespace grader::record
