// STAFF ONLY. H3: hidden cases of bend_spring_energy, add_bend_spring_force and add_bend_spring_product. Bounds: springs.h.
#include <array>

#include "hair/bend_springs.h"
#include "reference/H3/springs.h"

namespace grader::h3 {
namespace {

using Eigen::Vector3d;

// At rest: its first and its last spring. Loops that end too soon lose another category's points.
Posed with_ends_at_rest(Posed posed) {
  const int last = posed.strand.count() - 1;
  for (auto [end, inner, step] : {std::array{0, 2, 1}, {last, last - 2, -1}}) {
    const Vector3d from = posed.x.segment<3>(3 * inner),
                   way = (posed.x.segment<3>(3 * end) - from).normalized();
    posed.x.segment<3>(3 * end) = from + way;
    posed.x.segment<3>(3 * (end + step)) = from + way / 2;
  }
  return posed;
}

// A change that leaves both as long as they are.
VectorXd change_of(Random& random, const Posed& posed) {
  VectorXd dx = random_vector(random, posed.x.size());
  dx.head<3>() = dx.segment<3>(6);
  dx.tail<3>() = dx.segment<3>(dx.size() - 9);
  return dx;
}

// Springs in compression, in tension, and both.
std::vector<Posed> states(Random& random, int count) {
  return {with_ends_at_rest(random_pose(random, half_metres(random, count), kStretch, kBend, "bent")),
          with_ends_at_rest(random_pose(random, half_metres(random, count), kLong, {0.1, 0.6}, "stretched")),
          with_ends_at_rest(
              random_pose(random, half_metres(random, count), {1, 1}, {0.01, 0.2}, "bent a little"))};
}

}  // namespace

void energy(Trial& trial) {
  for (int count : {5, 6, 12, 40})
    for (const Posed& posed : states(trial.random, count)) Bend::expect_energy(trial, posed);
}

void forces(Trial& trial) {
  for (int count : {5, 5, 6, 7, 20})
    for (const Posed& posed : states(trial.random, count)) Bend::expect_force(trial, posed);
}

void exact_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {5, 6, 15})
    for (const Posed& posed : states(random, count))
      Bend::expect_product(trial, posed, change_of(random, posed));
}

// Beside the student's own exact product, which is another category's.
void filtered_product(Trial& trial) {
  Random& random = trial.random;
  for (int count : {4, 6, 15}) {
    const Posed longer = random_pose(random, half_metres(random, count), kLong, {0.1, 0.6}, "stretched"),
                shorter = random_pose(random, half_metres(random, count), {0.3, 0.9}, kBend, "compressed");
    const VectorXd dx = random_vector(random, 3 * count);
    expect_filtered(trial, Bend::kProduct, longer, shorter, dx);
    const Vector3d direction = random_direction(random);
    VectorXd lengths(count - 1);
    for (double& one : lengths) one = random.uniform(0.3, 0.8);
    expect_along_a_line(trial, Bend::kProduct,
                        straight_pose(half_metres(random, count), lengths, direction, "on a line"), direction,
                        dx);
  }
  expect_own_directions(trial, Bend::kProduct,
                        random_pose(random, half_metres(random, 7), kStretch, kBend, "bent"), 2);
  for (int stretched : {0, 1}) {
    Posed two{half_metres(random, 4), random_vector(random, 12), "one of both"};
    for (int i : {0, 1})
      two.x.segment<3>(3 * i + 6) =
          two.x.segment<3>(3 * i) + (i == stretched ? 1.6 : 0.6) * random_direction(random);
    for (int spring : {0, 1}) expect_own_term(trial, Bend::kProduct, two, spring, spring == stretched);
  }
}

// Properties of the student's own answers: a mistake elsewhere does not count again.
void lengths(Trial& trial) {
  Random& random = trial.random;
  const Posed large = random_pose(random, toy_strand(random, 6), {1.2, 1.6}, {0.2, 1}, "rest lengths of 1 m");
  const VectorXd dx = random_vector(random, large.x.size());
  const double E = Bend::ask_energy(trial, large);
  const VectorXd f = Bend::ask_force(trial, large), df = Bend::ask_product(trial, large, dx);
  expect_size(trial, E, hair::bend_spring_energy(large.strand, large.x), "the energy");
  expect_size(trial, f.norm(), Bend::reference_force(large).norm(), "the force");
  expect_size(trial, df.norm(), Bend::reference_product(large, dx, GeometricTerm::full).norm(),
              "the product");
  // All lengths divided by r, the rigidity as it was: E falls like 1/r, f stays, products grow like r.
  for (double r : {8.0, 1024.0}) {  // powers of two: nothing rounds differently
    Posed small = large;
    small.strand.rest_length /= r;
    small.x /= r;
    small.name = "scaled";
    auto expect = [&](const VectorXd& actual, const VectorXd& expected, const std::string& what) {
      expect_vector(trial, actual, expected, 1e-12 * largest(expected), what);
    };
    expect(VectorXd::Constant(1, Bend::ask_energy(trial, small)), VectorXd::Constant(1, E / r),
           "a short strand's energy");
    expect(Bend::ask_force(trial, small), f, "a short strand's force");
    expect(Bend::ask_product(trial, small, dx), df * r, "a short strand's product");
  }
  // Two segments that differ count by their sum: what one is longer the other may be shorter.
  std::vector<double> energies;
  std::vector<VectorXd> ends;  // of force and product
  const VectorXd push = random_vector(random, 9);
  for (double l1 : {1.0, 0.3, 1.7}) {
    Posed posed = random_pose(random, toy_strand(random, 3), {1, 1}, {0.3, 0.3}, "uneven");
    posed.strand = toy_strand(random, 3);
    posed.strand.skip_rigidity = large.strand.skip_rigidity;
    posed.strand.rest_length << l1, 2 - l1;
    posed.x.tail<3>() = posed.x.head<3>() + 2.5 * Vector3d::UnitX();
    energies.push_back(Bend::ask_energy(trial, posed));
    VectorXd end(6);
    end << Bend::ask_force(trial, posed).tail<3>(), Bend::ask_product(trial, posed, push).tail<3>();
    ends.push_back(end);
    expect_vector(trial, end, ends[0],
                  2 * (Bend::force_rounding(posed) + Bend::product_rounding(posed, push)),
                  "the force and the product of a spring whose rest length is divided differently");
  }
  expect_all_equal(trial, energies, 4096 * kUnit,
                   "how a spring's energy changes with how its rest length is divided");
  expect_own_rest_lengths(
      trial, Bend::strand_force(),
      random_pose(random, toy_strand(random, 6), {1.2, 1.5}, kBend, "uneven rest lengths"), 3, "springs");
  const Strand strand = half_metres(random, 7);
  const Posed one = random_pose(random, strand, kStretch, kBend, "a strand"),
              other = random_pose(random, strand, kLong, kBend, "another");
  expect_same_in_other_units(trial, Bend::strand_force(), one, other, {0x1p-80, 0x1p-35, 0x1p40});
}

void added(Trial& trial) {
  expect_added(
      trial, Bend::strand_force(),
      random_pose(trial.random, half_metres(trial.random, 9), kStretch, {0.2, 2}, "added to what is there"),
      8);
}

}  // namespace grader::h3
