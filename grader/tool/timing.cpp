// STAFF ONLY.
#include "grader/tool/timing.h"

#include <algorithm>
#include <utility>

#include "grader/course/input.h"
#include "grader/report/costs_page.h"
#include "hair/io/files/read_file.h"

namespace grader {

Timing::Timing(std::filesystem::path folder, const TimingByExercise& reference, bool merge)
    : folder_(std::move(folder)), merge_(merge) {
  const std::filesystem::path file = folder_ / "timing.json";
  try {
    if (std::filesystem::exists(file)) costs_ = class_costs_from_json(hair::bytes_of(file), file.string());
  } catch (const BadInput& error) {
    damage_ = error.what();
  }
  costs_.last_run.reset();
  put(costs_.reference, reference);
}

void Timing::put(TimingByExercise& place, const TimingByExercise& timing) const {
  if (!merge_) place.clear();
  for (const auto& [part, one] : timing) place.insert_or_assign(part, one);
}

void Timing::write() const {
  write_file(folder_ / "timing.json", to_json(costs_));
}

void Timing::add(const std::string& submission, const TimingByExercise& timing) {
  put(costs_.submissions[submission], timing);
  write();
}

void Timing::finish(const std::vector<SubmissionResult>& results, const LastRun& run) {
  std::erase_if(costs_.submissions, [&](const auto& one) {
    return std::none_of(results.begin(), results.end(),
                        [&](const SubmissionResult& result) { return result.name == one.first; });
  });
  costs_.ended_by_the_clock.clear();
  for (const SubmissionResult& result : results)
    if (!result.ended_by_the_clock.empty())
      costs_.ended_by_the_clock[result.name] = result.ended_by_the_clock;
  costs_.last_run = run;
  write();
  write_file(folder_ / "costs.html", costs_page(costs_table(costs_)));
}

}  // namespace grader
