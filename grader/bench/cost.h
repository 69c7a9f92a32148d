// STAFF ONLY. What work costs: by the clock, and in CPU time, which a busy machine stretches less.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace grader_bench {

struct Cost {
  double wall = 0, cpu = 0;  // seconds; CPU time of this process and of all that it has started
};

Cost operator-(const Cost& a, const Cost& b);
Cost operator+(const Cost& a, const Cost& b);

Cost cost_of(const std::function<void()>& work);

struct Part {
  std::string name;
  std::function<void()> work;
};

// The median of each part's costs. The parts take turns, so that what else the machine does meets all of
// them.
std::vector<Cost> median_costs(const std::vector<Part>& parts, int rounds);

// Runs a program with nothing on its standard input and its output thrown away; its exit code.
int run_program(const std::vector<std::string>& command);

}  // namespace grader_bench
