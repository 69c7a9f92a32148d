// STAFF ONLY. Bounds of H1's and H3's springs, and their hidden cases.
#include "grader/judge/cases/strand_springs.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace grader::inline judge {
namespace {

using Eigen::Vector3d;

struct Spring {
  double k, rest, length;
};

Vector3d vector_of(const VectorXd& of, int first, int apart) {
  return of.segment<3>(3 * (first + apart)) - of.segment<3>(3 * first);
}

std::vector<Spring> springs_in(double Strand::*rigidity, int apart, const Posed& posed) {
  std::vector<Spring> all;
  for (int i = 0; i + apart < posed.strand.count(); ++i) {
    const double rest = posed.strand.rest_length.segment(i, apart).sum();
    all.push_back({posed.strand.*rigidity / rest, rest, vector_of(posed.x, i, apart).norm()});
  }
  return all;
}

}  // namespace

double energy_rounding(double Strand::*rigidity, int apart, const Posed& posed, double energy) {
  const std::vector<Spring> all = springs_in(rigidity, apart, posed);
  double rounding = kUnit * static_cast<double>(all.size()) * energy;
  for (const auto& [k, l0, l] : all) {
    rounding += 64 * kUnit * k * (std::abs(l - l0) + 64 * kUnit * l0) * (l + l0);
    rounding += 4 * kUnit * k * (l + l0) * (l + l0);
  }
  return rounding;
}

double force_rounding(double Strand::*rigidity, int apart, const Posed& posed) {
  double most = 0;
  for (const auto& [k, l0, l] : springs_in(rigidity, apart, posed)) most = std::max(most, k * (l + l0));
  return 128 * kUnit * most;
}

double product_rounding(double Strand::*rigidity, int apart, const Posed& posed, const VectorXd& dx) {
  const std::vector<Spring> all = springs_in(rigidity, apart, posed);
  double most = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].length > 0)
      most = std::max(most, all[i].k * (1 + all[i].rest / all[i].length) *
                                vector_of(dx, static_cast<int>(i), apart).norm());
  return 128 * kUnit * most;
}

StrandForce Springs::exact() const {
  StrandForce all = *this;
  all.products.resize(1);
  return all;
}

Strand Springs::metres(Random& random, int count) const {
  return even_strand(random, count, 1.0 / apart);
}

namespace {

struct State {
  Range stretch, bend;
  const char* name;
};
constexpr Range kBend = {0.1, 2.2};
// Longer or shorter than at rest by any neighbour's rest length: another category tests which one counts.
constexpr State kLonger = {{2.5, 3.5}, {0.1, 0.6}, "stretched"},
                kShorter = {{0.05, 0.2}, kBend, "compressed"},
                kMixed = {{0.6, 1.5}, kBend, "stretched and compressed"};
constexpr State kStates[] = {kLonger,
                             kShorter,
                             kMixed,
                             {{0.01, 0.012}, kBend, "compressed to 1 %"},
                             {{1, 1}, {0.01, 0.2}, "bent a little"}};

Posed in_state(Random& random, const Strand& strand, const State& state) {
  return random_pose(random, strand, state.stretch, state.bend, state.name);
}

// Springs that skip a particle are at rest at both ends of a strand of `metres`: another category of H3 finds
// loops that end too soon.
Posed with_ends_at_rest(const Springs& springs, Posed posed) {
  if (springs.apart == 1) return posed;
  const int last = posed.strand.count() - 1;
  for (auto [end, inner, step] : {std::array{0, 2, 1}, {last, last - 2, -1}}) {
    const Vector3d from = posed.x.segment<3>(3 * inner),
                   way = (posed.x.segment<3>(3 * end) - from).normalized();
    posed.x.segment<3>(3 * end) = from + way;
    posed.x.segment<3>(3 * (end + step)) = from + way / 2;
  }
  return posed;
}

// Makes a change that keeps both lengths.
VectorXd change_of(Random& random, const Springs& springs, const Posed& posed) {
  VectorXd dx = random_vector(random, posed.x.size());
  if (springs.apart == 1) return dx;
  dx.head<3>() = dx.segment<3>(6);
  dx.tail<3>() = dx.segment<3>(dx.size() - 9);
  return dx;
}

// Makes all states, and a straight one at rest, whose lengths are right to the last bit.
std::vector<Posed> states(Random& random, const Springs& springs, std::initializer_list<int> counts) {
  std::vector<Posed> all;
  for (const int count : counts)
    for (const State& state : kStates)
      all.push_back(with_ends_at_rest(springs, in_state(random, springs.metres(random, count), state)));
  const Strand strand = springs.metres(random, 6);
  all.push_back(straight_pose(strand, strand.rest_length, Vector3d::UnitY(), "at rest"));
  return all;
}

// Returns the fewest particles with which the cases above know the ends.
int fewest(const Springs& springs) {
  return springs.apart == 1 ? 2 : 5;
}

}  // namespace

void energies_of_springs(Trial& trial, const Springs& springs) {
  const int few = fewest(springs);
  for (const Posed& posed : states(trial.random, springs, {few, few + 1, 8, 40}))
    expect_energy(trial, springs, posed);
}

void forces_of_springs(Trial& trial, const Springs& springs) {
  const int few = fewest(springs);
  for (const Posed& posed : states(trial.random, springs, {few, few, few + 1, 7, 40}))
    expect_force(trial, springs, posed);
}

void exact_products_of_springs(Trial& trial, const Springs& springs) {
  const int few = fewest(springs);
  for (const Posed& posed : states(trial.random, springs, {few, few + 1, 20}))
    expect_product(trial, springs, springs.products[0], posed, change_of(trial.random, springs, posed));
}

namespace {

void expect_same(Trial& trial, const Springs& springs, const Posed& posed, GeometricTerm term,
                 const VectorXd& dx, const VectorXd& expected, const std::string& what) {
  expect_vector(trial, springs.product(trial, posed, dx, term), expected,
                2 * springs.product_rounding(posed, dx), what);
}

// Compares with the student's own exact product, which another category tests: springs that are all longer
// than at rest have the exact one; for shorter ones the term is missing.
void expect_filtered(Trial& trial, const Springs& springs, const Posed& longer, const Posed& shorter,
                     const VectorXd& dx) {
  const VectorXd full = springs.product(trial, longer, dx);
  expect_not_zero(trial, full, "the product");
  expect_same(trial, springs, longer, GeometricTerm::filtered, dx, full,
              "the filtered product of what is stretched");
  expect_same(trial, springs, shorter, GeometricTerm::filtered, dx,
              springs.product(trial, shorter, dx, GeometricTerm::dropped),
              "the filtered product of what is compressed");
}

// On a line no spring turns if all particles move along it: the geometric term alone adds a force.
void expect_along_a_line(Trial& trial, const Springs& springs, const Posed& line, const Vector3d& direction,
                         const VectorXd& dx) {
  VectorXd along(dx.size());
  for (int i = 0; i < line.strand.count(); ++i)
    along.segment<3>(3 * i) = direction * direction.dot(dx.segment<3>(3 * i));
  const VectorXd full = springs.product(trial, line, along, GeometricTerm::full);
  for (GeometricTerm term : {GeometricTerm::filtered, GeometricTerm::dropped})
    expect_same(trial, springs, line, term, along, full, "the product along a line");
  expect_same(trial, springs, line, GeometricTerm::dropped, dx - along, VectorXd::Zero(dx.size()),
              "the product across a line, without the geometric term");
}

// In a bent strand each spring has its own direction u: if one end moves, the force on the other end is along
// u.
void expect_own_directions(Trial& trial, const Springs& springs, const Posed& bent) {
  for (int i = 0; i + springs.apart < bent.strand.count(); ++i) {
    VectorXd dx = VectorXd::Zero(bent.x.size());
    dx.segment<3>(3 * i) = random_vector(trial.random, 3);
    const auto at_the_other = [&](GeometricTerm term) -> VectorXd {
      return springs.product(trial, bent, dx, term).segment<3>(3 * (i + springs.apart));
    };
    const Vector3d u = vector_of(bent.x, i, springs.apart).normalized();
    const double along = u.dot(Vector3d(at_the_other(GeometricTerm::full)));
    expect_vector(trial, at_the_other(GeometricTerm::dropped), u * along,
                  2 * springs.product_rounding(bent, dx),
                  "the product of a bent strand, without the geometric term");
  }
}

// One of two springs is longer than at rest, and the other shorter: each has its own term. `moved` is an
// end of one spring alone.
void expect_own_term(Trial& trial, const Springs& springs, const Posed& two, int moved, bool longer) {
  VectorXd dx = VectorXd::Zero(two.x.size());
  dx.segment<3>(3 * moved) = random_vector(trial.random, 3);
  const GeometricTerm same = longer ? GeometricTerm::full : GeometricTerm::dropped;
  expect_same(trial, springs, two, GeometricTerm::filtered, dx, springs.product(trial, two, dx, same),
              "the filtered product of a strand with a stretched and a compressed spring");
}

}  // namespace

void filtered_products_of_springs(Trial& trial, const Springs& springs) {
  Random& random = trial.random;
  for (int count : {2 * springs.apart, 3 * springs.apart, 15}) {
    const auto strand = [&] { return checks::ordinary_strand(random, count); };
    const Posed longer = in_state(random, strand(), kLonger), shorter = in_state(random, strand(), kShorter);
    const VectorXd dx = random_vector(random, 3 * count);
    expect_filtered(trial, springs, longer, shorter, dx);
    const Vector3d direction = checks::ordinary_direction(random);
    const VectorXd lengths = checks::ordinary_numbers(random, count - 1, 0.3, 2.3);
    expect_along_a_line(trial, springs, straight_pose(strand(), lengths, direction, "on a line"), direction,
                        dx);
  }
  expect_own_directions(trial, springs, in_state(random, checks::ordinary_strand(random, 7), kMixed));
  for (int stretched : {0, 1}) {
    Posed two{springs.metres(random, 2 + springs.apart), random_vector(random, 6 + 3 * springs.apart),
              "one of both"};
    for (int i : {0, 1})
      two.x.segment<3>(3 * (i + springs.apart)) =
          two.x.segment<3>(3 * i) + (i == stretched ? 1.6 : 0.6) * checks::ordinary_direction(random);
    // Takes the end that the other spring lacks.
    for (int spring : {0, 1})
      expect_own_term(trial, springs, two, spring * (1 + springs.apart), spring == stretched);
  }
}

void rest_lengths_of_springs(Trial& trial, const Springs& springs) {
  Random& random = trial.random;
  // Compares springs of the same strain but other rest lengths: the force is equal, the energy grows as l0,
  // and products as 1/l0.
  Strand strand = checks::ordinary_strand(random, 1 + springs.apart);
  const double strain = random.uniform(0.1, 0.4), whole = checks::ordinary_number(random, 0.3, 2.3);
  const Vector3d direction = checks::ordinary_direction(random);
  const VectorXd dx = random_vector(random, 3 * strand.count());
  std::vector<double> energies, forces, products;
  for (const double part : {1.0, 0.41, 0.13, 3.1}) {
    strand.rest_length = checks::ordinary_numbers(random, springs.apart, 0.3, 2.3);
    strand.rest_length *= part * whole / strand.rest_length.sum();
    const Posed posed = straight_pose(strand, (1 + strain) * strand.rest_length, direction, "one spring");
    energies.push_back(springs.energy(trial, posed) / part);
    forces.push_back(springs.force(trial, posed).norm());
    products.push_back(springs.product(trial, posed, dx).norm() * part);
  }
  // So it is for each of several equal springs; if one alone has no energy, another category reports it.
  for (const int several : {2, 5}) {
    Strand equal = springs.metres(random, several + springs.apart);
    equal.*springs.rigidity = strand.*springs.rigidity;
    const Posed posed = straight_pose(equal, (1 + strain) * equal.rest_length, direction, "equal springs");
    const double energy = springs.energy(trial, posed) / several * whole;
    if (energies.front() != 0) energies.push_back(energy);
  }
  // strain has an error of about 4 u of a length, or relatively 4 u / strain. Multiplied out, either energy
  // is off by another 4 u k (l + l0)^2, relative to k (l - l0)^2 / 2.
  const double multiplied_out = 16 * kUnit * std::pow((2 + strain) / strain, 2);
  expect_all_equal(trial, energies, 128 * kUnit / strain + multiplied_out,
                   "how a spring's energy over its rest length changes with that length");
  expect_all_equal(trial, forces, 128 * kUnit / strain,
                   "how the force at a strain changes with a spring's rest length");
  expect_all_equal(trial, products, 256 * kUnit / strain,
                   "how the product times a spring's rest length changes with that length");
  const Posed uneven = in_state(random, checks::ordinary_strand(random, 6), kLonger);
  const VectorXd change = random_vector(random, uneven.x.size());
  expect_size(trial, springs.energy(trial, uneven), springs.reference_energy(uneven), "the energy");
  expect_size(trial, springs.force(trial, uneven).norm(), springs.reference_force(uneven).norm(),
              "the force");
  expect_size(trial, springs.product(trial, uneven, change).norm(),
              springs.products[0].reference(uneven, change).norm(), "the product");
  expect_own_rest_lengths(trial, springs.exact(), uneven, 1 + springs.apart);
}

void added_by_springs(Trial& trial, const Springs& springs) {
  const Posed posed = in_state(trial.random, checks::ordinary_strand(trial.random, 9), kMixed);
  expect_added(trial, springs.exact(), posed, 8);
}

void springs_in_other_units(Trial& trial, const Springs& springs) {
  const Strand strand = checks::ordinary_strand(trial.random, 7);
  const Posed one = in_state(trial.random, strand, kMixed), other = in_state(trial.random, strand, kLonger);
  expect_same_in_other_units(trial, springs.exact(), one, other, {0x1p-80, 0x1p-35, 0x1p40});
}

void springs_without_direction(Trial& trial, const Springs& springs) {
  Random& random = trial.random;
  const auto expect_nothing = [&](const Posed& posed) {
    const VectorXd dx = random_vector(random, posed.x.size());
    trial.expect(springs.force(trial, posed).isZero(0), posed.name + " has a force");
    for (const StrandForce::Product& product : springs.products)
      trial.expect(product.ask_from_zero(trial, posed, dx).isZero(0), posed.name + " has a product");
  };
  for (int count = 1; count <= springs.apart; ++count) {
    const Posed posed{springs.metres(random, count), random_vector(random, 3 * count),
                      "a strand too short for a spring"};
    trial.expect(springs.energy(trial, posed) == 0, posed.name + " has an energy");
    expect_nothing(posed);
  }
  expect_nothing({springs.metres(random, 6), random_vector(random, 3).replicate(6, 1),
                  "a strand with all particles in one place"});

  // One of two springs loses its length, since its outer end moves, and the other one must behave as before.
  const auto outer = [&](int spring) { return 3 * spring * (1 + springs.apart); };
  const auto inner = [&](int spring) { return 3 * (spring == 0 ? springs.apart : 1); };
  bool acts = false;
  for (int which : {0, 1}) {
    const Posed before = in_state(random, springs.metres(random, 2 + springs.apart), kMixed);
    Posed posed = before;
    posed.name = "two springs, one without a length";
    posed.x.segment<3>(outer(which)) = before.x.segment<3>(inner(which));
    // The energy is that of a spring with almost no length: they differ by k l0 times that length, or a few
    // times that if the factor in front is wrong.
    constexpr double kHardly = 0x1p-30;
    Posed hardly = posed;
    hardly.x.segment<3>(outer(which)) += kHardly * checks::ordinary_direction(random);
    const double energy = springs.energy(trial, posed);
    trial.expect_at_most(std::abs(energy - springs.energy(trial, hardly)),
                         {4 * kHardly * posed.strand.*springs.rigidity, 2 * springs.energy_rounding(posed)},
                         "the error of the energy of two springs, one without a length,");
    const VectorXd dx = random_vector(random, posed.x.size());
    const int end = outer(1 - which), other_end = inner(1 - which);
    const auto expect = [&](const std::string& what, double rounding, const auto& answer) {
      const VectorXd with_both = answer(before);
      // If the last spring is missing or has one end, another category reports it.
      VectorXd expected = VectorXd::Zero(posed.x.size());
      expected.segment<3>(end) = with_both.segment<3>(end);
      expected.segment<3>(other_end) = -with_both.segment<3>(end);
      Vector3d sum = with_both.segment<3>(end) + with_both.segment<3>(other_end);
      if (springs.apart == 1) sum += with_both.segment<3>(outer(which));
      acts |= largest(expected) > 0;
      if (largest(expected) == 0 || largest(sum) > 4 * rounding) return;
      expect_vector(trial, answer(posed), expected, 2 * rounding,
                    what + " two springs, one without a length,");
    };
    expect("the force of", springs.force_rounding(before),
           [&](const Posed& at) { return springs.force(trial, at); });
    for (const StrandForce::Product& product : springs.products)
      expect("the product of", springs.product_rounding(before, dx),
             [&](const Posed& at) { return product.ask_from_zero(trial, at, dx); });
  }
  trial.expect(acts, "of two springs, one without a length, none has a force or a product");
}

}  // namespace grader::judge
