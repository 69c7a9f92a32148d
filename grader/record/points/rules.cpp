// STAFF ONLY. Reads the rules of a hand-in, and applies them to a total.
#include "grader/record/points/rules.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <iterator>

#include "grader/course/input.h"
#include "grader/record/points/shown_number.h"
#include "grader/record/points/zone.h"
#include "grader/result/json_fields.h"
#include "grader/text/letters.h"
#include "grader/text/time_text.h"

namespace grader::inline record {
namespace {

constexpr int kMinutesADay = 24 * 60;
constexpr std::size_t kDueLength = std::size("2025-03-04 23:59") - 1;

std::chrono::minutes minutes_of(std::chrono::seconds time) {
  return std::chrono::floor<std::chrono::minutes>(time);
}

std::string days(double count) {
  return shown_number(count) + (count == 1 ? " day" : " days");
}

double per_cent_of(const HandInRules& rules, const Lateness& late) {
  return std::min(rules.late_per_cent_at_most, (late.days - late.free_days) * rules.late_per_cent_a_day);
}

// Takes a result with the extra credit that counts.
Lateness lateness_of(const HandInRules& rules, const SubmissionResult& result, const std::string& handed_in,
                     const MoreDays& more) {
  const std::optional<TimeText> time = read_time(handed_in);
  Lateness late{.handed_in = time ? shown_on_clock_of(*time, rules.zone) : handed_in,
                .days = late_days(rules, handed_in).value_or(0)};
  late.free_days =
      std::min<double>(rules.free_days + more.given + used_of_all(rules, late.days, more), late.days);
  const double per_cent = per_cent_of(rules, late);
  const double base = rules.late_of == LateOf::reached ? points(result) : max_points(result);
  late.taken = std::min(points(result), base * per_cent / 100);
  return late;
}

void take_off_for_lateness(const HandInRules& rules, SubmissionResult& result, const std::string& handed_in,
                           const MoreDays& more) {
  if (!late_days(rules, handed_in)) return;
  const Lateness late = lateness_of(rules, result, handed_in, more);
  if (rules.free_days_in_all > 0)
    result.remarks.push_back(std::to_string(more.left_of_all - used_of_all(rules, late.days, more)) +
                             " of the course's " + days(rules.free_days_in_all) +
                             " without a deduction are left after this hand-in");
  if (late.days == 0) return;
  std::string reason = "Late by " + days(late.days) + ", handed in " + late.handed_in + ", due " + rules.due;
  if (late.free_days > 0) reason += ", " + days(late.free_days) + " of them free";
  reason += "; " + shown_number(per_cent_of(rules, late)) + " per cent of the points " +
            to_string(rules.late_of) + " are taken off";
  result.adjustments.push_back({reason, -late.taken});
}

// Ids are places, columns and parts of pages' links.
bool is_id(const std::string& id) {
  return !id.empty() && id != "all" && id.size() <= 20 &&
         std::isalpha(static_cast<unsigned char>(id.front())) != 0 &&
         std::ranges::all_of(id,
                             [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
}

void check_by_hand(const JsonValue& json, const std::map<std::string, ByHand>& all) {
  constexpr double kMost = 1e6;
  for (const auto& [id, one] : all) {
    if (!is_id(id)) json[id].fail("is no id; write up to 20 letters and digits, such as \"oral\"");
    if (!(one.points > 0 && one.points <= kMost))
      json[id]["points"].fail(json[id]["points"].shown() + " is not right; write a number above 0");
    if (legible(one.title) != one.title) json[id]["title"].fail("is no title; write one line of text");
  }
}

std::vector<ExerciseResult> taken_out_by_hand(SubmissionResult& result) {
  const auto first =
      std::stable_partition(result.exercises.begin(), result.exercises.end(), std::not_fn(is_by_hand));
  std::vector<ExerciseResult> by_hand(std::make_move_iterator(first),
                                      std::make_move_iterator(result.exercises.end()));
  result.exercises.erase(first, result.exercises.end());
  return by_hand;
}

}  // namespace

SubmissionResult with_by_hand(const HandInRules& rules, SubmissionResult result) {
  for (const auto& [id, one] : rules.by_hand) {
    ExerciseResult place;
    place.id = id;
    place.title = one.title.empty() ? id : one.title;
    place.status = Status::not_given;
    place.max_points = one.points;
    result.exercises.push_back(std::move(place));
  }
  return result;
}

std::string to_string(LateOf of) {
  return of == LateOf::reached ? "reached" : "reachable";
}

}  // namespace grader::record

namespace grader {

const Rows<ByHand>& Fields<ByHand>::rows() {
  using T = ByHand;
  static const Rows<T> all = {field("points", &T::points),
                              field<T>("title", &T::title, [](const T& one) { return !one.title.empty(); })};
  return all;
}

const Rows<HandInRules>& Fields<HandInRules>::rows() {
  using T = HandInRules;
  const auto changed = [](auto member) {
    return [member](const T& rules) { return rules.*member != T{}.*member; };
  };
  static const Rows<T> all = {
      field<T>("due", &T::due, changed(&T::due)),
      field<T>("zone", &T::zone, changed(&T::zone)),
      field<T>("exercises", &T::exercises, changed(&T::exercises)),
      field<T>("column", &T::column, changed(&T::column)),
      field<T>("grace_minutes", &T::grace_minutes, changed(&T::grace_minutes)),
      field<T>("free_days", &T::free_days, changed(&T::free_days)),
      field<T>("free_days_in_all", &T::free_days_in_all, changed(&T::free_days_in_all)),
      field<T>("late_per_cent_a_day", &T::late_per_cent_a_day, changed(&T::late_per_cent_a_day)),
      field<T>("late_of", &T::late_of, changed(&T::late_of)),
      field<T>("late_per_cent_at_most", &T::late_per_cent_at_most, changed(&T::late_per_cent_at_most)),
      field<T>("extra_credit_share", &T::extra_credit_share, changed(&T::extra_credit_share)),
      field<T>("total_per_cent_at_most", &T::total_per_cent_at_most, changed(&T::total_per_cent_at_most)),
      field<T>("by_hand", &T::by_hand, changed(&T::by_hand))};
  return all;
}

}  // namespace grader

namespace grader::inline record {

void read_rules(const JsonValue& json, HandInRules& rules) {
  from_json_value(rules, json, {});
  const auto expect = [&](const char* key, double value, double most) {
    if (!(value >= 0 && value <= most))
      json[key].fail(json[key].shown() + " is not right; write a number from 0 to " + shown_number(most));
  };
  if (!rules.due.empty() && (!read_time(rules.due) || rules.due.size() != kDueLength))
    json["due"].fail(json["due"].shown() + " is no time; write one such as \"2025-03-04 23:59\"");
  if (json.has("zone") && !is_zone(rules.zone))
    json["zone"].fail(json["zone"].shown() + " is no time zone; write its name, such as \"Europe/Berlin\"");
  expect("grace_minutes", rules.grace_minutes, kMinutesADay);
  expect("free_days", rules.free_days, 366);
  expect("free_days_in_all", rules.free_days_in_all, 366);
  expect("late_per_cent_a_day", rules.late_per_cent_a_day, 100);
  expect("late_per_cent_at_most", rules.late_per_cent_at_most, 100);
  if (rules.extra_credit_share) expect("extra_credit_share", *rules.extra_credit_share, 1);
  expect("total_per_cent_at_most", rules.total_per_cent_at_most, 1000);
  if (json.has("by_hand")) check_by_hand(json["by_hand"], rules.by_hand);
}

SubmissionResult with_counted_extra_credit(const HandInRules& rules, SubmissionResult result) {
  const double full = max_points(result), reached = points(result), extra = extra_credit(result);
  if (full <= 0) return result;
  const double share = rules.extra_credit_share.value_or(kExtraCreditShare),
               most = full * rules.total_per_cent_at_most / 100,
               counts = counted(extra, reached - extra, full * share, most);
  if (counts >= extra) return result;
  result.extra_credit_counted = counts;
  const double total = points(result);
  result.remarks.push_back("You reached " + shown_number(reached) + " points with extra credit, and " +
                           shown_number(total) + " of them count: " +
                           (total < most
                                ? "extra credit adds at most " + shown_number(full * share) + " points, " +
                                      shown_number(100 * share) + " per cent of " + shown_number(full)
                                : "no total is above " + shown_number(most)));
  return result;
}

std::optional<int> late_days(const HandInRules& rules, const std::string& handed_in) {
  const std::optional<TimeText> due = read_time(rules.due), then = read_time(handed_in);
  if (!due || !then) return {};
  const auto minute = [&](const TimeText& time, Twice twice) {
    return minutes_of(moment_of(time, rules.zone, twice).time_since_epoch());
  };
  if (minute(*then, Twice::earlier) - minute(*due, Twice::later) <= std::chrono::minutes(rules.grace_minutes))
    return 0;
  const auto on_clock = [&](const TimeText& time) { return minutes_of(on_clock_of(time, rules.zone)); };
  const std::int64_t late = (on_clock(*then) - on_clock(*due)).count();
  return std::max(1, static_cast<int>((late + kMinutesADay - 1) / kMinutesADay));
}

Lateness lateness(const HandInRules& rules, SubmissionResult result, const std::string& handed_in,
                  const MoreDays& more) {
  taken_out_by_hand(result);
  return lateness_of(rules, with_counted_extra_credit(rules, std::move(result)), handed_in, more);
}

int used_of_all(const HandInRules& rules, int late, const MoreDays& more) {
  const double needed = std::ceil(late - rules.free_days - more.given);
  return std::clamp(static_cast<int>(needed), 0, std::max(0, more.left_of_all));
}

SubmissionResult under(const HandInRules& rules, SubmissionResult result, const std::string& handed_in,
                       const MoreDays& more) {
  std::vector<ExerciseResult> by_hand = taken_out_by_hand(result);
  result = with_counted_extra_credit(rules, std::move(result));
  take_off_for_lateness(rules, result, handed_in, more);
  std::ranges::move(by_hand, std::back_inserter(result.exercises));
  return result;
}

}  // namespace grader::record
