#include "hair/rest_curvature.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "hair/dual.h"
#include "hair/require.h"

namespace hair {
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

  // Not at the fold:
  T q = T(1), slope = T(0);
  Vec3<T> u_x_v, w, tan_b;  // phi b and tan(phi/2) b

  // How |off|^2 / 2 changes, with off = by, while the frame turns about the strand.
  T turn(const T by[2]) const { return kappa[0] * by[1] - kappa[1] * by[0]; }
};

// Calls visit(joint) for all joints that have an angle, from the root. segment(i) is the vector of segment i.
template <typename T, typename Segment, typename Visit>
void walk(const Strand& strand, const Eigen::VectorXd& rest, const Vector3d& root_normal, Segment segment,
          Visit visit) {
  using std::sqrt;
  Joint<T> joint;
  joint.v = joint.third = joint.u_x_v = joint.w = joint.tan_b = Vec3<T>::Zero();
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
    joint.folded = value_of(joint.cosine) < 0 && value_of(sine_squared) == 0;
    if (joint.folded) {
      joint.kappa[0] = T(EIGEN_PI);
      joint.kappa[1] = T(0);
    } else {
      const Quotient<T> quotient(joint.cosine, sine_squared);
      joint.q = quotient.value;
      joint.slope = quotient.slope;
      joint.w = joint.u_x_v * joint.q;
      joint.tan_b = joint.u_x_v / joint.one_plus_cosine;
      joint.kappa[0] = joint.w.dot(joint.second);
      joint.kappa[1] = joint.w.dot(joint.third);
    }
    for (int k = 0; k < 2; ++k) joint.off[k] = joint.kappa[k] - T(rest[2 * i + k]);
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

// Adds the force that belongs to errors `by` of the components: f += -J^T k by. `total` is the sum of k
// turn(by) of all joints, `passed` that of the joints up to and with this one.
template <typename T, typename Add>
void spread(const Joint<T>& joint, const T by[2], const T& total, const T& passed, Add add) {
  if (joint.folded) return;
  const T k = T(joint.stiffness);
  const Vec3<T> error = joint.second * by[0] + joint.third * by[1];
  const T along = error.dot(joint.u_x_v) * joint.slope;
  // All frames below turn with either segment.
  const Vec3<T> frames = joint.tan_b * (total - passed);
  // Of v only what is perpendicular to u counts, and the other way round: next to the fold that is little.
  const Vec3<T> v_off_u = joint.u_x_v.cross(joint.u), u_off_v = joint.v.cross(joint.u_x_v);
  const Vec3<T> by_u = (joint.v.cross(error) * joint.q - v_off_u * along) * k + frames;
  const Vec3<T> by_v = (error.cross(joint.u) * joint.q - u_off_v * along) * k + frames;
  auto add_to_segment = [&](int i, const Vec3<T>& direction, const T& length, const Vec3<T>& gradient) {
    const Vec3<T> pull = (gradient - direction * direction.dot(gradient)) / length;
    add(i, pull);
    add(i + 1, Vec3<T>(-pull));
  };
  if (joint.above >= 0) add_to_segment(joint.above, joint.u, joint.length_above, by_u);
  add_to_segment(joint.below, joint.v, joint.length_below, by_v);
}

Vector3d difference(Input x, int i) {
  return x.segment<3>(3 * i + 3) - x.segment<3>(3 * i);
}

// The force at x, as numbers of type T: add(i, force on particle i).
template <typename T, typename Segment, typename Add>
void add_forces(const Strand& strand, const Eigen::VectorXd& rest, const Vector3d& root_normal,
                Segment segment, Add add) {
  T total = T(0), passed = T(0);
  walk<T>(strand, rest, root_normal, segment, [&](const Joint<T>& joint) {
    if (!joint.folded) total += T(joint.stiffness) * joint.turn(joint.off);
  });
  walk<T>(strand, rest, root_normal, segment, [&](const Joint<T>& joint) {
    if (!joint.folded) passed += T(joint.stiffness) * joint.turn(joint.off);
    spread(joint, joint.off, total, passed, add);
  });
}

// How the components change with x along dx, joint by joint from the root: dkappa = J dx.
class Changes {
 public:
  explicit Changes(Input dx) : dx_(dx) {}

  std::pair<double, double> next(const Joint<double>& joint) {
    if (joint.folded) return {0, 0};
    const Vector3d du = joint.above < 0 ? Vector3d::Zero() : turn(joint.above, joint.u, joint.length_above);
    const Vector3d dv = turn(joint.below, joint.v, joint.length_below);
    const Vector3d dw = (du.cross(joint.v) + joint.u.cross(dv)) * joint.q -
                        joint.u_x_v * (joint.slope * (du.dot(joint.v) + joint.u.dot(dv)));
    const std::pair<double, double> change = {dw.dot(joint.second) + psi_ * joint.kappa[1],
                                              dw.dot(joint.third) - psi_ * joint.kappa[0]};
    psi_ -= joint.tan_b.dot(du + dv);
    return change;
  }

 private:
  Vector3d turn(int i, const Vector3d& direction, double length) const {
    const Vector3d de = difference(dx_, i);
    return (de - direction * direction.dot(de)) / length;
  }

  Input dx_;
  double psi_ = 0;  // how the frame above the joint turns about the strand
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
        // At the fold the bend has no direction in the frame: as if it were perpendicular to that at rest.
        const double squared = joint.folded
                                   ? EIGEN_PI * EIGEN_PI + rest_.segment<2>(2 * joint.below).squaredNorm()
                                   : joint.off[0] * joint.off[0] + joint.off[1] * joint.off[1];
        energy += joint.stiffness * squared / 2;
      });
  return energy;
}

void RestCurvature::add_force(Input x, Input, Output f) const {
  add_forces<double>(
      strand_, rest_, root_normal_, [&](int i) { return difference(x, i); },
      [&](int i, const Vector3d& force) { f.segment<3>(3 * i) += force; });
}

void RestCurvature::add_dfdx(Input x, Input, Input dx, Output df) const {
  if (product_ == BendProduct::exact) {
    auto segment = [&](int i) -> Vec3<Dual> {
      const Vector3d e = difference(x, i), de = difference(dx, i);
      return {Dual(e[0], de[0]), Dual(e[1], de[1]), Dual(e[2], de[2])};
    };
    add_forces<Dual>(strand_, rest_, root_normal_, segment, [&](int i, const Vec3<Dual>& force) {
      for (int k = 0; k < 3; ++k) df[3 * i + k] += force[k].change;
    });
    return;
  }
  auto segment = [&](int i) { return difference(x, i); };
  auto add = [&](int i, const Vector3d& force) { df.segment<3>(3 * i) += force; };
  double total = 0, passed = 0;
  Changes first(dx), second(dx);
  walk<double>(strand_, rest_, root_normal_, segment, [&](const Joint<double>& joint) {
    const auto [a, b] = first.next(joint);
    const double change[2] = {a, b};
    if (!joint.folded) total += joint.stiffness * joint.turn(change);
  });
  walk<double>(strand_, rest_, root_normal_, segment, [&](const Joint<double>& joint) {
    const auto [a, b] = second.next(joint);
    const double change[2] = {a, b};
    if (!joint.folded) passed += joint.stiffness * joint.turn(change);
    spread(joint, change, total, passed, add);
  });
}

}  // namespace hair
