#include "hair/mass_spring/rest_curvature.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "hair/mass_spring/rest_bend.h"
#include "particles/require.h"

namespace hair {

namespace rest_bend {
namespace {

// The Gauss-Newton product, J^T J dx, joint by joint from the root. E is the sum of squares of these terms,
// and J is their derivative:
//
//   sqrt(s) (kappa - rest),   sqrt(1 - s) kappa,   sqrt(1 - s) |rest|.
//
// The second term counts only by its length. Its other changes are weighted by max(cos(phi), 0), so that J is
// exact on straight hair, and bounded at the fold.
class Squares {
 public:
  explicit Squares(Input dx) : dx_(dx) {}

  Gradient<double> operator()(const Joint<double>& joint);

 private:
  Vector3d turn(int i, const Vector3d& direction, double length) const;

  Input dx_;
  double psi_ = 0;    // the turn of the frame above the joint about the strand
  double share_ = 0;  // the change of log(s)
};

Gradient<double> Squares::operator()(const Joint<double>& joint) {
  Gradient<double> gradient;
  if (joint.folded) {
    share_ = psi_ = 0;  // neither has an effect any more
    return gradient;
  }
  const Vector3d du = joint.above < 0 ? Vector3d::Zero() : turn(joint.above, joint.u, joint.length_above);
  const Vector3d dv = turn(joint.below, joint.v, joint.length_below);
  const double dcos = du.dot(joint.v) + joint.u.dot(dv);
  share_ += joint.kept.slope * dcos;  // d log(s)
  Vector3d dw = (du.cross(joint.v) + joint.u.cross(dv)) * joint.q;
  double dphi = 0;
  if (joint.is_obtuse()) {
    dphi = joint.b.dot(joint.v.cross(dv) - joint.u.cross(du));
    dw += joint.b * (dphi - joint.b.dot(dw));
  } else {
    dw -= joint.u_x_v * (joint.slope * dcos);
  }
  const double dkappa[2] = {dw.dot(joint.second), dw.dot(joint.third)};
  const double frame[2] = {psi_ * joint.kappa[1], -psi_ * joint.kappa[0]};
  psi_ -= joint.tan_b.dot(du + dv);

  const double s = joint.share, root = std::sqrt(s), rest = std::sqrt(1 - s);
  const double fading = s < 1 ? s * share_ / (2 * rest) : 0;  // -d sqrt(1 - s)
  double by_share = 0;
  for (int i = 0; i < 2; ++i) {
    const double a = s > 0 ? root * (dkappa[i] + frame[i] + joint.off[i] * share_ / 2) : 0;
    gradient.turning[i] = root * a;
    by_share += root / 2 * joint.off[i] * a;
  }
  if (s < 1) {
    const double phi_squared = joint.kappa[0] * joint.kappa[0] + joint.kappa[1] * joint.kappa[1];
    const double across = std::max(joint.cosine, 0.0);
    const auto damped = [&](const double from[2], int i) {
      if (joint.is_obtuse() || phi_squared == 0) return across * from[i];
      const double along = joint.kappa[0] * from[0] + joint.kappa[1] * from[1];
      return across * from[i] + (1 - across) / phi_squared * along * joint.kappa[i];
    };
    const double phi = std::sqrt(phi_squared);
    double b[2];
    for (int i = 0; i < 2; ++i)
      b[i] = rest * (joint.is_obtuse() ? dphi * joint.kappa[i] / phi : damped(dkappa, i)) -
             joint.kappa[i] * fading;
    for (int i = 0; i < 2; ++i) {
      gradient.bending[i] = rest * (joint.is_obtuse() ? b[i] : damped(b, i));
      by_share -= s / (2 * rest) * joint.kappa[i] * b[i];
    }
    by_share += s / (2 * rest) * joint.rest_squared() * fading;
  }
  gradient.share = by_share;
  return gradient;
}

Vector3d Squares::turn(int i, const Vector3d& direction, double length) const {
  const Vector3d de = difference(dx_, i);
  return (de - direction * direction.dot(de)) / length;
}

}  // namespace
}  // namespace rest_bend

using particles::require;
using rest_bend::difference;
using rest_bend::energy_gradient;
using rest_bend::Joint;
using rest_bend::spread_all;
using rest_bend::Squares;
using rest_bend::Vec3;
using rest_bend::walk;

namespace {

void require_frame(const Vector3d& tangent, const Vector3d& normal) {
  require(std::abs(tangent.norm() - 1) < 1e-6, "the length of the root's tangent", tangent.norm(), "1");
  require(std::abs(normal.norm() - 1) < 1e-6, "the length of the root's normal", normal.norm(), "1");
  require(std::abs(tangent.dot(normal)) < 1e-6, "the product of the root's tangent and normal",
          tangent.dot(normal), "0");
}

}  // namespace

Eigen::VectorXd bend_components(Input x, const Vector3d& tangent, const Vector3d& normal) {
  require_frame(tangent, normal);
  require(x.size() >= 3 && x.size() % 3 == 0, "the size of x", static_cast<double>(x.size()),
          "three for each particle, of which there is one at least");
  Strand strand;
  strand.mass = Eigen::VectorXd::Ones(x.size() / 3);
  strand.rest_length = Eigen::VectorXd::Ones(strand.count() - 1);
  strand.clamped = true;
  strand.root_tangent = tangent;
  for (int i = 0; i < strand.segments(); ++i)
    require(difference(x, i).norm() > 0, "the length of segment " + std::to_string(i), 0, "> 0");
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(2 * strand.segments());
  Eigen::VectorXd components = zero;
  walk<double>(
      strand, zero, normal, [&](int i) { return difference(x, i); },
      [&](const Joint<double>& joint) {
        components[2 * joint.below] = joint.kappa[0];
        components[2 * joint.below + 1] = joint.kappa[1];
      });
  return components;
}

RestCurvature::RestCurvature(const Strand& strand, Eigen::VectorXd rest, const Vector3d& root_normal,
                             Products product)
    : strand_(strand), rest_(std::move(rest)), product_(product) {
  if (!strand.clamped) throw std::invalid_argument("a strand that is curved at rest must be clamped");
  require(rest_.size() == 2 * strand.segments(), "the number of rest components",
          static_cast<double>(rest_.size()),
          "two for each segment, " + std::to_string(2 * strand.segments()));
  for (int i = 0; i < strand.segments(); ++i)
    require(rest_.segment<2>(2 * i).norm() <= kMostRest, "the rest bend at joint " + std::to_string(i),
            rest_.segment<2>(2 * i).norm(), "at most 2.69");
  set_root_normal(root_normal);
}

void RestCurvature::set_root_normal(const Vector3d& normal) {
  require_frame(strand_.root_tangent, normal);
  root_normal_ = normal;
}

double RestCurvature::energy(Input x) const {
  double energy = 0;
  walk<double>(
      strand_, rest_, root_normal_, [&](int i) { return difference(x, i); },
      [&](const Joint<double>& joint) { energy += rest_bend::energy(joint); });
  return energy;
}

void RestCurvature::add_force(Input x, Input, Output f) const {
  spread_all<double>(
      strand_, rest_, root_normal_, [&](int i) { return difference(x, i); }, energy_gradient<double>,
      energy_gradient<double>, [&](int i, const Vector3d& force) { f.segment<3>(3 * i) += force; });
}

void RestCurvature::add_dfdx(Input x, Input, Input dx, Output df) const {
  if (product_ == Products::definite) {
    spread_all<double>(
        strand_, rest_, root_normal_, [&](int i) { return difference(x, i); }, Squares(dx), Squares(dx),
        [&](int i, const Vector3d& force) { df.segment<3>(3 * i) += force; });
    return;
  }
  auto segment = [&](int i) -> Vec3<Dual> {
    const Vector3d e = difference(x, i), de = difference(dx, i);
    return {Dual(e[0], de[0]), Dual(e[1], de[1]), Dual(e[2], de[2])};
  };
  spread_all<Dual>(strand_, rest_, root_normal_, segment, energy_gradient<Dual>, energy_gradient<Dual>,
                   [&](int i, const Vec3<Dual>& force) {
                     for (int k = 0; k < 3; ++k) df[3 * i + k] += force[k].change;
                   });
}

}  // namespace hair
