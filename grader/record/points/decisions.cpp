// STAFF ONLY. Applies decisions of people to computed results.
#include "grader/record/points/decisions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <sstream>

#include "grader/course/input.h"
#include "grader/record/points/shown_number.h"

namespace grader::inline record {
namespace {

constexpr std::array<const char*, 5> kKinds{"points", "excuse", "comment", "late-days", "hold"};
constexpr double kSamePoints = 1e-9;  // points are sums of a few numbers near 1

struct Place {
  ExerciseResult* exercise = nullptr;  // null: there is no such place
  CaseResult* category = nullptr;      // null: the whole exercise
  std::size_t line = 0;                // counts from 1; 0: none

  double points() const { return category ? category->points : exercise->points; }
  double max_points() const { return category ? category->max_points : exercise->max_points; }
  // A category's feedback is written anew for students, so its exercise has the sentence.
  void tell(const std::string& sentence) const {
    std::string& text = exercise->feedback;
    if (text.empty()) text = sentence_for(exercise->status);
    text += " " + (category ? category->name + ": " : "") + sentence;
  }
};

Place find(SubmissionResult& result, const std::string& place) {
  if (const std::size_t colon = place.find(':'); colon != place.npos) {
    Place found = find(result, place.substr(0, colon));
    const std::string number = place.substr(colon + 1);
    const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), found.line);
    const bool is_line = error == std::errc() && *end == '\0' && number.front() != '0' && !found.category;
    return is_line ? found : Place{};
  }
  for (ExerciseResult& exercise : result.exercises) {
    if (exercise.id == place) return {&exercise, nullptr};
    for (std::size_t i = 0; i < exercise.cases.size(); ++i)
      if (exercise.id + "." + std::to_string(i + 1) == place) return {&exercise, &exercise.cases[i]};
  }
  return {};
}

std::string with_reason(const std::string& what, const Decision& decision) {
  return what + (decision.why.empty() ? "" : ": " + decision.why);
}

// A place may be worth less than when it was decided.
void set_points(const Place& place, const Decision& decision) {
  const double number = std::min(decision.number, place.max_points());
  const std::string gave =
      "The staff gave " + shown_number(number) + " of " + shown_number(place.max_points()) + " points";
  if (is_by_hand(*place.exercise)) {
    place.exercise->status = Status::given;
    place.exercise->feedback = with_reason(gave, decision);
  } else {
    place.tell(
        with_reason(gave + " here, where " + shown_number(place.points()) + " had been computed", decision));
  }
  place.exercise->points += number - place.points();
  if (place.category) place.category->points = number;
  place.exercise->points_set = true;
}

void excuse(ExerciseResult& exercise, const Decision& decision) {
  Place{&exercise, nullptr}.tell(
      with_reason("The staff excused you from this exercise: it does not count", decision));
  exercise.status = Status::excused;
  exercise.points = exercise.max_points = 0;
  for (CaseResult& one : exercise.cases) one.points = one.max_points = 0;
}

std::string signed_points(double number) {
  return (number > 0 ? "+" : "") + shown_number(number) + (std::abs(number) == 1 ? " point" : " points");
}

// It sums the comments of a place before it looks at the place's worth, so that their order does not count;
// categories come before their exercise.
void add_points_of_comments(SubmissionResult& result, const std::vector<Decision>& decisions) {
  std::map<std::string, double, std::greater<>> by_place;
  for (const Decision& one : decisions)
    if (one.kind == DecisionKind::comment) by_place[one.place.substr(0, one.place.find(':'))] += one.number;
  for (const auto& [where, number] : by_place) {
    const Place place = find(result, where);
    if (!place.exercise || !is_given(*place.exercise)) continue;
    const double before = place.points(), after = std::clamp(before + number, 0.0, place.max_points());
    if (place.category) place.category->points = after;
    place.exercise->points_set |= after != before;
    double& all = place.exercise->points;
    all = std::clamp(all + after - before, 0.0, place.exercise->max_points);
  }
}

void apply(SubmissionResult& result, const Decision& decision) {
  const Place place = find(result, decision.place);
  if (!decision.place.empty() && !place.exercise) return;
  switch (decision.kind) {
    case DecisionKind::points:
      return set_points(place, decision);
    case DecisionKind::comment:
      return say(result, {decision.place, decision.code,
                          "The staff say: " + decision.why +
                              (decision.number == 0 ? "" : " (" + signed_points(decision.number) + ")")});
    case DecisionKind::excuse:
      for (ExerciseResult& exercise : result.exercises)
        if (!place.exercise || &exercise == place.exercise) excuse(exercise, decision);
      return;
    case DecisionKind::late_days:
      result.remarks.push_back(
          with_reason("The staff gave you " + shown_number(decision.number) + " more days", decision));
      return;
    case DecisionKind::hold:
      return;
  }
}

std::string places_of(const SubmissionResult& result) {
  std::string all;
  for (const ExerciseResult& exercise : result.exercises) {
    all += (all.empty() ? "" : ", ") + exercise.id;
    if (!exercise.cases.empty())
      all += " (" + exercise.id + ".1 to " + exercise.id + "." + std::to_string(exercise.cases.size()) + ")";
  }
  return all.empty() ? "none" : all;
}

// Returns the line of "H2:17", "" for other places.
std::string check_place(const std::string& place, const SubmissionResult& computed) {
  SubmissionResult result = computed;
  const Place found = find(result, place);
  if (!place.empty() && !found.exercise)
    throw BadInput(printable(place) + ": is no place in the result of " + result.name + "; there are " +
                   places_of(result));
  if (found.line == 0) return "";
  std::istringstream source(found.exercise->source);
  std::string text;
  std::size_t lines = 0;
  while (lines < found.line && std::getline(source, text)) ++lines;
  if (lines < found.line)
    throw BadInput(place + ": " +
                   (lines == 0 ? "the record has no source of " + found.exercise->id +
                                     "; grade again, or name the exercise"
                               : "the file has " + std::to_string(lines) + " lines"));
  if (text.ends_with('\r')) text.pop_back();
  return text;
}

// Returns the points of the whole exercise beside one of its categories, or the other way round; else null.
const Decision* contradicted(const Decision& one, const std::vector<Decision>& others) {
  const auto is_part = [](const Decision& part, const Decision& whole) {
    return part.place.starts_with(whole.place + ".");
  };
  const auto found = std::ranges::find_if(others, [&](const Decision& other) {
    return one.kind == DecisionKind::points && other.kind == one.kind &&
           (is_part(one, other) || is_part(other, one));
  });
  return found == others.end() ? nullptr : &*found;
}

std::string conflict_of(const Decision& decision, const Place& place,
                        const std::vector<Decision>& decisions) {
  const bool sets = decision.kind == DecisionKind::points;
  const std::string begin =
      decision.who + (sets ? " set " + decision.place + " to " + shown_number(decision.number) + " where " +
                                 shown_number(decision.computed) +
                                 (decision.worth > 0 ? " of " + shown_number(decision.worth) : "") +
                                 " points had been computed"
                           : " decided " + decision_text(decision));
  if (!place.exercise && !decision.place.empty())
    return begin + ", and now there is no " + decision.place + "; unset it, or set another place";
  if (!sets || !place.exercise) return "";
  if (decision.worth > 0 && std::abs(place.max_points() - decision.worth) > kSamePoints)
    return begin + ", and now it is worth " + shown_number(place.max_points()) +
           "; set it again, or unset it";
  if (std::abs(place.points() - decision.computed) > kSamePoints)
    return begin + ", and now it is " + shown_number(place.points()) + "; set it again, or unset it";
  const Decision* other = contradicted(decision, decisions);
  if (other && decision.place.size() < other->place.size())
    return begin + ", and " + other->place + " to " + shown_number(other->number) + ": both count; unset one";
  return "";
}

}  // namespace

std::string to_string(DecisionKind kind) {
  return kKinds.at(static_cast<std::size_t>(kind));
}

std::optional<DecisionKind> decision_kind_from(const std::string& word) {
  const auto* found = std::ranges::find(kKinds, word);
  if (found == kKinds.end()) return {};
  return static_cast<DecisionKind>(found - kKinds.begin());
}

void check(Decision& decision, const SubmissionResult& computed, const std::vector<Decision>& others) {
  SubmissionResult result = computed;
  const bool is_comment = decision.kind == DecisionKind::comment;
  decision.code = check_place(decision.place, computed);
  const Place place = find(result, decision.place);
  if (place.line > 0 && !is_comment)
    throw BadInput(decision.place + ": a line has no points; name its exercise or a category");
  if (decision.kind == DecisionKind::excuse && place.category)
    throw BadInput(decision.place + ": a category can't be excused alone; excuse " + place.exercise->id +
                   ", or set points");
  // Tables of points by hand and of extensions give no reasons.
  const bool needs_no_reason = decision.kind == DecisionKind::late_days ||
                               (place.exercise && is_by_hand(*place.exercise) && !is_comment);
  if (!needs_no_reason && decision.why.find_first_not_of(" \t\r\n") == std::string::npos)
    throw BadInput(is_comment ? "the comment is empty; write one"
                              : "there is no reason; add --why TEXT, which the student sees");
  if (decision.kind == DecisionKind::points) {
    if (!place.exercise) throw BadInput("points need a place; there are " + places_of(result));
    if (!(decision.number >= 0 && decision.number <= place.max_points() + kSamePoints))
      throw BadInput(shown_number(decision.number) + " points: " + decision.place + " is worth " +
                     shown_number(place.max_points()) + "; write a number from 0 to that");
    if (const Decision* other = contradicted(decision, others))
      throw BadInput(decision.place + ": " + other->who + " set " + other->place + " to " +
                     shown_number(other->number) + " points, and nobody could say which count; unset " +
                     other->place + " first");
    for (const Decision& other : others)
      if (other.kind == DecisionKind::excuse && (other.place.empty() || other.place == place.exercise->id))
        throw BadInput(decision.place + ": " + other.who + " excused " +
                       (other.place.empty() ? "the whole" : other.place) +
                       ", so points would not count; unset the excuse first");
  }
  if (is_comment && (!std::isfinite(decision.number) || (decision.number != 0 && !place.exercise)))
    throw BadInput(std::isfinite(decision.number)
                       ? "points of a comment need a place; there are " + places_of(result)
                       : "the points of a comment are no number; write one such as -2");
  if (decision.kind == DecisionKind::late_days && !(decision.number >= 0 && decision.number <= 366))
    throw BadInput(shown_number(decision.number) + " days: write a number from 0 to 366");
  decision.computed = place.exercise ? place.points() : points(computed);
  decision.title = place.category ? place.category->name : "";
  decision.worth = place.exercise ? place.max_points() : 0;
}

std::optional<double> points_at(SubmissionResult result, const std::string& place) {
  const Place found = find(result, place);
  return found.exercise ? std::optional(found.points()) : std::nullopt;
}

SubmissionResult decided(SubmissionResult computed, const std::vector<Decision>& decisions) {
  // Exercises come before their categories: then both count. An excused exercise has no points.
  std::vector<Decision> in_order = decisions;
  std::ranges::stable_sort(in_order, {}, [](const Decision& one) {
    return one.kind == DecisionKind::excuse ? 2 : one.place.find('.') != std::string::npos ? 1 : 0;
  });
  for (const Decision& one : in_order)
    computed.decided.push_back({one.place, to_string(one.kind), decision_text(one),
                                conflict_of(one, find(computed, one.place), decisions)});
  for (const Decision& decision : in_order) apply(computed, decision);
  add_points_of_comments(computed, decisions);
  return computed;
}

void say(SubmissionResult& result, const Said& said) {
  if (const Place place = find(result, said.place); place.exercise)
    place.exercise->said.push_back(said);
  else
    result.remarks.push_back(said.text);
}

std::string decision_text(const Decision& decision) {
  std::string text = to_string(decision.kind) + (decision.place.empty() ? "" : " " + decision.place);
  if (decision.kind == DecisionKind::points)
    text += ": " + shown_number(decision.number) + " (computed: " + shown_number(decision.computed) + ")";
  if (decision.kind == DecisionKind::comment) text += ", comment " + std::to_string(decision.comment);
  if (decision.kind == DecisionKind::comment && decision.number != 0)
    text += " (" + signed_points(decision.number) + ")";
  if (decision.kind == DecisionKind::late_days) text += ": " + shown_number(decision.number);
  return text + ": " + decision.why;
}

std::vector<std::string> conflicts(const SubmissionResult& computed, const std::vector<Decision>& decisions) {
  std::vector<std::string> lines;
  for (const Decided& one : decided(computed, decisions).decided)
    if (!one.conflict.empty()) lines.push_back(computed.name + ": " + one.conflict);
  return lines;
}

}  // namespace grader::record
