// STAFF ONLY. H6: hidden cases of predictor_corrector, which is linked with our S1, H4 and H5.
//
// Each of the five steps is checked where the others do nothing, or from the student's own state before it.
// Solves leave an error: dv is off by at most d = (tolerance ||rhs|| + rounding) / lambda_min
// (implicit_system.h), x by h d. The correction, whose matrix has a condition number of about n^2, multiplies
// that by at most 1000, for strands of up to 12 particles. A missing or wrong step changes v by metres a
// second.
#include <algorithm>
#include <cmath>

#include "grader/judge/cases/case_asker.h"
#include "grader/judge/cases/implicit_system.h"
#include "grader/judge/cases/random.h"
#include "grader/judge/cases/trial.h"
#include "hair/predictor_corrector.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "particles/springs.h"
#include "reference/H6/calls.h"

namespace grader::h6 {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kTolerance = particles::kSolveTolerance, kGrowth = 1000;

struct Hair {
  hair::Strand strand;
  Cloud cloud;
  double h;
};

struct Step {
  VectorXd x, v;
  hair::StepReport report;
  ForceServer asked;

  // Returns the positions that step 5 sees; another category finds what moves them later.
  const VectorXd& corrected() const { return asked.forces_at.size() >= 2 ? asked.forces_at[1].x : x; }
};

Step step(Trial& trial, const Hair& hair, double tolerance = kTolerance) {
  const int n = hair.cloud.count(), most = std::max(100, 60 * n);
  trial.describe(hair.cloud.name);
  Step step{{}, {}, {}, ForceServer(*hair.cloud.force, n, 6 * (most + most / 64) + 40)};
  const auto [report, state] = answer_of<Calls, hair::predictor_corrector>(
      trial, std::ref(step.asked), hair.cloud.particles, hair.strand, hair.h, tolerance, hair.cloud.state,
      Filling{});
  step.report = report, step.x = state.x, step.v = state.v;
  trial.expect(step.x.allFinite() && step.v.allFinite(), "a step is not finite");
  return step;
}

// The solves' errors in velocities; in positions they are h times that.
double solve_error(const ImplicitSystem& system) {
  return kGrowth * (kTolerance * system.rhs.norm() + system.rounding) / system.smallest;
}

VectorXd corrected(const Hair& hair, VectorXd x) {
  MatrixXd scratch(x.size(), hair::kCorrectionScratch);
  hair::correct_lengths(hair.strand, hair::kLengthTolerance, hair::kMostCorrections, x, scratch);
  return x;
}

// The error of positions within the correction's tolerance.
double correction_error(const VectorXd& x) {
  return kGrowth * hair::kLengthTolerance * (0.01 * static_cast<double>(x.size()) / 3 + x.norm());
}

double largest_length_error(const hair::Strand& strand, const VectorXd& x) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const double l = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm();
    largest = std::max(largest, std::abs(l / strand.rest_length[i] - 1));
  }
  return largest;
}

// Takes the smaller error of the end and of the positions that step 5 sees: other categories tell them apart.
double least_length_error(const hair::Strand& strand, const Step& after) {
  return std::min(largest_length_error(strand, after.x), largest_length_error(strand, after.corrected()));
}

// A strand at its rest lengths, in motion under gravity: masses of 0.7 to 1.4 `mass`, segments of about 1 cm,
// springs with h^2 k/m = `stiff`.
Hair moving_hair(Random& random, int n, double mass, double stiff, double h, double gravity = 9.81) {
  Hair hair;
  hair.h = h;
  hair.cloud = chain(random, n, mass, 0, h);
  hair.cloud.name = "a strand of " + std::to_string(n) + ", h^2 k/m " + std::to_string(stiff);
  hair.strand.mass = hair.cloud.particles.mass;
  hair.strand.rest_length.resize(n - 1);
  VectorXd& x = hair.cloud.state.x;
  std::vector<particles::Spring> springs;
  for (int i = 0; i < n - 1; ++i) {
    const double length = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm();
    hair.strand.rest_length[i] = length;
    springs.push_back({i, i + 1, stiff * mass / (h * h), length});
  }
  hair.strand.stretch_rigidity = stiff * mass / (h * h) * 0.01;
  auto force = std::make_shared<particles::ForceSum>();
  force->emplace<particles::DampedSprings>(std::move(springs), particles::Products::definite);
  force->emplace<particles::Gravity>(hair.strand.mass, gravity * Vector3d(0, 0, -1));
  hair.cloud.force = force;
  return hair;
}

// Moves the root, too, as a head does. One category is about this; in the others the root rests.
void move_root(Random& random, Hair& hair) {
  hair.cloud.state.v.head<3>() = random_vector(random, 3, 0.1);
  hair.cloud.name += ", its root moves";
}

void expect_root_moved(Trial& trial, const Hair& hair, const Step& after) {
  const Vector3d v = hair.cloud.state.v.head<3>(), x = hair.cloud.state.x.head<3>() + hair.h * v;
  trial.expect_at_most((after.x.head<3>() - x).norm(), 4 * kUnit * (x.norm() + hair.h * v.norm()),
                       "how far the root is from where its velocity leads");
  // A student's velocity may be a difference of positions over h.
  trial.expect_at_most((after.v.head<3>() - v).norm(), 0x1p-50 * (x.norm() / hair.h + v.norm()),
                       "how much the root changes its velocity");
}

// A hair whose lengths are right after step 2, so that there is no correction and no impulse.
Hair right_after_step(Random& random, int n, double stiff) {
  Hair hair = moving_hair(random, n, 1e-6, stiff, 1.0 / random.integer(60, 240));
  hair.cloud.name += ", lengths right afterwards";
  const particles::State& state = hair.cloud.state;
  const VectorXd v = state.v + implicit_system(hair.cloud, hair.h / 2, hair.h).dv, x = state.x + hair.h * v;
  for (int i = 0; i < hair.strand.segments(); ++i)
    hair.strand.rest_length[i] = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm();
  return hair;
}

}  // namespace

void prediction(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 4, 12}) {
    const Hair hair = right_after_step(random, n, random.log_uniform(0.3, 30));
    const ImplicitSystem first = implicit_system(hair.cloud, hair.h / 2, hair.h);
    const VectorXd x = hair.cloud.state.x + hair.h * (hair.cloud.state.v + first.dv);
    const Step after = step(trial, hair);
    trial.expect_close({after.x, x, 3, hair.cloud.state.x}, hair.h * solve_error(first) + 1e-9 * x.norm(),
                       "the error of the positions, where no length has to be corrected");
    trial.expect(!after.asked.forces_at.empty() && after.asked.forces_at[0].x == hair.cloud.state.x,
                 "the first solve's force is not evaluated at the old positions");
  }
}

namespace {

// A hair without any force, so that both solves do nothing.
Hair force_free(Random& random, int n) {
  Hair hair = moving_hair(random, n, 1e-6, 0, 1.0 / random.integer(60, 240), 0);
  hair.cloud.name += ", no force";
  return hair;
}

}  // namespace

void lengths(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 2, 5, 12}) {
    Hair hair = force_free(random, n);
    move_root(random, hair);
    const VectorXd x = corrected(hair, hair.cloud.state.x + hair.h * hair.cloud.state.v);
    const Step after = step(trial, hair);
    const double bound = correction_error(x);
    const Compared numbers{after.x, x, 3, hair.cloud.state.x, bound};
    trial.expect_at_most(largest_length_error(hair.strand, after.x), 1e-10, "the error of a length", numbers);
    trial.expect_close(numbers, bound, "the error of the positions, where no force acts");
    expect_root_moved(trial, hair, after);
  }
  // With forces the lengths stay right over several steps.
  const double stiff = random.log_uniform(1, 1e3);
  Hair hair = moving_hair(random, 12, 1e-6, stiff, 1.0 / random.integer(60, 240));
  move_root(random, hair);
  for (int i = 0; i < 3; ++i) {
    const Step after = step(trial, hair);
    trial.expect_at_most(largest_length_error(hair.strand, after.x), 1e-10, "the error of a length");
    expect_root_moved(trial, hair, after);
    hair.cloud.state = {after.x, after.v};
  }
}

// Compares velocities with the impulse from the student's own positions. A wrong prediction does not show: a
// hair at rest stays where it is, and one that moves as a whole keeps its lengths.
void impulse(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 4, 12}) {
    Hair hair = force_free(random, n);
    hair.cloud.state.v.setZero();
    for (double& length : hair.strand.rest_length) length *= random.uniform(0.8, 0.95);
    const Step after = step(trial, hair);
    const VectorXd& start = hair.cloud.state.x;
    const VectorXd way = (after.x - start) / hair.h, of_corrected = (after.corrected() - start) / hair.h;
    const bool nearer = (after.v - of_corrected).norm() < (after.v - way).norm();
    trial.expect_close({after.v, nearer ? of_corrected : way, 3, hair.cloud.state.v},
                       0x1p-40 * (after.x.norm() / hair.h + after.v.norm()),
                       "the difference of the velocities from the way over h, where no force acts");
  }
  Hair whole = force_free(random, 4);
  whole.cloud.state.v = random_vector(random, 3, 0.1).replicate(4, 1);
  const VectorXd v = whole.cloud.state.v.tail(9);
  const Step after = step(trial, whole);
  trial.expect_close({after.v.tail(9), v}, 0x1p-40 * (after.x.norm() / whole.h + v.norm()),
                     "the error of the velocities of a hair that moves as a whole, which needs no impulse");
}

// Compares the second solve, from the student's own state before it, which the second evaluation of the force
// gets.
void second_solve(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 4, 12}) {
    const double stiff = random.log_uniform(0.5, 2);
    const Hair hair = moving_hair(random, n, 1e-6, stiff, 1.0 / random.integer(60, 240));
    const Step after = step(trial, hair);
    trial.require(after.asked.forces_at.size() >= 2, "there is no second solve");
    const VectorXd& seen = after.corrected();
    trial.expect(
        seen == after.x || (seen != hair.cloud.state.x && largest_length_error(hair.strand, seen) <= 1e-10),
        "the second solve's force is not evaluated at the corrected positions");
    Cloud before = hair.cloud;
    before.state = after.asked.forces_at[1];
    const ImplicitSystem second = implicit_system(before, hair.h / 2, hair.h);
    trial.expect_close({after.v - before.state.v, second.dv}, solve_error(second),
                       "the error of the velocities that the second solve adds");
  }
}

void cost(Trial& trial) {
  Random& random = trial.random;
  for (int n : {4, 16, 64}) {
    const Hair hair = moving_hair(random, n, 1e-6, 2, 1.0 / random.integer(60, 240));
    const Step after = step(trial, hair);
    trial.expect(after.asked.forces == 2, "a step does not take two evaluations of the force",
                 std::to_string(after.asked.forces));
    const auto products = [](const particles::SolveReport& report) {
      return 1 + report.steps + report.steps / 64;
    };
    const int solves = products(after.report.filter) + products(after.report.second_filter);
    trial.expect(after.asked.dfdv == solves && after.asked.dfdx == solves + 2,
                 "a step takes other products with df/dx and df/dv than its two solves' reports say",
                 std::to_string(after.asked.dfdx) + " and " + std::to_string(after.asked.dfdv) +
                     ", reported " + std::to_string(solves));
    if (after.asked.products_before.size() >= 2)
      trial.expect(after.asked.products_before[1] == products(after.report.filter),
                   "the first report is not that of the first solve",
                   std::to_string(after.asked.products_before[1]) + " products");
    trial.expect(after.report.filter.converged && after.report.second_filter.converged &&
                     after.report.correction.converged && after.report.correction.error <= 1e-11,
                 "a step's report says that it has not converged");
  }
  // The band of a chain's springs is their whole matrix, and the preconditioner its inverse: a product or two
  // solve the system.
  Hair hair = moving_hair(random, 16, 1e-6, 30, 1.0 / random.integer(60, 240));
  hair.cloud.force = std::make_shared<Banded>(hair.cloud.force);
  hair.cloud.name += ", with a band";
  const Step after = step(trial, hair);
  for (const particles::SolveReport& solve : {after.report.filter, after.report.second_filter})
    trial.expect(solve.preconditioned && solve.converged && solve.steps <= 2 * particles::kMostSolves,
                 "a solve with a preconditioner takes more than a few iterations",
                 std::to_string(solve.steps));
}

// The correction has its own tolerance and limit, the solves have the caller's, and the impulse follows even
// if the correction did not converge.
void other_limits(Trial& trial) {
  Random& random = trial.random;
  const double stiff = random.log_uniform(100, 300);
  const Hair ordinary = moving_hair(random, 12, 1e-6, stiff, 1.0 / random.integer(60, 240));
  const Step exact = step(trial, ordinary), rough = step(trial, ordinary, 1e-2);
  trial.expect_at_most(least_length_error(ordinary.strand, rough), 1e-10,
                       "the error of a length after solves with a tolerance of 0.01");
  trial.expect(
      rough.report.filter.steps < exact.report.filter.steps,
      "solves with a tolerance of 0.01 take as many steps as exact ones",
      std::to_string(rough.report.filter.steps) + " and " + std::to_string(exact.report.filter.steps));

  // A hair that is flung about takes our correction 20 to 100 iterations. With its root far away nothing
  // converges (H5's contract). Without a force v is the way over h.
  for (const bool is_hopeless : {false, true}) {
    Hair flung = moving_hair(random, 12, 1e-6, 0, 1.0 / random.integer(60, 240), 0);
    flung.strand.mass.setConstant(1e-6);
    flung.cloud.particles.mass = flung.strand.mass;
    VectorXd& v = flung.cloud.state.v;
    for (int i = 1; i < 12; ++i) v.segment<3>(3 * i) = random_vector(random, 3, 0.2) / flung.h;
    if (is_hopeless) v.head<3>() = Vector3d(1e12, 0, 0) / flung.h;
    flung.cloud.name = is_hopeless ? "a root that is flung away" : "a strand that is flung about";
    const Step after = step(trial, flung);
    if (!is_hopeless)
      trial.expect_at_most(least_length_error(flung.strand, after), 1e-10,
                           "the error of a length of a strand that is flung about");
    trial.expect(after.report.correction.converged != is_hopeless,
                 "the report of a correction is not what correct_lengths said");
    const VectorXd way = (after.x - flung.cloud.state.x) / flung.h;
    trial.expect((after.v - v).tail(33).norm() >= 0.1 * (way - v).tail(33).norm(),
                 "a correction that is hard leaves the velocities as they are");
  }
}

// Powers of two change no rounding, but each run may end anywhere within the tolerances of its solves and its
// correction: here the force in other units hides its band, and is solved without a preconditioner. In each
// run x is off by h times the error of the first solve and by the correction's. After step 4 v is (x~ - x) /
// h, and step 5 adds the error of the second solve.
void units(Trial& trial) {
  Random& random = trial.random;
  const Hair known = moving_hair(random, 6, 1e-6, 10, 1.0 / random.integer(60, 240));
  const particles::State& start = known.cloud.state;
  const ImplicitSystem first = implicit_system(known.cloud, known.h / 2, known.h);
  Cloud between = known.cloud;
  between.state.x = corrected(known, start.x + known.h * (start.v + first.dv));
  between.state.v = (between.state.x - start.x) / known.h;
  const ImplicitSystem second = implicit_system(between, known.h / 2, known.h);
  const double of_x = known.h * solve_error(first) + correction_error(between.state.x);
  const double of_v = of_x / known.h + solve_error(second);

  const Step before = step(trial, known);
  for (const double length : {0x1p-40, 0x1p10}) {
    Hair other = known;
    other.cloud = in_other_units(known.cloud, 1, length);
    other.strand.rest_length *= length;
    const Step after = step(trial, other);
    trial.expect_close({after.x / length, before.x}, 2 * of_x,
                       "how much positions change in another unit of length");
    trial.expect_close({after.v / length, before.v}, 2 * of_v,
                       "how much velocities change in another unit of length");
  }
}

}  // namespace grader::h6
