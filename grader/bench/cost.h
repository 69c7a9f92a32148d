// STAFF ONLY. The cost of work: wall time, and CPU time, which depends less on other load of the machine.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace grader_bench {

struct Cost {
  double wall = 0, cpu = 0;  // seconds; CPU time of this process and of all processes that it started
};

Cost operator-(const Cost& a, const Cost& b);
Cost operator+(const Cost& a, const Cost& b);

Cost cost_of(const std::function<void()>& work);

struct Part {
  std::string name;
  std::function<void()> work;
};

// The median of each part's costs. The parts take turns, so that other load of the machine affects all of
// them.
std::vector<Cost> median_costs(const std::vector<Part>& parts, int rounds);

// Runs a program with empty standard input and ignored output; returns its exit code.
int run_program(const std::vector<std::string>& command);

}  // namespace grader_bench
