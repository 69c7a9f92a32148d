// The duration of calls: CPU time of this thread, medians of repeats.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "solver/timing.h"

namespace solver::study {

struct Timing {
  double least_seconds = 1e-4;  // per repeat; a repeat makes several calls if they are shorter
  int repeats = 5;              // a third of them if a call takes 10 least_seconds or more

  int repeats_of(double call_seconds) const {
    return call_seconds < 10 * least_seconds ? repeats : (repeats + 2) / 3;
  }
};

// The seconds that each of the calls takes. The calls are repeated in turn, so that a temporary slowdown of
// the machine affects all of them. The first calls warm up and determine how many calls make a repeat.
inline std::vector<double> median_seconds(const Timing& how,
                                          const std::vector<std::function<void()>>& calls) {
  const auto seconds = [&](std::size_t call, long times) {
    const double start = timing::cpu_seconds();
    for (long i = 0; i < times; ++i) calls[call]();
    return timing::cpu_seconds() - start;
  };
  std::vector<long> times(calls.size(), 1);
  std::vector<int> repeats;
  for (std::size_t call = 0; call < calls.size(); ++call) {
    double taken = seconds(call, 1);
    while (taken < how.least_seconds && times[call] < (1L << 30)) {
      const double needed = taken > 0 ? static_cast<double>(times[call]) * how.least_seconds / taken : 0;
      times[call] = std::max(2 * times[call], static_cast<long>(needed));
      taken = seconds(call, times[call]);
    }
    repeats.push_back(how.repeats_of(taken / static_cast<double>(times[call])));
  }
  std::vector<std::vector<double>> all(calls.size());
  for (int repeat = 0; repeat < how.repeats; ++repeat)
    for (std::size_t call = 0; call < calls.size(); ++call)
      if (repeat < repeats[call])
        all[call].push_back(seconds(call, times[call]) / static_cast<double>(times[call]));
  std::vector<double> medians;
  for (const std::vector<double>& one : all) medians.push_back(timing::median(one));
  return medians;
}

inline double median_seconds(const Timing& how, const std::function<void()>& call) {
  return median_seconds(how, std::vector{call})[0];
}

}  // namespace solver::study
