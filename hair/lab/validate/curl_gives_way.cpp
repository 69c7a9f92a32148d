// A curl that hangs from its upper end. Under a heavy weight it is a planar curve: its natural curvature
// shows only at its lower end. Under a lighter one it can lower its energy by leaving the plane, and does:
// the planar shape becomes unstable. See J. T. Miller, A. Lazarus, B. Audoly and P. M. Reis, "Shapes of a
// Suspended Curly Hair" (Physical Review Letters 112, 2014).
//
// In units of the length and of EI there are the weight Gamma = rho g S L^3 / EI, the total natural curvature
// phi, and GJ / EI = 1 / (1 + nu). The planar branch is followed from heavy weights down, in steps of
// Gamma^(1/3) / phi, which is the ratio of two lengths. It is stable as long as the energy's second
// derivatives out of the plane, by kappa1 and tau, are positive definite.
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "hair/lab/validate/validations.h"
#include "hair/super_helix/helix_forces.h"
#include "solver/dense_algebra.h"

namespace hair {

namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr double kPoisson = 0.45;
constexpr double kDown = 0.005;  // a step along the branch
constexpr double kPart = 1e-5;   // times phi: a difference quotient's step

class HangingCurl {
 public:
  HangingCurl(int elements, double phi) : phi_(phi), n_(elements), motion_(strand(elements, phi)) {
    q_ = VectorXd::Zero(3 * n_);
    // n1 to the side, t down.
    root_.axes << 1, 0, 0, 0, -1, 0, 0, 0, -1;
  }

  // Newton's method for kappa2, from its last value; a step is halved until the residual falls.
  void settle(double part, const ValidationSettings& settings) {
    weight_ = std::pow(part * phi_, 3);
    VectorXd r = bends(residual(q_));
    for (int k = 0; k < 200 && r.norm() > 1e-11 * phi_; ++k) {
      settings.go_on();
      const VectorXd change = derivative({1}).fullPivLu().solve(-r);
      double length = 1;
      for (;; length /= 2) {
        VectorXd there = q_;
        for (int i = 0; i < n_; ++i) there[3 * i + 1] += length * change[i];
        const VectorXd next = bends(residual(there));
        if (next.norm() < r.norm() || length < 1e-6) {
          q_ = there;
          r = next;
          break;
        }
      }
      if (length < 1e-6) return;
    }
  }

  // The smallest eigenvalue of the energy's second derivatives by kappa1 and tau.
  double softest() {
    const MatrixXd H = -derivative({0, 2});
    return solver::symmetric_eigenvalues((H + H.transpose()) / 2)[0];
  }

 private:
  static HelixStrand strand(int n, double phi) {
    HelixStrand strand;
    strand.lengths = VectorXd::Constant(n, 1.0 / n);
    strand.line_density = strand.bend_rigidity = 1;
    strand.twist_rigidity = 1 / (1 + kPoisson);
    strand.natural = VectorXd::Zero(3 * n);
    for (int i = 0; i < n; ++i) strand.natural[3 * i + 1] = phi;
    return strand;
  }

  VectorXd residual(const VectorXd& q) {
    motion_.place(root_, q);
    add_weight(Vector3d(0, 0, -weight_), motion_);
    VectorXd force(3 * n_), elastic(3 * n_);
    generalised_force(motion_.elements, motion_.points, force);
    elastic_force(motion_.strand(), q, elastic);
    return force + elastic;
  }
  VectorXd bends(const VectorXd& all) const { return all(Eigen::seqN(1, n_, 3)); }

  // The derivatives of the residual's entries of these kinds (0 kappa1, 1 kappa2, 2 tau of each element) by
  // the coordinates of the same kinds.
  MatrixXd derivative(const std::vector<int>& kinds) {
    std::vector<int> which;
    for (int i = 0; i < n_; ++i)
      for (const int kind : kinds) which.push_back(3 * i + kind);
    MatrixXd by(which.size(), which.size());
    const double step = kPart * phi_;
    for (std::size_t j = 0; j < which.size(); ++j) {
      VectorXd there = q_, back = q_;
      there[which[j]] += step;
      back[which[j]] -= step;
      by.col(static_cast<Eigen::Index>(j)) = (residual(there) - residual(back))(which) / (2 * step);
    }
    return by;
  }

  double phi_;
  int n_;
  HelixMotion motion_;
  MaterialFrame root_;
  VectorXd q_;
  double weight_ = 0;
};

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

// The point where the branch becomes unstable on the way down, and the one where it is stable again, or
// kNowhere.
struct Limits {
  double gives_way = kNowhere, holds_again = kNowhere;
  std::vector<Point> softest = {};  // along the branch: the eigenvalue over that of a straight element's bend
};

struct At {
  double part, softest;
};

// Finds the zero of the eigenvalue by secants.
double zero_between(HangingCurl& curl, At one, At other, const ValidationSettings& settings) {
  for (int k = 0; k < 4; ++k) {
    const double part = one.part - one.softest * (other.part - one.part) / (other.softest - one.softest);
    other = one;
    curl.settle(part, settings);
    one = {part, curl.softest()};
  }
  return one.part;
}

Limits follow(double phi, int elements, double last, const ValidationSettings& settings) {
  HangingCurl curl(elements, phi);
  Limits limits;
  double part = 0.8, before = 1;
  for (; part > last; part -= kDown) {
    curl.settle(part, settings);
    const double now = curl.softest();
    limits.softest.push_back({part, now * elements});
    if ((now < 0) != (before < 0)) {
      (now < 0 ? limits.gives_way : limits.holds_again) =
          zero_between(curl, {part, now}, {part + kDown, before}, settings);
      curl.settle(part, settings);
    }
    before = now;
  }
  return limits;
}

}  // namespace

ValidationResult curl_gives_way(const ValidationSettings& settings) {
  constexpr double kPi = std::numbers::pi;
  const struct {
    const char* name;
    int elements;
    double phi, gives_way, holds_again;
  } published[] = {{"2-pi", 20, 2 * kPi, 0.5651, 0.3698},
                   {"8", 20, 8, 0.6060, 0.3387},
                   {"4-pi", 20, 4 * kPi, 0.6109, kNowhere},
                   {"8-pi", 30, 8 * kPi, 0.6109, kNowhere}};
  ValidationResult result;
  Table table{"Gamma^(1/3) / phi where the planar shape of a hanging curl gives way",
              {"phi", "elements", "gives way", "measured", "holds again", "measured"},
              {}};
  Figure figure;
  figure.id = "curl-gives-way";
  figure.title = "A hanging curl: stability of its planar shape against weight";
  figure.description =
      "The softest way out of the plane. Below 0 the planar shape is unstable: the curl hangs in space.";
  figure.x = {"Gamma^(1/3) / phi", false};
  figure.y = {"smallest eigenvalue, over EI l", false};
  for (const auto& one : published) {
    if (settings.quick && &one != published) continue;
    const bool again = !std::isnan(one.holds_again);
    const Limits limits = follow(one.phi, one.elements, again ? 0.32 : 0.58, settings);
    const std::string phi = printed("%.4g", one.phi);
    std::vector<std::string>& row = table.rows.emplace_back(std::vector{phi, std::to_string(one.elements)});
    const auto compare = [&](const char* id, const std::string& what, double expected, double measured) {
      for (const double part : {expected, measured})
        row.push_back(std::isnan(part) ? "-" : printed("%.4f", part));
      if (!std::isnan(expected))
        result.checks.push_back({std::string("phi-") + one.name + id,
                                 "phi = " + phi + ": Gamma^(1/3) / phi where the planar shape " + what,
                                 "the boundary value problem of Kirchhoff's rod, nu = 0.45", expected,
                                 measured, 5e-3 * expected, "half a percent"});
    };
    compare("-gives-way", "gives way", one.gives_way, limits.gives_way);
    compare("-holds-again", "holds again", one.holds_again, limits.holds_again);
    figure.series.push_back({"phi = " + phi, limits.softest, true, false});
  }
  result.tables = {table};
  result.figures = {figure};
  return result;
}

}  // namespace hair
