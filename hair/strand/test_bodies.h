// STAFF ONLY. Strands' specifications, and what tests see of a body of any model.
#pragma once

#include <gtest/gtest.h>

#include "hair/strand/body.h"
#include "hair/strand/strand_spec.h"

namespace hair {

inline StrandSpec straight_hair(int elements, double length = 0.1) {
  StrandSpec spec;
  spec.elements = elements;
  spec.length = length;
  return spec;
}

// Its root goes along x.
inline StrandSpec level(StrandSpec spec, const Vector3d& side = Vector3d(0, 0, 1)) {
  spec.root.axis = Vector3d(1, 0, 0);
  spec.root.side = side;
  return spec;
}

inline StrandSpec curl(int elements) {
  StrandSpec spec = straight_hair(elements, 0.12);
  spec.form = Curly{0.005, 0.02};
  return spec;
}

struct BodyState {
  Eigen::VectorXd q, rate;
  explicit BodyState(const Body& body) : q(body.size()), rate(body.size()) { body.read(q, rate); }
};

struct Line {
  Eigen::VectorXd x, v;
  explicit Line(const Body& body) : x(3 * body.points()), v(3 * body.points()) {
    const BodyState state(body);
    body.centre_line(state.q, state.rate, x, v);
  }
};

inline double energy(const Body& body) {
  const BodyState state(body);
  return body.measure(state.q, state.rate).energy();
}

inline Vector3d tip(const Body& body) {
  return Line(body).x.tail<3>();
}

inline void advance(Body& body, double h, int steps, std::span<const PointForce> forces = {},
                    const std::vector<Obstacle>& obstacles = {}) {
  Eigen::MatrixXd scratch(body.scratch_rows(), body.scratch_columns());
  Work work;
  for (int k = 0; k < steps; ++k)
    ASSERT_FALSE(body.step({h, 1e-10, obstacles, forces}, scratch, work)) << "step " << k;
}

}  // namespace hair
