// The rope of the Bullet physics library (a soft body of links, in single precision) as a strand, with the
// same particles, masses, gravity and step.
#pragma once

#include <memory>

#include "hair/strand.h"
#include "particles/vectors.h"

namespace hair_bench {

class BulletRope {
 public:
  // A uniform strand that starts horizontal, along x, with its root at the origin. A step makes `iterations`
  // sweeps over the links (Bullet's piterations).
  BulletRope(const hair::Strand& strand, int iterations);
  ~BulletRope();

  void step(double h);
  Eigen::VectorXd positions() const;  // 3n, m

 private:
  struct World;
  std::unique_ptr<World> world_;
};

}  // namespace hair_bench
