// How long a call takes: time of this thread's processor, the median of repeats.
#pragma once

#include <algorithm>
#include <ctime>
#include <vector>

namespace solver::study {

struct Timing {
  double least_seconds = 1e-4;  // of a repeat: shorter calls are made several times in one
  int repeats = 5;
};

inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Seconds that a call takes. The first calls, which count how many are in a repeat, warm up.
template <class Call>
double median_seconds(const Timing& timing, const Call& call) {
  const auto seconds = [&](long calls) {
    const double start = cpu_seconds();
    for (long i = 0; i < calls; ++i) call();
    return cpu_seconds() - start;
  };
  long calls = 1;
  double taken = seconds(calls);
  while (taken < timing.least_seconds && calls < (1L << 30)) {
    calls = std::max(2 * calls, taken > 0 ? static_cast<long>(calls * timing.least_seconds / taken) : 0);
    taken = seconds(calls);
  }
  std::vector<double> all;
  for (int i = 0; i < timing.repeats; ++i) all.push_back(seconds(calls) / static_cast<double>(calls));
  std::nth_element(all.begin(), all.begin() + all.size() / 2, all.end());
  return all[all.size() / 2];
}

}  // namespace solver::study
