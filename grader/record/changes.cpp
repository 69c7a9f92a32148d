// STAFF ONLY. Lists and compares the points of gradings. The log remembers what students were told.
#include "grader/record/changes.h"

#include <algorithm>

#include "grader/record/points/shown_number.h"
#include "grader/result/json_fields.h"

namespace grader {

const Rows<PointsThen>& Fields<PointsThen>::rows() {
  using T = PointsThen;
  static const Rows<T> all = {field("place", &T::place), field("title", &T::title),
                              field("points", &T::points), field("max_points", &T::max_points)};
  return all;
}

const Rows<Published>& Fields<Published>::rows() {
  using T = Published;
  static const Rows<T> all = {field("by", &T::by), field("total", &T::total),
                              field("max_points", &T::max_points), field("points", &T::points)};
  return all;
}

}  // namespace grader

namespace grader::inline record {
namespace {

constexpr const char* kPublished = "published";

// Returns what stays if a suite numbers its categories anew; an exercise is its id.
std::string key_of(const std::string& place, const std::string& title) {
  const std::size_t dot = place.find('.');
  return dot == place.npos ? place : place.substr(0, dot + 1) + title;
}

std::string total_of(const Published& one) {
  return shown_number(one.total) + " of " + shown_number(one.max_points);
}

template <class T>
T from_log(const LogEntry& entry) {
  return from_json_text<T>(entry.detail, "the log's entry of " + entry.at);
}

}  // namespace

std::vector<PointsThen> points_then(const SubmissionResult& result) {
  std::vector<PointsThen> all;
  for (const ExerciseResult& exercise : result.exercises) {
    if (exercise.cases.empty())
      all.push_back({exercise.id, exercise.title, exercise.points, exercise.max_points});
    for (std::size_t i = 0; i < exercise.cases.size(); ++i) {
      const CaseResult& one = exercise.cases[i];
      all.push_back({exercise.id + "." + std::to_string(i + 1), one.name, one.points, one.max_points});
    }
  }
  return all;
}

std::vector<PointsThen> points_then(const LogEntry& graded) {
  return from_log<std::vector<PointsThen>>(graded);
}

std::vector<PointsChange> changes(const std::vector<PointsThen>& before,
                                  const std::vector<PointsThen>& after) {
  std::vector<PointsChange> all;
  for (const PointsThen& then : before) all.push_back({then.place, then.title, then.points, {}});
  for (const PointsThen& now : after) {
    const auto same = std::ranges::find_if(all, [&](const PointsChange& one) {
      return !one.after && key_of(one.place, one.title) == key_of(now.place, now.title);
    });
    if (same == all.end())
      all.push_back({now.place, now.title, {}, now.points});
    else
      same->place = now.place, same->after = now.points;
  }
  std::erase_if(all, [](const PointsChange& one) { return one.before == one.after; });
  return all;
}

std::vector<PointsChange> changes(const std::vector<LogEntry>& log) {
  std::vector<const LogEntry*> gradings;
  for (const LogEntry& entry : log)
    if (entry.did == "graded") gradings.push_back(&entry);
  if (gradings.size() < 2) return {};
  return changes(points_then(*gradings[gradings.size() - 2]), points_then(*gradings.back()));
}

Published published(const SubmissionResult& result) {
  Published one{"", points(result), max_points(result), points_then(result)};
  for (const ExerciseResult& exercise : result.exercises)
    if (!exercise.cases.empty())
      one.points.push_back({exercise.id, exercise.title, exercise.points, exercise.max_points});
  return one;
}

std::string changed_places(const Published& before, const Published& now, std::size_t most_categories) {
  const std::vector<PointsChange> all = changes(before.points, now.points);
  const auto is_category = [](const PointsChange& one) { return one.place.find('.') != std::string::npos; };
  const bool categories =
      static_cast<std::size_t>(std::ranges::count_if(all, is_category)) <= most_categories;
  std::string text;
  for (const PointsChange& one : all) {
    const auto shown = [](const std::optional<double>& points) {
      return points ? shown_number(*points) : "not there";
    };
    // An exercise stands for itself if none of its categories does.
    const bool has_part = std::ranges::any_of(
        all, [&](const PointsChange& part) { return part.place.starts_with(one.place + "."); });
    if (categories ? !has_part : !is_category(one))
      text += (text.empty() ? "" : "; ") + one.place + " " + one.title + " " + shown(one.before) + " -> " +
              shown(one.after);
  }
  return !text.empty()                         ? text
         : before.max_points != now.max_points ? "it is out of other points"
                                               : "lateness or extra credit";
}

std::string change_in_words(const Published& before, const Published& now) {
  constexpr std::size_t kMostCategories = 4;  // else a sentence names exercises
  if (total_of(before) == total_of(now)) return "";
  return "Your total was " + total_of(before) + " points and is " + total_of(now) +
         " now: " + changed_places(before, now, kMostCategories) + ".";
}

void Record::put_published(const std::map<std::string, Published>& by_name) {
  Transaction transaction(database_);
  for (const auto& [name, one] : by_name) add_to_log(known_person(name), kPublished, json_text(one, -1));
  transaction.commit();
}

std::optional<Published> Record::published(const std::string& name) {
  std::optional<Published> last;
  for (const LogEntry& entry : log(name))
    if (entry.did == kPublished) {
      last = from_log<Published>(entry);
      last->at = entry.at;
    }
  return last;
}

}  // namespace grader::record
