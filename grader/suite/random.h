// STAFF ONLY. Random inputs: a seed gives the same ones on every machine, unlike the standard library's
// distributions.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace grader {

class Random {
 public:
  // Each `purpose` gives its own sequence.
  Random(const std::string& seed, const std::string& purpose) {
    const std::string text = seed + "/" + purpose;
    std::seed_seq sequence(text.begin(), text.end());
    engine_.seed(sequence);
  }

  double uniform(double low = 0, double high = 1) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  int integer(int low, int high) {  // both included
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  double normal() {  // Box and Muller (1958)
    return std::sqrt(-2 * std::log(1 - uniform())) * std::cos(2 * std::numbers::pi * uniform());
  }
  std::vector<double> normals(int n, double scale = 1) {
    std::vector<double> values(n);
    for (double& value : values) value = scale * normal();
    return values;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace grader
