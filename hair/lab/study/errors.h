// The distance of a run from the accurate motion, in several norms, at the problem's moments.
//
// Let x_i be the run's particles and y_i the accurate ones, and l_j and m_j the lengths of their segments (or
// springs and rods):
//
//   final_largest     max_i |x_i - y_i| at the end, m
//   final_rms         sqrt(mean_i |x_i - y_i|^2) at the end, m
//   trajectory        sqrt(mean over moments and i of |x_i - y_i|^2), m: the L2 norm
//   length            max over moments and j of |l_j - m_j| / (length at rest)
//   energy            max over moments of |E(x) - E(y)| / max of the accurate T + |V - V(start)|
//   angular_momentum  max over moments of |L(x) - L(y)| / max of the accurate |L|, about the origin
//
// T, V and L are the kinetic and potential energy and the angular momentum.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "hair/scene/scene_run.h"
#include "hair/truth/accurate_motion.h"
#include "hair/truth/problem.h"

namespace hair {

enum class Norm { final_largest, final_rms, trajectory, length, energy, angular_momentum };
inline constexpr int kNorms = 6;

constexpr std::array<Norm, kNorms> all_norms() {
  return {Norm::final_largest, Norm::final_rms, Norm::trajectory,
          Norm::length,        Norm::energy,    Norm::angular_momentum};
}

struct NormName {
  const char* id;     // "final_largest": in files
  const char* unit;   // "m"; empty: the error is relative
  const char* title;  // "largest error at the end"
  const char* says;   // a definition, in one sentence
};
const NormName& name_of(Norm norm);
std::string with_unit(const NormName& norm);  // "largest error at the end, m": on axes

// NaN in a norm that the problem does not have: energy if nothing moves, length if nothing has a length.
class Errors {
 public:
  double& operator[](Norm norm) { return values_[static_cast<int>(norm)]; }
  double operator[](Norm norm) const { return values_[static_cast<int>(norm)]; }

 private:
  std::array<double, kNorms> values_ = {};
};

struct RestLength {
  int i, j;  // particles
  double length;
};

// Errors below these floors are not reported. `least` is the accuracy of the positions, m. The floor of
// lengths is 2 least / (shortest rest length), those of energy and angular momentum are least /
// size_of(problem).
Errors floors(const Problem& problem, double least);

// The length scale for errors, m: the strand's length, or the largest distance between a toy's first particle
// and another at the start; 1 for a single particle.
double size_of(const Problem& problem);

// Compares a run with the accurate motion during the run.
class ErrorTally {
 public:
  // Keeps a reference to the accurate states.
  ErrorTally(const Problem& problem, const Trajectory& accurate);

  // Call it at each moment in order, including the start. Returns the largest distance of a particle, m.
  double add(const SceneRun& scene_run);

  Errors errors() const;  // valid after all moments were added

 private:
  const Trajectory& accurate_;
  std::vector<RestLength> lengths_;
  int moments_ = 0;
  double potential_ = 0;  // at the start
  double squares_ = 0;    // sum for all distances at all moments except the start
  Errors largest_;
  double most_energy_ = 0, most_angular_momentum_ = 0;
};

}  // namespace hair
