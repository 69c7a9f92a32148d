// Ordinary differential equations as a solver sees them: y' = f(t, y), and the sparsity of df/dy.
#pragma once

#include <vector>

#include "particles/state.h"

namespace hair {

// A matrix of which only the entries with -above <= i - j <= below are not 0; entry (i, j) is
// columns(above + i - j, j).
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

  // How far y may be off, in units of its own, for a relative error of 1: an entry's natural size, > 0.
  virtual Eigen::VectorXd scales() const = 0;

  // Times, increasing, at which f is not smooth. start_span(t), at one of them: from now on f's times are later.
  virtual std::vector<double> breaks() const { return {}; }
  virtual void start_span(double /*t*/) {}

  // dy = f(t, y); overwrites all of dy.
  virtual void rates(double t, particles::Input y, particles::Output dy) = 0;

  // Half bandwidths of df/dy, and the matrix itself: false if it has none to offer, and differences will do.
  virtual int above() const { return size() - 1; }
  virtual int below() const { return size() - 1; }
  virtual bool jacobian(double /*t*/, particles::Input /*y*/, BandMatrix& /*df*/) { return false; }

  // What y means: the state of all particles.
  virtual particles::State state(double t, particles::Input y) = 0;
};

}  // namespace hair
