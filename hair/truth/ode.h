// The interface between ordinary differential equations and a solver: y' = f(t, y), and the sparsity of
// df/dy.
#pragma once

#include <memory>
#include <vector>

#include "particles/state.h"

namespace hair {

// A band matrix: entries are 0 except for -above <= i - j <= below; entry (i, j) is columns(above + i - j,
// j).
struct BandMatrix {
  Eigen::MatrixXd columns;  // (above + 1 + below) x size
  int above, below;

  double& operator()(int i, int j) { return columns(above + i - j, j); }
};

class Ode {
 public:
  virtual ~Ode() = default;

  virtual int size() const = 0;
  virtual Eigen::VectorXd start() const = 0;

  // The natural size of each entry of y, > 0, in its own unit: an error of this size is a relative error of
  // 1.
  virtual Eigen::VectorXd scales() const = 0;

  // The times, increasing, at which f is not smooth. start_span(t), called at one of them: f's later times
  // are after it.
  virtual std::vector<double> breaks() const { return {}; }
  virtual void start_span(double /*t*/) {}

  // dy = f(t, y); overwrites all of dy.
  virtual void rates(double t, particles::Input y, particles::Output dy) = 0;

  // Half bandwidths of df/dy, and the matrix itself. jacobian() returns false if it has none; then the solver
  // uses differences.
  virtual int above() const { return size() - 1; }
  virtual int below() const { return size() - 1; }
  virtual bool jacobian(double /*t*/, particles::Input /*y*/, BandMatrix& /*df*/) { return false; }

  // Converts y to the places and velocities of the problem's particles.
  virtual particles::State state(double t, particles::Input y) = 0;
};

struct Problem;

// A problem's toy: positions, then velocities, of the particles that are not pinned. Exercise P2 computes the
// forces of rods and wires. Throws what particles::MovingToy throws.
std::unique_ptr<Ode> toy_ode(const Problem& problem);

// The motion of a problem's particles: their states at each of its moments.
// states[k] is at time duration * k / moments; states[0] is the start.
using Trajectory = std::vector<particles::State>;

}  // namespace hair
