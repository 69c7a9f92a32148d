// STAFF ONLY. timing.json: the cost of everything, beside the reference in an identical worker; and costs.html,
// the page that shows it. Besides studies, only these two differ from run to run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/result/costs.h"
#include "grader/result/result.h"

namespace grader {

class Timing {
 public:
  // Begins with what earlier runs found, or anew where that can't be read. `merge`: this run grades one exercise alone,
  // and keeps the costs of the others.
  Timing(std::filesystem::path folder, const TimingByExercise& reference, bool merge);

  const std::string& damage() const { return damage_; }  // why it began anew, in a line; empty: it did not

  // Writes timing.json, so that no cost is lost if the batch is killed.
  void add(const std::string& submission, const TimingByExercise& timing);

  // Leaves out whoever has no result in the folder any more, and writes both files.
  void finish(const std::vector<SubmissionResult>& results, const LastRun& run);

 private:
  void put(TimingByExercise& place, const TimingByExercise& timing) const;
  void write() const;

  std::filesystem::path folder_;
  bool merge_;
  ClassCosts costs_;
  std::string damage_;
};

}  // namespace grader
