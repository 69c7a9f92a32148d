// STAFF ONLY. Makes the particles and forces of H4's cases, and asks for its calls.
#include "reference/H4/answers.h"

#include <functional>
#include <utility>

#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/implicit_system.h"
#include "handout/check/ordinary.h"
#include "reference/H4/calls.h"

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

ForceServer server_of(const Cloud& cloud) {
  return {*cloud.force, cloud.count(), kMostQuestions};
}

Asked asked_of(const ForceServer& server) {
  return {server.forces, server.dfdx, server.dfdv};
}

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

Product multiply(Trial& trial, const Cloud& cloud, double a, double b, const VectorXd& x, double junk) {
  trial.describe(cloud.name);
  ForceServer server = server_of(cloud);
  CaseAsker asker(trial);
  auto answer = Client<Calls, particles::implicit_matrix>::multiply(
      asker, 2, x, VectorXd::Constant(x.size(), junk),
      std::tuple(std::ref(server), std::cref(cloud.particles), std::cref(cloud.state), a, b));
  return {answer.products[0], answer.products[1], answer.x, asked_of(server)};
}

RightSide right_side(Trial& trial, const Cloud& cloud, double a, double b, double junk) {
  trial.describe(cloud.name);
  ForceServer server = server_of(cloud);
  const VectorXd there = VectorXd::Constant(cloud.state.x.size(), junk);
  const VectorXd rhs = answer_of<Calls, particles::implicit_rhs>(trial, std::ref(server), cloud.particles,
                                                                 cloud.state, a, b, there);
  return {rhs, asked_of(server)};
}

Step step(Trial& trial, const Cloud& cloud, double h, double tolerance) {
  trial.describe(cloud.name);
  ForceServer server = server_of(cloud);
  const auto [report, state] = answer_of<Calls, particles::implicit_euler>(
      trial, std::ref(server), cloud.particles, h, tolerance, cloud.state, Filling{});
  return {state.x, state.v, report, asked_of(server)};
}

}  // namespace grader::h4
