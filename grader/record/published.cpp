// STAFF ONLY. Remembers in the log what students were told, and compares it with their present points.
#include "grader/record/published.h"

#include <algorithm>

#include "grader/record/changes.h"
#include "grader/record/points/shown_number.h"
#include "grader/record/record.h"
#include "grader/result/json_fields.h"

namespace grader {

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

std::string total_of(const Published& one) {
  return shown_number(one.total) + " of " + shown_number(one.max_points);
}

}  // namespace

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
  const std::lock_guard lock(one_at_a_time_);
  Transaction transaction(database_);
  for (const auto& [name, one] : by_name) add_to_log(known_person(name), kPublished, json_text(one, -1));
  transaction.commit();
}

std::optional<Published> Record::published(const std::string& name) {
  std::optional<Published> last;
  for (const LogEntry& entry : log(name))
    if (entry.did == kPublished) {
      last = from_json_text<Published>(entry.detail, "the log's entry of " + entry.at);
      last->at = entry.at;
    }
  return last;
}

}  // namespace grader::record
