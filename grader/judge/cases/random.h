// STAFF ONLY. Random inputs, and the unit of the hidden cases' bounds. A seed gives the same inputs on every
// machine, unlike the standard library's distributions. A statement draws once: compilers may evaluate two
// draws of one expression in either order.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace grader::inline judge {

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
  double log_uniform(double low, double high) {
    return on_grid(std::exp(uniform(std::log(low), std::log(high))));
  }
  int integer(int low, int high) {  // both included
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  double normal() {  // Box and Muller (1958)
    const double length = std::sqrt(-2 * std::log(1 - uniform()));
    return on_grid(length * std::cos(2 * std::numbers::pi * uniform()));
  }
  std::vector<double> uniforms(int n, double low, double high) {
    std::vector<double> values(n);
    for (double& value : values) value = uniform(low, high);
    return values;
  }
  std::vector<double> normals(int n, double scale = 1) {
    std::vector<double> values(n);
    for (double& value : values) value = scale * normal();
    return values;
  }

  // Rounds to 30 binary digits: exp, log, sin and cos differ by processor in the last one of 53.
  static double on_grid(double value) {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, 30)), exponent - 30);
  }

 private:
  std::mt19937_64 engine_;
};

// Draws normal entries of size `scale`.
inline Eigen::VectorXd random_vector(Random& random, Eigen::Index size, double scale = 1) {
  Eigen::VectorXd v(size);
  for (double& entry : v) entry = scale * random.normal();
  return v;
}

inline Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

inline constexpr double kUnit = 0x1p-53;  // u: one rounding's relative error is at most this

}  // namespace grader::judge
