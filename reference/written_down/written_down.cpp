// STAFF ONLY. Masses and springs as one program: stretch springs (H1), angular springs (H2) and a root that
// is held, by four methods. Nothing in it can be replaced, so it shows what a method costs. It shares no code
// with the exercises.
#include "hair/lab/study/written_down.h"

#include <algorithm>
#include <cmath>

#include "solver/timing.h"

namespace hair {

namespace {

using Eigen::Vector3d, Eigen::Matrix3d;
using Vectors = std::vector<Vector3d>;

struct Written {
  // The blocks of a row of the band: its own, the one before it, and the one before that. Then the factor's,
  // with inverse numbers on the diagonal.
  struct Row {
    Matrix3d own, beside, beyond;
  };
  struct Link {
    Vector3d u;
    double off, below, pivot;
  };

  const Strand& strand;
  Vector3d gravity;
  int n = strand.segments();
  Vectors x = Vectors(n + 1, Vector3d::Zero()), v = x, f = x, y = x, k[4] = {x, x, x, x};
  std::vector<Row> rows = std::vector<Row>(n + 1);
  std::vector<Link> links = std::vector<Link>(n + 1);

  // f at `at`, and the band M + by S. Segment i lies between the particles i - 1 and i.
  template <bool with_matrix>
  void sum_up(const Vectors& at, double by, GeometricTerm term) {
    for (int i = 0; i <= n; ++i) {
      f[i] = strand.mass[i] * gravity;
      if (with_matrix) rows[i] = {strand.mass[i] * Matrix3d::Identity(), Matrix3d::Zero(), Matrix3d::Zero()};
    }
    Vector3d before = strand.root_tangent;
    double per_before = 0;  // 1 / length of the segment before; the tangent does not move
    for (int i = 1; i <= n; ++i) {
      const Vector3d e = at[i] - at[i - 1];
      const double l0 = strand.rest_length[i - 1], length = e.norm(), per_length = 1 / length;
      const double stiffness = strand.stretch_rigidity / l0;
      const Vector3d u = e * per_length, pull = stiffness * (length - l0) * u;
      f[i - 1] += pull;
      f[i] -= pull;
      if (with_matrix) {
        double share = term == GeometricTerm::dropped ? 0 : 1 - l0 * per_length;
        if (term == GeometricTerm::filtered) share = std::max(share, 0.0);
        Matrix3d block = (by * stiffness * (1 - share) * u) * u.transpose();
        block.diagonal().array() += by * stiffness * share;
        rows[i - 1].own += block;
        rows[i].own += block;
        rows[i].beside -= block;
      }
      if (strand.bend_rigidity > 0 && (i > 1 || strand.clamped)) {
        const double kb = strand.bend_rigidity / (i > 1 ? (strand.rest_length[i - 2] + l0) / 2 : l0 / 2);
        const Vector3d c = before.cross(u);
        const double sine = c.norm(), cosine = before.dot(u);
        const bool bent = sine > 1e-8;
        const double q = bent ? 2 * std::atan(sine / (1 + cosine)) / sine : 1;
        const Vector3d w = kb * q * c, above = -per_before * w.cross(before), below = per_length * w.cross(u);
        f[i] -= below;
        f[i - 1] += below - above;
        if (i > 1) f[i - 2] += above;
        if (with_matrix) {
          const Vector3d b = bent ? Vector3d(c * (1 / sine)) : before.unitOrthogonal();
          const Vector3d g1 = -per_before * b.cross(before), g2 = per_length * b.cross(u);
          const Vector3d g[3] = {-g1, g1 - g2, g2};
          const double h[3] = {per_before, -per_before - per_length, per_length};  // times b
          const double stiff = by * kb, across = stiff * std::max(q * cosine, 0.0);
          const auto block = [&](int r, int s) -> Matrix3d {
            return (stiff * g[r]) * g[s].transpose() + (across * h[r] * h[s] * b) * b.transpose();
          };
          rows[i].own += block(2, 2);
          rows[i].beside += block(2, 1);
          rows[i - 1].own += block(1, 1);
          if (i > 1) {
            rows[i].beyond += block(2, 0);
            rows[i - 1].beside += block(1, 0);
            rows[i - 2].own += block(0, 0);
          }
        }
      }
      before = u;
      per_before = per_length;
    }
  }

  static void divide(Matrix3d& A, const Matrix3d& L) {  // A := A L^-T
    A.col(0) *= L(0, 0);
    A.col(1) = (A.col(1) - A.col(0) * L(1, 0)) * L(1, 1);
    A.col(2) = (A.col(2) - A.col(0) * L(2, 0) - A.col(1) * L(2, 1)) * L(2, 2);
  }

  // v += dv, where (M + a b S) dv = a f - a b S v: Cholesky's factor, forth and back.
  void filter(double a, double b, GeometricTerm term) {
    sum_up<true>(x, a * b, term);
    for (int i = 1; i <= n; ++i) {
      Vector3d r = a * f[i] + strand.mass[i] * v[i] - rows[i].own * v[i] - rows[i].beside * v[i - 1];
      if (i > 1) r -= rows[i].beyond * v[i - 2];
      if (i < n) r -= rows[i + 1].beside.transpose() * v[i + 1];
      if (i + 1 < n) r -= rows[i + 2].beyond.transpose() * v[i + 2];
      y[i] = r;
    }
    for (int i = 1; i <= n; ++i) {
      auto& [L, beside, beyond] = rows[i];
      Vector3d r = y[i];
      if (i > 2) {
        divide(beyond, rows[i - 2].own);
        beside -= beyond.lazyProduct(rows[i - 1].beside.transpose());
        L -= beyond.lazyProduct(beyond.transpose());
        r -= beyond * y[i - 2];
      }
      if (i > 1) {
        divide(beside, rows[i - 1].own);
        L -= beside.lazyProduct(beside.transpose());
        r -= beside * y[i - 1];
      }
      L(0, 0) = 1 / std::sqrt(L(0, 0));
      L(1, 0) *= L(0, 0);
      L(2, 0) *= L(0, 0);
      L(1, 1) = 1 / std::sqrt(L(1, 1) - L(1, 0) * L(1, 0));
      L(2, 1) = (L(2, 1) - L(2, 0) * L(1, 0)) * L(1, 1);
      L(2, 2) = 1 / std::sqrt(L(2, 2) - L(2, 0) * L(2, 0) - L(2, 1) * L(2, 1));
      r[0] *= L(0, 0);
      r[1] = (r[1] - L(1, 0) * r[0]) * L(1, 1);
      r[2] = (r[2] - L(2, 0) * r[0] - L(2, 1) * r[1]) * L(2, 2);
      y[i] = r;
    }
    for (int i = n; i > 0; --i) {
      Vector3d r = y[i];
      if (i < n) r -= rows[i + 1].beside.transpose() * y[i + 1];
      if (i + 1 < n) r -= rows[i + 2].beyond.transpose() * y[i + 2];
      const Matrix3d& L = rows[i].own;
      r[2] *= L(2, 2);
      r[1] = (r[1] - L(2, 1) * r[2]) * L(1, 1);
      r[0] = (r[0] - L(1, 0) * r[1] - L(2, 0) * r[2]) * L(0, 0);
      y[i] = r;
      v[i] += r;
    }
  }

  // Newton's steps for the lengths, each a tridiagonal system.
  void correct() {
    for (int pass = 0; pass < 100; ++pass) {
      double worst = 0;
      for (int i = 1; i <= n; ++i) {
        const Vector3d e = x[i] - x[i - 1];
        const double length = e.norm(), l0 = strand.rest_length[i - 1];
        links[i] = {e * (1 / length), l0 - length, 0, 1 / strand.mass[i]};
        worst = std::max(worst, std::abs(length - l0) / l0);
      }
      if (worst <= 1e-12) return;
      for (int i = 2; i <= n; ++i) {
        Link &link = links[i], &last = links[i - 1];
        const double w = 1 / strand.mass[i - 1], beside = -w * last.u.dot(link.u);
        link.below = beside / last.pivot;
        link.pivot += w - link.below * beside;
        link.off -= link.below * last.off;
      }
      for (int i = n; i > 0; --i) {
        links[i].off /= links[i].pivot;
        if (i < n) links[i].off -= links[i + 1].below * links[i + 1].off;
        const Vector3d impulse = links[i].off * links[i].u;
        x[i] += impulse * (1 / strand.mass[i]);
        if (i > 1) x[i - 1] -= impulse * (1 / strand.mass[i - 1]);
      }
    }
  }

  void accelerations(const Vectors& at, Vectors& a) {
    sum_up<false>(at, 0, {});
    for (int i = 1; i <= n; ++i) a[i] = f[i] * (1 / strand.mass[i]);
  }

  void runge_kutta_4(double h) {
    const auto slope = [&](double of_v, double of_a, const Vectors& a, Vectors& next) {
      for (int i = 0; i <= n; ++i) y[i] = x[i] + of_v * v[i] + of_a * a[i];
      accelerations(y, next);
    };
    accelerations(x, k[0]);
    slope(h / 2, 0, k[0], k[1]);
    slope(h / 2, h * h / 4, k[0], k[2]);
    slope(h, h * h / 2, k[1], k[3]);
    for (int i = 0; i <= n; ++i) {
      x[i] += h * v[i] + h * h / 6 * (k[0][i] + k[1][i] + k[2][i]);
      v[i] += h / 6 * (k[0][i] + 2 * k[1][i] + 2 * k[2][i] + k[3][i]);
    }
  }

  void step(Method method, GeometricTerm term, double h) {
    if (method == Method::runge_kutta_4) return runge_kutta_4(h);
    const bool corrects = method == Method::predictor_corrector;
    if (method == Method::symplectic_euler) {
      accelerations(x, k[0]);
      for (int i = 0; i <= n; ++i) v[i] += h * k[0][i];
    } else {
      filter(corrects ? h / 2 : h, h, term);
    }
    for (int i = 0; i <= n; ++i) x[i] += h * v[i];
    if (!corrects) return;
    y = x;
    correct();
    for (int i = 0; i <= n; ++i) v[i] += (x[i] - y[i]) * (1 / h);
    filter(h / 2, h, term);
  }
};

// Strands that are straight at rest, in still air, with a root that nobody moves.
bool can_write_down(const Problem& problem, const StudyMethod& method) {
  if (problem.is_toy() || !problem.scene.riders.empty() || problem.scene.hair.drag > 0) return false;
  const StrandStart& start = problem.scene.hair.strands[0];
  return start.rest_curvature.size() == 0 && start.strand.skip_rigidity == 0 && method.preconditioner &&
         method.bend_product == (method.is_explicit() ? Products::exact : Products::definite) &&
         method.method != Method::forward_euler && method.method != Method::midpoint &&
         (method.is_explicit() || method.geometric_term != GeometricTerm::full);
}

}  // namespace

std::optional<WrittenRun> run_written_down(const Problem& problem, const StudyMethod& method,
                                           int steps_per_moment) {
  if (!can_write_down(problem, method)) return {};
  const StrandStart& start = problem.scene.hair.strands[0];
  const int steps = steps_per_moment * kMoments;
  std::vector<double> seconds;
  WrittenRun run;
  for (int repeat = 0; repeat < 5; ++repeat) {
    Written strand{start.strand, problem.scene.hair.gravity};
    for (int i = 0; i <= strand.n; ++i) {
      strand.x[i] = start.state.x.segment<3>(3 * i);
      strand.v[i] = start.state.v.segment<3>(3 * i);
    }
    const double begin = timing::cpu_seconds();
    for (int i = 0; i < steps; ++i)
      strand.step(method.method, method.geometric_term, problem.duration / steps);
    seconds.push_back(timing::cpu_seconds() - begin);
    run.x = Eigen::Map<const Eigen::VectorXd>(strand.x[0].data(), start.state.x.size());
  }
  run.seconds = timing::median(seconds);
  return run;
}

}  // namespace hair
