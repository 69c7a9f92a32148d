// Clocks, and the median of measured times.
#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace timing {

inline double clock_seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// CPU time of this thread, independent of other programs on the machine.
inline double cpu_seconds() {
  return clock_seconds(CLOCK_THREAD_CPUTIME_ID);
}

// CPU time of all threads of this process.
inline double process_cpu_seconds() {
  return clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
}

inline double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

class Stopwatch {
 public:
  double seconds() const { return wall_seconds() - start_; }  // since the Stopwatch was made

 private:
  double start_ = wall_seconds();
};

// The wall time of stages, one after the other, without gaps: together they are the whole.
class Laps {
 public:
  // Adds the time since the last one, or since the start, to a sum.
  void book(double& stage) {
    const double now = wall_seconds();
    stage += now - last_;
    last_ = now;
  }
  double whole() const { return last_ - start_; }

 private:
  double start_ = wall_seconds(), last_ = start_;
};

// The median; for an even number of values the mean of the two in the middle; 0 if there are none.
inline double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

}  // namespace timing
