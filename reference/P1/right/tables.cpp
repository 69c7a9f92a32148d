// STAFF ONLY. A right P1 by Butcher's tables: one function takes all steps. Columns of scratch hold their
// slopes.
#include "particles/explicit_integrators.h"

namespace {

using namespace particles;

struct Table {
  int stages;
  double a[4][4];  // a[i][j] is the weight of slope j in the state of stage i, over h
  double b[4];     // the weights in the last sum
};

constexpr Table kForward = {1, {}, {1}};
constexpr Table kMidpoint = {2, {{}, {0.5}}, {0, 1}};
constexpr Table kClassical = {4, {{}, {0.5}, {0, 0.5}, {0, 0, 1}}, {1 / 6., 1 / 3., 1 / 3., 1 / 6.}};

// Columns 0 to 3 hold velocities of the stages, columns 4 to 7 their accelerations, columns 8 and 9 a sum.
void combine(const double* weights, int count, double h, Input start, const Scratch& slopes, int first,
             Output sum) {
  sum = start;
  for (int j = 0; j < count; ++j)
    if (weights[j] != 0) sum += (h * weights[j]) * slopes.col(first + j);
}

void step(const Table& table, Dynamics& dynamics, double h, Output x, Output v, Scratch& scratch) {
  for (int i = 0; i < table.stages; ++i) {
    combine(table.a[i], i, h, v, scratch, 4, scratch.col(i));
    combine(table.a[i], i, h, x, scratch, 0, scratch.col(8));
    dynamics.acceleration(scratch.col(8), scratch.col(i), scratch.col(4 + i));
  }
  combine(table.b, table.stages, h, x, scratch, 0, scratch.col(8));
  combine(table.b, table.stages, h, v, scratch, 4, scratch.col(9));
  x = scratch.col(8);
  v = scratch.col(9);
}

}  // namespace

namespace particles {

void forward_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  step(kForward, dynamics, h, x, v, scratch);
}

// This method is partitioned: positions take the slope v + h a, velocities a.
void symplectic_euler(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  dynamics.acceleration(x, v, scratch.col(4));
  combine(kForward.b, 1, h, v, scratch, 4, scratch.col(0));
  combine(kForward.b, 1, h, x, scratch, 0, scratch.col(8));
  v = scratch.col(0);
  x = scratch.col(8);
}

void midpoint(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  step(kMidpoint, dynamics, h, x, v, scratch);
}

void runge_kutta_4(Dynamics& dynamics, double h, Output x, Output v, Scratch scratch) {
  step(kClassical, dynamics, h, x, v, scratch);
}

}  // namespace particles
