// STAFF ONLY. H8: super-helices.
//
// The step eliminates from the tip to the root, as Featherstone's passes do, with an element in place of a
// link. The rest of the hair at an element's end resists a change of the end's motion (w, v) by its inertia I
// (6 x 6), and gets the impulse z. Within the element a point gains the velocity v + w x arm + P u, where u
// is the change of the element's rates. Minimising over u gives the I and the z at the element's start.

#include "hair/super_helix.h"

#include <cmath>

#include "solver/block_cholesky.h"

namespace hair {
namespace {

using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Matrix63d = Eigen::Matrix<double, 6, 3>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr double kInverseFactorial[8] = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24, 1.0 / 120, 1.0 / 720, 1.0 / 5040};

Matrix3d skew(const Vector3d& a) {
  Matrix3d result;
  result << 0, -a[2], a[1], a[2], 0, -a[0], -a[1], a[0], 0;
  return result;
}

// 1 + b [p] + c [p]^2.
Matrix3d from_axis(const Vector3d& p, double b, double c) {
  Matrix3d result = b * skew(p) + c * p * p.transpose();
  result.diagonal().array() += 1 - c * p.squaredNorm();
  return result;
}

// 1 / (m (m - 1)): the ratio of a series' term to the one before it, over -x.
constexpr std::array<double, 28> kRatio = [] {
  std::array<double, 28> ratio{};
  for (int m = 2; m < 28; ++m) ratio[m] = 1.0 / (m * (m - 1));
  return ratio;
}();

// c_k by its series: for k = 6 or 7 and x < 4, the terms after ten are below rounding.
double series(int k, double x) {
  double sum = 1;
  for (int m = k + 20; m > k; m -= 2) sum = 1 - x * kRatio[m] * sum;
  return kInverseFactorial[k] * sum;
}

// Solves L L' x = b with the factor L of a block.
Vector3d solve(const Matrix3d& L, const Vector3d& b) {
  return solver::block_cholesky::divide_transposed(L, solver::block_cholesky::divide(L, b));
}

// The quadratic form of a point, or of the child's start, in (w, v) at the element's start and in u.
struct Form {
  Matrix6d of_start = Matrix6d::Zero();
  Matrix63d mixed = Matrix63d::Zero();
  Matrix3d of_rates = Matrix3d::Zero();
  Vector6d push_start = Vector6d::Zero();
  Vector3d push_rates = Vector3d::Zero();
};

void add_point(const HelixPoint& point, const Vector3d& start, double h, Form& form) {
  const Matrix3d& W = point.inertia;
  const Matrix3d WP = W * point.moves, arm = skew(point.position - start), arm_W = arm * W;
  form.of_start.topLeftCorner<3, 3>().noalias() -= arm_W * arm;
  form.of_start.topRightCorner<3, 3>() += arm_W;
  form.of_start.bottomRightCorner<3, 3>() += W;
  form.mixed.topRows<3>().noalias() += arm * WP;
  form.mixed.bottomRows<3>() += WP;
  form.of_rates.noalias() += point.moves.transpose() * WP;
  const Vector3d impulse = h * point.force;
  form.push_start.head<3>() += (point.position - start).cross(impulse);
  form.push_start.tail<3>() += impulse;
  form.push_rates += point.moves.transpose() * impulse;
}

// Adds the child at the element's end, where (w, v) is X (w, v) + S u, X = [1 0; -arm 1], S = [turns; moves].
void add_child(const HelixElement& element, const Matrix6d& I, const Vector6d& z, Form& form) {
  const Matrix3d arm = skew(element.end.position - element.start.position);
  Matrix63d S;
  S << element.at_end.turns, element.at_end.moves;
  const auto to_start = [&](auto&& rows) {
    rows.template topRows<3>() += arm * rows.template bottomRows<3>();
  };
  Matrix63d IS = I * S;
  form.of_rates.noalias() += S.transpose() * IS;
  to_start(IS);
  form.mixed += IS;
  Matrix6d shifted = I;
  to_start(shifted);
  shifted.leftCols<3>() -= shifted.rightCols<3>() * arm;
  form.of_start += shifted;
  form.push_rates += S.transpose() * z;
  Vector6d push = z;
  to_start(push);
  form.push_start += push;
}

}  // namespace

std::array<double, 8> stumpff(double x) {
  std::array<double, 8> c;
  if (x < 4) {
    c[6] = series(6, x);
    c[7] = series(7, x);
    for (int k = 5; k >= 0; --k) c[k] = kInverseFactorial[k] - x * c[k + 2];
  } else {
    const double a = std::sqrt(x);
    c[0] = std::cos(a);
    c[1] = std::sin(a) / a;
    for (int k = 2; k < 8; ++k) c[k] = (kInverseFactorial[k - 2] - c[k - 2]) / x;
  }
  return c;
}

MaterialFrame frame_at(const MaterialFrame& start, const Vector3d& curvature, double s) {
  const Vector3d p = s * curvature;
  const std::array<double, 8> c = stumpff(p.squaredNorm());
  const Vector3d along = from_axis(p, c[2], c[3]).col(2);
  return {start.position + start.axes * (s * along), start.axes * from_axis(p, c[1], c[2])};
}

void carry_frames(const MaterialFrame& root, std::vector<HelixElement>& elements) {
  const MaterialFrame* before = &root;
  for (HelixElement& element : elements) {
    element.start = *before;
    element.end = frame_at(element.start, element.curvature, element.length);
    before = &element.end;
  }
}

void helix_stiffness(const HelixStrand& strand, Output K) {
  for (int i = 0; i < strand.elements(); ++i)
    K.segment<3>(3 * i) =
        strand.lengths[i] * Vector3d(strand.bend_rigidity, strand.bend_rigidity, strand.twist_rigidity);
}

void elastic_force(const HelixStrand& strand, Input q, Output force) {
  helix_stiffness(strand, force);
  force.array() *= strand.natural.array() - q.array();
}

HelixJacobian jacobian_at(const MaterialFrame& start, const Vector3d& curvature, double s) {
  const Vector3d p = s * curvature, e(0, 0, 1), y = p.cross(e);
  const std::array<double, 8> c = stumpff(p.squaredNorm());
  const double d2 = 2 * c[4] - c[3], d3 = 3 * c[5] - c[4];  // 2 dc_2/dx, 2 dc_3/dx
  // dp changes c_k by dc_k/dx 2 p.dp, and p x e by dp x e.
  const Matrix3d by_p = (d2 * y + d3 * p.cross(y)) * p.transpose() - skew(c[2] * e + c[3] * y) -
                        c[3] * (e * p.transpose() - p[2] * Matrix3d::Identity());
  return {start.axes * (s * from_axis(p, c[2], c[3])), start.axes * (s * s * by_p)};
}

// Goes from the tip on, with the force on the end of an element and the torque about this end.
void generalised_force(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                       Output Q) {
  Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();
  std::size_t j = points.size();
  for (std::size_t i = elements.size(); i-- > 0;) {
    const HelixElement& element = elements[i];
    Q.segment<3>(3 * i) =
        element.at_end.turns.transpose() * torque + element.at_end.moves.transpose() * force;
    torque += (element.end.position - element.start.position).cross(force);
    for (; j > 0 && points[j - 1].element == static_cast<int>(i); --j) {
      const HelixPoint& point = points[j - 1];
      Q.segment<3>(3 * i) += point.moves.transpose() * point.force;
      torque += (point.position - element.start.position).cross(point.force);
      force += point.force;
    }
  }
}

// Makes a row of blocks for each element, from the tip on: M_ik = S_i^T times the impulse of the hair beyond
// the end of i while element k moves it. All of that hair moves as one body if k < i, so I and the mixed
// block are enough.
void mass_matrix(const std::vector<HelixElement>& elements, const std::vector<HelixPoint>& points,
                 Eigen::Ref<Eigen::MatrixXd> M) {
  Matrix6d I = Matrix6d::Zero();
  std::size_t j = points.size();
  for (std::size_t i = elements.size(); i-- > 0;) {
    Form form;
    add_child(elements[i], I, Vector6d::Zero(), form);
    for (; j > 0 && points[j - 1].element == static_cast<int>(i); --j)
      add_point(points[j - 1], elements[i].start.position, 0, form);
    form.of_start.bottomLeftCorner<3, 3>() = form.of_start.topRightCorner<3, 3>().transpose();
    I = form.of_start;
    M.block<3, 3>(3 * i, 3 * i) = form.of_rates;
    Matrix63d carried = form.mixed;  // the impulse on the start of i that its rates need
    for (std::size_t k = i; k-- > 0;) {
      const HelixJacobian& S = elements[k].at_end;
      M.block<3, 3>(3 * k, 3 * i) =
          S.turns.transpose() * carried.topRows<3>() + S.moves.transpose() * carried.bottomRows<3>();
      M.block<3, 3>(3 * i, 3 * k) = M.block<3, 3>(3 * k, 3 * i).transpose();
      const Matrix3d arm = skew(elements[k].end.position - elements[k].start.position);
      carried.topRows<3>() += arm * carried.bottomRows<3>();
    }
  }
}

void helix_step(const HelixStrand& strand, const std::vector<HelixElement>& elements,
                const std::vector<HelixPoint>& points, Input q, Input rates, double h, Scratch scratch,
                Output change) {
  auto K = scratch.col(7), elastic = scratch.col(8), ahead = scratch.col(9);
  helix_stiffness(strand, K);
  ahead = q + h * rates;
  elastic_force(strand, ahead, elastic);

  Matrix6d I = Matrix6d::Zero();
  Vector6d z = Vector6d::Zero();
  std::size_t j = points.size();
  for (std::size_t i = elements.size(); i-- > 0;) {
    Form form;
    add_child(elements[i], I, z, form);
    for (; j > 0 && points[j - 1].element == static_cast<int>(i); --j)
      add_point(points[j - 1], elements[i].start.position, h, form);
    form.of_start.bottomLeftCorner<3, 3>() = form.of_start.topRightCorner<3, 3>().transpose();
    form.of_rates.diagonal() += h * h * K.segment<3>(3 * i);
    form.push_rates += h * elastic.segment<3>(3 * i);
    Matrix3d& L = form.of_rates;
    solver::block_cholesky::factor(L);
    auto by_start = scratch.block<3, 6>(3 * i, 0);
    auto free = scratch.block<3, 1>(3 * i, 6);
    for (int k = 0; k < 6; ++k) by_start.col(k) = solve(L, form.mixed.row(k).transpose());
    free = solve(L, form.push_rates);
    I = form.of_start - form.mixed * by_start;
    z = form.push_start - form.mixed * free;
  }
  Vector6d motion = Vector6d::Zero();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const Vector3d u = scratch.block<3, 1>(3 * i, 6) - scratch.block<3, 6>(3 * i, 0) * motion;
    change.segment<3>(3 * i) = u;
    const Vector3d arm = elements[i].end.position - elements[i].start.position;
    motion.tail<3>() += motion.head<3>().cross(arm) + elements[i].at_end.moves * u;
    motion.head<3>() += elements[i].at_end.turns * u;
  }
}

}  // namespace hair
