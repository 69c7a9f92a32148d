// STAFF ONLY. Bounds of H1's and H3's springs, and hidden cases of the geometric term.
#include "grader/judge/strand_springs.h"

#include <algorithm>

namespace grader::inline judge {
namespace {

using Eigen::Vector3d;

struct Spring {
  double k, rest, length;
};

Vector3d vector_of(const VectorXd& of, int first, int apart) {
  return of.segment<3>(3 * (first + apart)) - of.segment<3>(3 * first);
}

int number(const Springs& springs, const Posed& posed) {
  return std::max(0, posed.strand.count() - springs.apart);
}

Spring spring(const Springs& springs, const Posed& posed, int i) {
  const double rest = posed.strand.rest_length.segment(i, springs.apart).sum();
  return {posed.strand.*springs.rigidity / rest, rest, vector_of(posed.x, i, springs.apart).norm()};
}

void expect_same(Trial& trial, const TermProduct& product, const Posed& posed, GeometricTerm term,
                 const VectorXd& dx, const VectorXd& expected, const std::string& what) {
  expect_vector(trial, product.ask(trial, posed, dx, term), expected, 2 * product.rounding(posed, dx), what);
}

}  // namespace

double energy_rounding(const Springs& springs, const Posed& posed, double energy) {
  double rounding = kUnit * number(springs, posed) * energy;
  for (int i = 0; i < number(springs, posed); ++i) {
    const auto [k, l0, l] = spring(springs, posed, i);
    rounding += 64 * kUnit * k * (std::abs(l - l0) + 64 * kUnit * l0) * (l + l0);
    rounding += 4 * kUnit * k * (l + l0) * (l + l0);
  }
  return rounding;
}

double force_rounding(const Springs& springs, const Posed& posed) {
  double most = 0;
  for (int i = 0; i < number(springs, posed); ++i) {
    const auto [k, l0, l] = spring(springs, posed, i);
    most = std::max(most, k * (l + l0));
  }
  return 128 * kUnit * most;
}

double product_rounding(const Springs& springs, const Posed& posed, const VectorXd& dx) {
  double most = 0;
  for (int i = 0; i < number(springs, posed); ++i) {
    const auto [k, l0, l] = spring(springs, posed, i);
    if (l > 0) most = std::max(most, k * (1 + l0 / l) * vector_of(dx, i, springs.apart).norm());
  }
  return 128 * kUnit * most;
}

void expect_filtered(Trial& trial, const TermProduct& product, const Posed& longer, const Posed& shorter,
                     const VectorXd& dx) {
  const VectorXd full = product.ask(trial, longer, dx, GeometricTerm::full);
  expect_not_zero(trial, full, "the product");
  expect_same(trial, product, longer, GeometricTerm::filtered, dx, full,
              "the filtered product of what is stretched");
  expect_same(trial, product, shorter, GeometricTerm::filtered, dx,
              product.ask(trial, shorter, dx, GeometricTerm::dropped),
              "the filtered product of what is compressed");
}

void expect_along_a_line(Trial& trial, const TermProduct& product, const Posed& line,
                         const Vector3d& direction, const VectorXd& dx) {
  VectorXd along(dx.size());
  for (int i = 0; i < line.strand.count(); ++i)
    along.segment<3>(3 * i) = direction * direction.dot(dx.segment<3>(3 * i));
  const VectorXd full = product.ask(trial, line, along, GeometricTerm::full);
  for (GeometricTerm term : {GeometricTerm::filtered, GeometricTerm::dropped})
    expect_same(trial, product, line, term, along, full, "the product along a line");
  expect_same(trial, product, line, GeometricTerm::dropped, dx - along, VectorXd::Zero(dx.size()),
              "the product across a line, without the geometric term");
}

void expect_own_directions(Trial& trial, const TermProduct& product, const Posed& bent, int apart) {
  for (int i = 0; i + apart < bent.strand.count(); ++i) {
    VectorXd dx = VectorXd::Zero(bent.x.size());
    dx.segment<3>(3 * i) = random_vector(trial.random, 3);
    const auto at_the_other = [&](GeometricTerm term) -> VectorXd {
      return product.ask(trial, bent, dx, term).segment<3>(3 * (i + apart));
    };
    const Vector3d u = vector_of(bent.x, i, apart).normalized();
    const double along = u.dot(Vector3d(at_the_other(GeometricTerm::full)));
    expect_vector(trial, at_the_other(GeometricTerm::dropped), u * along, 2 * product.rounding(bent, dx),
                  "the product of a bent strand, without the geometric term");
  }
}

void expect_own_term(Trial& trial, const TermProduct& product, const Posed& two, int moved, bool longer) {
  VectorXd dx = VectorXd::Zero(two.x.size());
  dx.segment<3>(3 * moved) = random_vector(trial.random, 3);
  const GeometricTerm same = longer ? GeometricTerm::full : GeometricTerm::dropped;
  expect_same(trial, product, two, GeometricTerm::filtered, dx, product.ask(trial, two, dx, same),
              "the filtered product of a strand with a stretched and a compressed spring");
}

}  // namespace grader::judge
