// STAFF ONLY. Makes the particles and forces of H4's cases.
#include "reference/H4/answers.h"

#include <utility>

#include "grader/judge/cases/implicit_system.h"
#include "handout/check/ordinary.h"

namespace grader::h4 {
namespace {

using Eigen::VectorXd;
using particles::Input, particles::Output;

class PartOf final : public OtherForce {
 public:
  PartOf(std::shared_ptr<const particles::Force> force, Parts parts)
      : OtherForce(std::move(force)), parts_(parts) {}
  void add_dfdx(Input x, Input v, Input dx, Output df) const override {
    if (parts_ == Parts::dfdx || parts_ == Parts::all) force_->add_dfdx(x, v, dx, df);
  }
  void add_dfdv(Input x, Input v, Input dv, Output df) const override {
    if (parts_ == Parts::dfdv || parts_ == Parts::all) force_->add_dfdv(x, v, dv, df);
  }

 private:
  Parts parts_;
};

}  // namespace

Cloud with(Cloud cloud, Parts parts) {
  cloud.force = std::make_shared<PartOf>(cloud.force, parts);
  return cloud;
}

Cloud mixed_cloud(Random& random, int n, Parts parts) {
  Cloud cloud = random_cloud(random, "particles of 0.4 to 3 kg", n, 1, 1, 3, 4);
  cloud.particles = checks::ordinary_particles(random, n);
  cloud.force = std::make_shared<MixedForce>(random, n, 3, 4);
  return with(cloud, parts);
}

Cloud soft_hair(Random& random, int n, double h, bool banded) {
  Cloud hair = chain(random, n, 1, 0.1, h);
  hair.name = "soft hair of " + std::to_string(n);
  hair.particles.pinned.assign(static_cast<std::size_t>(n), 0);
  hair.state.v = random_vector(random, 3 * n, 0.1);
  if (banded) hair.force = std::make_shared<Banded>(hair.force);
  return hair;
}

}  // namespace grader::h4
