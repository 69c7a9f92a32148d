// The checks that H1 and H3 share. Their springs differ in the particles that they join, and in names.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <sstream>
#include <string>
#include <vector>

#include "check.h"
#include "derivative.h"
#include "hair/geometric_term.h"
#include "ordinary.h"
#include "particles/vectors.h"
#include "strands.h"

namespace checks {

struct Springs {
  using Strand = hair::Strand;
  using Term = hair::GeometricTerm;
  using Vector3d = Eigen::Vector3d;
  using VectorXd = Eigen::VectorXd;
  using Numbers = std::initializer_list<double>;
  static constexpr std::initializer_list<Term> kTerms = {Term::full, Term::filtered, Term::dropped};

  // The exercise's functions and their names, in the order of the header.
  double (*energy)(const Strand&, particles::Input x);
  void (*add_force)(const Strand&, particles::Input x, particles::Output f);
  void (*add_product)(const Strand&, particles::Input x, Term, particles::Input dx, particles::Output df);
  std::string names[3];
  double Strand::*rigidity;
  std::string rigidity_name;  // "EA"
  std::string length;         // "l"; at rest "l0"
  int apart;                  // a spring joins particles i and i + apart

  std::vector<Function> functions() const {
    const Case lone{strand_of(VectorXd(0)), VectorXd::Zero(3)};
    return {{names[0], [=, this] { energy(lone.strand, lone.x); }},
            {names[1], [=, this] { force(lone); }, {names[0]}},
            {names[2], [=, this] { product(lone, Term::full, lone.x); }, {names[1]}}};
  }

  VectorXd force(const Case& c) const {
    VectorXd f = VectorXd::Zero(c.x.size());
    add_force(c.strand, c.x, f);
    return f;
  }

  VectorXd product(const Case& c, Term term, const VectorXd& dx) const {
    VectorXd df = VectorXd::Zero(c.x.size());
    add_product(c.strand, c.x, term, dx, df);
    return df;
  }

  Strand strand_of(const VectorXd& rest_length) const { return strand_with(rigidity, 12, rest_length); }

  // All springs are 1 m long at rest: k is the rigidity.
  Strand metres(int count) const { return strand_of(VectorXd::Constant(count - 1, 1.0 / apart)); }

  // A strand bent every way, with springs that are longer and shorter than at rest.
  static Case bent(int count, int which) {
    Scatter numbers(which);
    Case c{ordinary_strand(numbers, count), {}};
    c.x = ordinary_positions(numbers, c.strand, 0.6, 1.7, 1);
    return c;
  }

  struct Spring {
    double k, rest, length;

    double force() const { return k * (length - rest); }
  };

  Spring spring(const Case& c, int i) const {
    const double rest = c.strand.rest_length.segment(i, apart).sum();
    return {c.strand.*rigidity / rest, rest,
            (c.x.segment<3>(3 * (i + apart)) - c.x.segment<3>(3 * i)).norm()};
  }

  // Bounds: the shortest spring, and the largest k (l + l0) and k (1 + l0/l).
  struct Sizes {
    double shortest = 1e300, force = 0, product = 0;
  };
  Sizes sizes(const Case& c) const {
    Sizes all;
    for (int i = 0; i + apart < c.strand.count(); ++i) {
      const auto [k, rest, now] = spring(c, i);
      all.shortest = std::min(all.shortest, now);
      all.force = std::max(all.force, k * (now + rest));
      all.product = std::max(all.product, k * (1 + rest / now));
    }
    return all;
  }

  // One spring of this length, along (2, -3, 6); a particle between its ends lies aside.
  Case one_spring(const VectorXd& rest_length, double length_now) const {
    Case c{strand_of(rest_length), VectorXd(3 * rest_length.size() + 3)};
    for (int i = 0; i < c.x.size(); ++i) c.x[i] = i * i % 7 / 4.0;
    c.x.tail<3>() = c.x.head<3>() + along() * length_now / 7;
    return c;
  }
  static Vector3d along() { return {2, -3, 6}; }
  static Vector3d across() { return {3, 2, 0}; }

  // All zeros, but for this vector at the spring's root end, and its opposite at the tip.
  static VectorXd at_ends(const Case& c, const Vector3d& of_root) {
    VectorXd all = VectorXd::Zero(c.x.size());
    all.head<3>() = of_root;
    all.tail<3>() = -of_root;
    return all;
  }

  std::string in_words(const Case& c) const {
    const auto [k, rest, now] = spring(c, 0);
    std::ostringstream text;
    text << " of one spring, " << rigidity_name << " = 12 N, " << length << "0 = " << rest << " m, " << length
         << " = " << now << " m, x = " << particles_in_words(c.x);
    return text.str();
  }

  void expect_energy(const VectorXd& rest_length, Numbers lengths) const {
    for (const double length_now : lengths) {
      const Case c = one_spring(rest_length, length_now);
      const auto [k, rest, now] = spring(c, 0);
      expect_number(energy(c.strand, c.x), k * (now - rest) * (now - rest) / 2,
                    64 * kU * k * (now + rest) * (now + rest), "the energy" + in_words(c),
                    "k (" + length + " - " + length + "0)^2 / 2 J");
    }
  }

  void expect_force(const VectorXd& rest_length, Numbers lengths) const {
    for (const double length_now : lengths) {
      const Case c = one_spring(rest_length, length_now);
      const Spring one = spring(c, 0);
      const bool none = length_now == 0;
      expect_entries(force(c), at_ends(c, none ? Vector3d(0, 0, 0) : one.force() / 7 * along()),
                     none ? 0 : 64 * kU * one.k * (one.length + one.rest), "the force" + in_words(c),
                     "64 u of k (" + length + " + " + length + "0): rounding");
    }
  }

  static double geometric(const Spring& one, Term term) {
    const double exact = 1 - one.rest / one.length;
    return term == Term::full ? exact : term == Term::filtered ? std::max(exact, 0.0) : 0;
  }

  // The tip moves along the spring, and across it.
  void expect_product(const VectorXd& rest_length, Numbers lengths, std::initializer_list<Term> terms) const {
    static const char* const names_of_terms[] = {"full", "filtered", "dropped"};
    for (const double length_now : lengths)
      for (const Term term : terms)
        for (const Vector3d& move : {along(), across()}) {
          const Case c = one_spring(rest_length, length_now);
          const Spring one = spring(c, 0);
          const bool none = length_now == 0;
          const double share = none ? 0 : move == along() ? 1 : geometric(one, term);
          VectorXd dx = VectorXd::Zero(c.x.size());
          dx.tail<3>() = move;
          expect_entries(product(c, term, dx), at_ends(c, one.k * share * move),
                         none ? 0 : 64 * kU * one.k * (1 + one.rest / one.length) * 7,
                         std::string("the ") + names_of_terms[static_cast<int>(term)] + " product" +
                             in_words(c) + ", for a tip that moves " +
                             (move == along() ? "along it" : "across it"),
                         "64 u of k (1 + " + length + "0/" + length + ") |dx|: rounding");
        }
  }

  // The first of two springs has no length: the second does what it does alone.
  void expect_to_go_on() const {
    const Case alone = one_spring(metres(1 + apart).rest_length, 1.75);
    Case both{metres(2 + apart), VectorXd(alone.x.size() + 3)};
    both.x << alone.x.segment<3>(3 * apart - 3), alone.x;
    const VectorXd dx = scattered_vector(static_cast<int>(both.x.size()), 1);
    const auto expect = [&](const VectorXd& actual, const VectorXd& of_alone, double bound,
                            const std::string& what) {
      VectorXd expected = VectorXd::Zero(both.x.size());
      expected.tail(alone.x.size()) = of_alone;
      expect_entries(
          actual, expected, bound,
          what + " of two springs, the first without a length, compared with that of the second alone, x = " +
              particles_in_words(both.x),
          "rounding");
    };
    expect(force(both), force(alone), 64 * kU * sizes(alone).force, "the force");
    for (const Term term : kTerms)
      expect(product(both, term, dx), product(alone, term, dx.tail(alone.x.size())),
             128 * kU * sizes(alone).product, "the product");
  }

  // A straight strand, each segment longer than at rest by a fifth, so that all springs pull alike.
  Case evenly_stretched(const Strand& strand) const {
    Scatter numbers(strand.count());
    const Vector3d u = ordinary_direction(numbers);
    Case c{strand, VectorXd::Zero(3 * strand.count())};
    for (int i = 0; i < strand.segments(); ++i)
      c.x.segment<3>(3 * i + 3) = c.x.segment<3>(3 * i) + 1.2 * strand.rest_length[i] * u;
    return c;
  }
  // Coordinates round by u of the last one, and so do lengths.
  double rounding_of_line(const Case& c) const {
    return 64 * kU * (sizes(c).force + sizes(c).product * c.x.tail<3>().norm());
  }
  std::string line_in_words(const Strand& strand) const {
    std::ostringstream text;
    text << strand.count() << " particles on a line, each segment a fifth longer than at rest, "
         << rigidity_name << " = " << strand.*rigidity << " N, rest lengths "
         << checks::in_words({strand.rest_length.begin(), strand.rest_length.end()}) << " m";
    return text.str();
  }

  void expect_even_energy(const Strand& strand) const {
    const Case c = evenly_stretched(strand);
    double of_all = 0;
    for (int i = 0; i + apart < strand.count(); ++i)
      of_all += strand.*rigidity * 0.04 / 2 * spring(c, i).rest;
    expect_number(energy(strand, c.x), of_all, strand.count() * rounding_of_line(c),
                  "the energy of " + line_in_words(strand),
                  rigidity_name + " 0.2^2 / 2 J times the sum of all " + length + "0");
  }

  void expect_even_force(const Strand& strand) const {
    const Case c = evenly_stretched(strand);
    VectorXd pulls = VectorXd::Zero(c.x.size());
    for (int i = 0; i + apart < strand.count(); ++i) {
      const Vector3d pull = strand.*rigidity / 5 * c.x.tail<3>().normalized();
      pulls.segment<3>(3 * i) += pull;
      pulls.segment<3>(3 * (i + apart)) -= pull;
    }
    expect_entries(force(c), pulls, rounding_of_line(c),
                   "each spring pulls with " + rigidity_name + " / 5: the force on " + line_in_words(strand),
                   "64 u of k (" + length + " + " + length + "0) and of k (1 + " + length + "0/" + length +
                       ") times the strand's length: rounding");
  }

  void expect_gradient(std::initializer_list<int> counts) const {
    for (const int count : counts) {
      const Case c = bent(count, count);
      checks::expect_force(
          force(c), [&](const VectorXd& x) { return energy(c.strand, x); }, c.x, sizes(c).shortest,
          sizes(c).force);
    }
  }

  void expect_derivative(std::initializer_list<int> counts) const {
    for (const int count : counts) {
      const Case c = bent(count, count + 20);
      const VectorXd dx = scattered_vector(3 * count, 5);
      checks::expect_product(
          product(c, Term::full, dx),
          [&](const VectorXd& x) {
            return force({c.strand, x});
          },
          c.x, dx, sizes(c).shortest, 2 * sizes(c).product);
    }
  }

  void expect_balance() const {
    const Case c = bent(9, 3);
    const VectorXd f = force(c);
    EXPECT_GT(f.norm(), 1) << "no force at all";
    expect_balanced(f, c.x, 9 * 64 * kU * sizes(c).force,
                    "rounding: 64 u of k (" + length + " + " + length + "0) for each of 9 particles");
  }

  void expect_symmetry() const {
    const Case c = bent(8, 2);
    for (const Term term : kTerms)
      expect_symmetric([&](const VectorXd& dx) { return product(c, term, dx); }, scattered_vector(24, 1),
                       scattered_vector(24, 2), 24 * 128 * kU * sizes(c).product, bound_of_sums());
  }

  // Without the geometric term a spring whose root moves pulls its other end along itself.
  void expect_own_directions() const {
    const Case c = bent(8, 4);
    for (int i = 0; i + apart < 8; ++i) {
      VectorXd dx = VectorXd::Zero(24);
      dx.segment<3>(3 * i) = Vector3d(0.3, -0.5, 0.7);
      const Vector3d u = (c.x.segment<3>(3 * (i + apart)) - c.x.segment<3>(3 * i)).normalized(),
                     df = product(c, Term::dropped, dx).segment<3>(3 * (i + apart));
      expect_entries(df, u * u.dot(df), 64 * kU * sizes(c).product,
                     "the dropped product at particle " + std::to_string(i + apart) + ", where particle " +
                         std::to_string(i) + " alone moves, compared with its part along that spring, x = " +
                         particles_in_words(c.x),
                     "64 u of k (1 + " + length + "0/" + length + "): rounding");
    }
  }

  void expect_semidefinite() const {
    const Case c = bent(8, 4);
    for (const Term term : {Term::filtered, Term::dropped})
      for (int which = 0; which < 20; ++which) {
        const VectorXd dx = scattered_vector(24, which);
        EXPECT_LE(dx.dot(product(c, term, dx)), 24 * 128 * kU * sizes(c).product)
            << "dx . (df/dx) dx for dx = " << particles_in_words(dx) << "; bound: " << bound_of_sums();
      }
  }
  std::string bound_of_sums() const {
    return "24 entries, 128 u of k (1 + " + length + "0/" + length + ") each: rounding";
  }

  void expect_all_added() const {
    const Case c = bent(5, 1);
    const VectorXd dx = scattered_vector(15, 2), before = scattered_vector(15, 8);
    expect_added([&](VectorXd& f) { add_force(c.strand, c.x, f); }, before, 8 * kU * (1 + sizes(c).force),
                 "f");
    for (const Term term : kTerms)
      expect_added([&](VectorXd& df) { add_product(c.strand, c.x, term, dx, df); }, before,
                   8 * kU * (1 + 4 * sizes(c).product), "df");
  }

  // Compares all answers in other units of length and with other rigidities.
  void expect_any_unit() const {
    const Case c = bent(6, 9);
    const VectorXd dx = scattered_vector(18, 3);
    const auto expect = [&](const auto& answer, int power, const std::string& what) {
      expect_in_units(answer, c, {-90, -50, 30}, power, 1e-12, what);
      expect_in_proportion(answer, c, rigidity, rigidity_name, what);
    };
    expect([&](const Strand& strand, const VectorXd& x) { return vector({energy(strand, x)}); }, 1,
           "the energy");
    expect([&](const Strand& strand, const VectorXd& x) { return force({strand, x}); }, 0, "the force");
    for (const Term term : kTerms)
      expect(
          [&](const Strand& strand, const VectorXd& x) {
            return product({strand, x}, term, dx);
          },
          -1, "the product");
  }
};

}  // namespace checks
