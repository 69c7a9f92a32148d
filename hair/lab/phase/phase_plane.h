// P1's four methods in the phase plane: angle and rate of a pendulum, step by step. Its equation is angle'' =
// -sin(angle), in seconds and radians: a pendulum of 9.81 m, whose small swings take 2 pi seconds.
#pragma once

#include <string>
#include <vector>

#include "hair/io/plot/columns.h"

namespace hair::phase {

inline constexpr double kStep = 0.3, kBegin = 0.5;  // s; rad, at rest
inline constexpr int kSteps = 100;

struct State {
  double angle = 0, rate = 0;  // rad, rad/s

  double energy() const;  // relative: 1 at the beginning
};

struct Motion {
  std::string method;              // "forward Euler"
  std::string should;              // its expected look
  int should_evaluate = 1;         // accelerations, a step
  double should_end = 1;           // energy at the end, of small swings
  long evaluations = 0;            // counted, for all steps
  std::vector<State> states = {};  // at the beginning, and after each step
};

std::vector<Motion> phase_plane();

OrderedJson phase_json(const std::vector<Motion>& motions);
std::vector<Row> phase_rows(const std::vector<Motion>& motions);
Page phase_page(const std::vector<Motion>& motions);

}  // namespace hair::phase
