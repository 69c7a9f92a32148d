#include "hair/rest_curvature.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "hair/dual.h"
#include "particles/require.h"

namespace hair {

using particles::require;

namespace {

// Numbers are double, or Dual for derivatives along a direction.
template <typename T>
using Vec3 = Eigen::Matrix<T, 3, 1>;

// q = phi / sin(phi) and -dq/d(cos phi), as functions of the cosine.
template <typename T>
struct Quotient {
  T value, slope;

  Quotient(const T& cosine, const T& sine_squared) {
    using std::atan2, std::sqrt;
    const T z = T(2) * (T(1) - cosine);  // (2 sin(phi/2))^2
    if (value_of(z) < 0.1) {
      // arcsin(t) / (t sqrt(1 - t^2)) = sum (k!)^2 / (2k+1)! (2t)^2k with t = sin(phi/2). Each term is less
      // than a fortieth of the one before.
      value = T(0);
      slope = T(0);
      double coefficient = 1;
      T power = T(1), last = T(0);  // z^k and z^(k-1)
      for (int k = 0; k < 12; ++k) {
        value += T(coefficient) * power;
        slope += T(2.0 * k * coefficient) * last;
        last = power;
        power *= z;
        coefficient *= (k + 1.0) / (2 * (2 * k + 3.0));
      }
    } else {
      const T sine = sqrt(sine_squared);
      value = atan2(sine, cosine) / sine;
      slope = (T(1) - value * cosine) / sine_squared;
    }
  }
};

// What a joint passes on of the frame, and its logarithm's derivative by cos(phi): from 1 at phi = 2.69 down to
// nothing at 3.00, c = y^2 (3 - 2y). With `one_plus` = 1 + cos(phi).
template <typename T>
struct Kept {
  T value = T(1), slope = T(0);

  Kept() = default;
  explicit Kept(const T& one_plus) {
    constexpr double kFrom = 0.1, kTo = 0.01;
    const T y = (one_plus - T(kTo)) / T(kFrom - kTo);
    if (value_of(y) >= 1) return;
    value = T(0);
    if (value_of(y) <= 0) return;
    value = y * y * (T(3) - T(2) * y);
    slope = T(6 / (kFrom - kTo)) * (T(1) - y) / (y * (T(3) - T(2) * y));
  }
};

// A joint, and the frame of the segment above it.
template <typename T>
struct Joint {
  int above = -1, below = 0;  // its segments; above is -1 at the root
  Vec3<T> u, v;               // their directions
  T length_above = T(1), length_below = T(1);
  Vec3<T> second, third;  // of the frame, beside u
  T cosine = T(1), one_plus_cosine = T(2);
  bool folded = false;
  double stiffness = 0;
  T kappa[2] = {T(0), T(0)}, off[2] = {T(0), T(0)};  // components of w, and how far they are from rest
  double rest[2] = {0, 0};
  Kept<T> kept;    // by this joint
  T share = T(1);  // s: what all joints from the root to this one keep

  bool is_obtuse() const { return value_of(cosine) < 0; }
  double rest_squared() const { return rest[0] * rest[0] + rest[1] * rest[1]; }

  // Not at the fold:
  T q = T(1), slope = T(0);
  Vec3<T> u_x_v, w, tan_b;  // phi b and tan(phi/2) b
  Vec3<T> b;                // where the joint is obtuse

  // How |off|^2 / 2 changes, with off = by, while the frame turns about the strand.
  T turn(const T by[2]) const { return kappa[0] * by[1] - kappa[1] * by[0]; }
};

// Calls visit(joint) for all joints that have an angle, from the root. segment(i) is the vector of segment i.
template <typename T, typename Segment, typename Visit>
void walk(const Strand& strand, const Eigen::VectorXd& rest, const Vector3d& root_normal, Segment segment,
          Visit visit) {
  using std::sqrt;
  Joint<T> joint;
  joint.v = joint.third = joint.u_x_v = joint.w = joint.tan_b = joint.b = Vec3<T>::Zero();
  joint.u = strand.root_tangent.cast<T>();
  joint.second = root_normal.cast<T>();
  bool meets = true;  // nothing of length 0 since the segment above
  for (int i = 0; i < strand.segments(); ++i) {
    const Vec3<T> e = segment(i);
    const T squared = e.dot(e);
    if (value_of(squared) == 0) {
      meets = false;
      continue;
    }
    joint.below = i;
    joint.length_below = sqrt(squared);
    joint.v = e / joint.length_below;
    joint.third = joint.u.cross(joint.second);
    joint.u_x_v = joint.u.cross(joint.v);
    joint.cosine = joint.u.dot(joint.v);
    const T sine_squared = joint.u_x_v.dot(joint.u_x_v);
    const Vec3<T> bisector = joint.u + joint.v;
    joint.one_plus_cosine = bisector.dot(bisector) / T(2);  // with all digits, next to the fold too
    joint.folded = joint.is_obtuse() && value_of(sine_squared) == 0;
    joint.kept = Kept<T>(joint.one_plus_cosine);
    joint.share *= joint.kept.value;
    if (joint.folded) {
      joint.kappa[0] = T(EIGEN_PI);
      joint.kappa[1] = T(0);
    } else {
      const Quotient<T> quotient(joint.cosine, sine_squared);
      joint.q = quotient.value;
      joint.slope = quotient.slope;
      if (joint.is_obtuse()) joint.b = joint.u_x_v / sqrt(sine_squared);
      joint.w = joint.u_x_v * joint.q;
      joint.tan_b = joint.u_x_v / joint.one_plus_cosine;
      joint.kappa[0] = joint.w.dot(joint.second);
      joint.kappa[1] = joint.w.dot(joint.third);
    }
    for (int k = 0; k < 2; ++k) {
      joint.rest[k] = rest[2 * i + k];
      joint.off[k] = joint.kappa[k] - T(joint.rest[k]);
    }
    const double l =
        i == 0 ? strand.rest_length[0] / 2 : (strand.rest_length[i - 1] + strand.rest_length[i]) / 2;
    joint.stiffness = strand.bend_rigidity / l;
    if (meets) visit(joint);

    // The frame goes on to the segment below: minimal rotation from u to v (about `second` at the fold). Made
    // perpendicular again, for roundings add up along the strand.
    if (!joint.folded) joint.second -= bisector * (joint.v.dot(joint.second) / joint.one_plus_cosine);
    joint.second -= joint.v * joint.v.dot(joint.second);
    joint.second = joint.second / sqrt(joint.second.dot(joint.second));
    joint.u = joint.v;
    joint.length_above = joint.length_below;
    joint.above = i;
    meets = true;
  }
}

// A derivative of the energy by what a joint's segments do, without its stiffness.
template <typename T>
struct Gradient {
  T turning[2] = {T(0), T(0)};  // by kappa, of what counts from the frame
  T bending[2] = {T(0), T(0)};  // by kappa, of what asks for the angle alone
  T share = T(0);               // by log(s)
};

// What all frames and shares of joints below add up to.
template <typename T>
struct Below {
  T turn = T(0), share = T(0);

  void add(const Joint<T>& joint, const Gradient<T>& gradient, double sign) {
    turn += T(sign * joint.stiffness) * joint.turn(gradient.turning);
    share += T(sign * joint.stiffness) * gradient.share;
  }
};

// Adds the force of a joint, minus its gradient. `below` is the sum of those below it, and for the share that of the
// joint itself too.
template <typename T, typename Add>
void spread(const Joint<T>& joint, const Gradient<T>& gradient, const T& turn, const T& share, Add add) {
  if (joint.folded) return;
  const T k = T(joint.stiffness);
  Vec3<T> error = joint.second * gradient.turning[0] + joint.third * gradient.turning[1];
  const Vec3<T> bend = joint.second * gradient.bending[0] + joint.third * gradient.bending[1];
  // All frames below turn with either segment, and all shares below change with the angle.
  Vec3<T> by_u = joint.tan_b * turn, by_v = by_u;
  by_u += joint.v * (joint.kept.slope * share);
  by_v += joint.u * (joint.kept.slope * share);
  if (joint.is_obtuse()) {
    // Next to the fold only what is along b has no large numbers that cancel.
    const T along = joint.b.dot(error);
    const T angle = (along + joint.b.dot(bend)) * k;
    error -= joint.b * along;
    by_u += joint.v.cross(error) * (joint.q * k) - joint.b.cross(joint.u) * angle;
    by_v += error.cross(joint.u) * (joint.q * k) + joint.b.cross(joint.v) * angle;
  } else {
    error += bend;
    const T along = error.dot(joint.u_x_v) * joint.slope;
    by_u += (joint.v.cross(error) * joint.q - joint.v * along) * k;
    by_v += (error.cross(joint.u) * joint.q - joint.u * along) * k;
  }
  auto add_to_segment = [&](int i, const Vec3<T>& direction, const T& length, const Vec3<T>& by) {
    const Vec3<T> pull = (by - direction * direction.dot(by)) / length;
    add(i, pull);
    add(i + 1, Vec3<T>(-pull));
  };
  if (joint.above >= 0) add_to_segment(joint.above, joint.u, joint.length_above, by_u);
  add_to_segment(joint.below, joint.v, joint.length_below, by_v);
}

// Two walks: gradient_of(joint) is asked for twice, each time from the root on.
template <typename T, typename Segment, typename First, typename Second, typename Add>
void spread_all(const Strand& strand, const Eigen::VectorXd& rest, const Vector3d& root_normal,
                Segment segment, First first, Second second, Add add) {
  Below<T> below;
  walk<T>(strand, rest, root_normal, segment,
          [&](const Joint<T>& joint) { below.add(joint, first(joint), 1); });
  walk<T>(strand, rest, root_normal, segment, [&](const Joint<T>& joint) {
    const Gradient<T> gradient = second(joint);
    const T share = below.share;
    below.add(joint, gradient, -1);
    spread(joint, gradient, below.turn, share, add);
  });
}

Vector3d difference(Input x, int i) {
  return x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
}

// Of E / k = s |kappa - rest|^2 / 2 + (1 - s) (|kappa|^2 + |rest|^2) / 2.
template <typename T>
Gradient<T> energy_gradient(const Joint<T>& joint) {
  Gradient<T> gradient;
  for (int i = 0; i < 2; ++i) {
    gradient.turning[i] = joint.share * joint.off[i];
    gradient.bending[i] = (T(1) - joint.share) * joint.kappa[i];
    gradient.share -= joint.share * joint.kappa[i] * T(joint.rest[i]);
  }
  return gradient;
}

// J^T J dx, joint by joint from the root. J is the derivative of what E is the sum of squares of,
//
//   sqrt(s) (kappa - rest),   sqrt(1 - s) kappa,   sqrt(1 - s) |rest|.
//
// Of the second only what its length does must count. What else kappa does is let in by max(cos(phi), 0), so that
// J is exact on straight hair, and bounded at the fold.
class Squares {
 public:
  explicit Squares(Input dx) : dx_(dx) {}

  Gradient<double> operator()(const Joint<double>& joint) {
    Gradient<double> gradient;
    if (joint.folded) {
      share_ = psi_ = 0;  // nothing is left of either
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

 private:
  Vector3d turn(int i, const Vector3d& direction, double length) const {
    const Vector3d de = difference(dx_, i);
    return (de - direction * direction.dot(de)) / length;
  }

  Input dx_;
  double psi_ = 0;    // how the frame above the joint turns about the strand
  double share_ = 0;  // how log(s) changes
};

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
                             BendProduct product)
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
      [&](const Joint<double>& joint) {
        const double s = joint.share;
        const double kept = joint.off[0] * joint.off[0] + joint.off[1] * joint.off[1];
        const double lost =
            joint.kappa[0] * joint.kappa[0] + joint.kappa[1] * joint.kappa[1] + joint.rest_squared();
        const double squared = s * kept + (1 - s) * lost;
        energy += joint.stiffness * squared / 2;
      });
  return energy;
}

void RestCurvature::add_force(Input x, Input, Output f) const {
  spread_all<double>(
      strand_, rest_, root_normal_, [&](int i) { return difference(x, i); }, energy_gradient<double>,
      energy_gradient<double>, [&](int i, const Vector3d& force) { f.segment<3>(3 * i) += force; });
}

void RestCurvature::add_dfdx(Input x, Input, Input dx, Output df) const {
  if (product_ == BendProduct::spd) {
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
