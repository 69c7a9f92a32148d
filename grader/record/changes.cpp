// STAFF ONLY. Compares the points of two gradings.
#include "grader/record/changes.h"

#include <algorithm>

namespace grader::inline record {
namespace {

// Returns what stays if a suite numbers its categories anew; an exercise is its id.
std::string key_of(const std::string& place, const std::string& title) {
  const std::size_t dot = place.find('.');
  return dot == place.npos ? place : place.substr(0, dot + 1) + title;
}

}  // namespace

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

  const auto points_of = [](const LogEntry& entry) {
    return points_then(entry.detail, "the log's entry of " + entry.at);
  };
  return changes(points_of(*gradings[gradings.size() - 2]), points_of(*gradings.back()));
}

}  // namespace grader::record
