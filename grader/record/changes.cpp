// STAFF ONLY. Compares the points of two gradings.
#include "grader/record/changes.h"

#include <algorithm>

#include "grader/record/points/points_then.h"

namespace grader::inline record {

std::vector<PointsChange> changes(const std::vector<LogEntry>& log, const std::string& since) {
  std::vector<const LogEntry*> gradings;
  for (const LogEntry& entry : log)
    if (entry.did == "graded") gradings.push_back(&entry);
  const LogEntry* earlier = nullptr;
  for (std::size_t i = 0; i + 1 < gradings.size(); ++i)
    if (since.empty() || gradings[i]->at <= since) earlier = gradings[i];
  if (!earlier) return {};

  const auto points_of = [](const LogEntry& entry) {
    return points_then(entry.detail, "the log's entry of " + entry.at);
  };
  std::vector<PointsChange> all;
  for (const PointsThen& then : points_of(*earlier)) all.push_back({then.place, then.title, then.points, {}});
  for (const PointsThen& now : points_of(*gradings.back())) {
    const auto same = std::ranges::find(all, now.place, &PointsChange::place);
    if (same == all.end())
      all.push_back({now.place, now.title, {}, now.points});
    else
      same->after = now.points;
  }
  std::erase_if(all, [](const PointsChange& one) { return one.before == one.after; });
  return all;
}

}  // namespace grader::record
