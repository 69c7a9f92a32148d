// STAFF ONLY. Measures what work costs, with all processes that it starts.
#include "grader/bench/cost.h"
#include "hair/io/files/start_program.h"
#include "solver/timing.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>

namespace grader_bench {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

Cost so_far() {
  Cost cost;
  cost.wall = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    cost.cpu += seconds(usage.ru_utime) + seconds(usage.ru_stime);
  }
  return cost;
}

}  // namespace

Cost operator-(const Cost& a, const Cost& b) {
  return {a.wall - b.wall, a.cpu - b.cpu};
}

Cost operator+(const Cost& a, const Cost& b) {
  return {a.wall + b.wall, a.cpu + b.cpu};
}

Cost cost_of(const std::function<void()>& work) {
  // A cage's first process is left to whom it may concern when the one that made it ends, and all CPU time
  // inside with it: to us, then.
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  const Cost before = so_far();
  work();
  const Cost after = so_far();
  while (wait(nullptr) > 0) {
  }
  return {after.wall - before.wall, so_far().cpu - before.cpu};
}

std::vector<Cost> median_costs(const std::vector<Part>& parts, int rounds) {
  std::vector<std::vector<double>> walls(parts.size()), cpus(parts.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Cost cost = cost_of(parts[i].work);
      walls[i].push_back(cost.wall);
      cpus[i].push_back(cost.cpu);
    }
  std::vector<Cost> medians;
  for (std::size_t i = 0; i < parts.size(); ++i)
    medians.push_back({timing::median(walls[i]), timing::median(cpus[i])});
  return medians;
}

int run_program(const std::vector<std::string>& command) {
  const std::filesystem::path nothing = "/dev/null";
  return hair::exit_code_of(
             hair::start_program({.words = command, .input = nothing, .output = nothing, .errors = nothing}))
      .value_or(-1);
}

}  // namespace grader_bench
