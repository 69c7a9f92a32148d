// STAFF ONLY. H6: hidden cases of predictor_corrector, which has our S1, H4 and H5 beside it.
//
// Values are compared with the five steps as the suite takes them. They differ by what the solves leave: dv is off by
// at most d = (tolerance ||rhs|| + rounding) / lambda_min in either (implicit_system.h), x by h d. The correction, whose
// matrix has a condition number of about n^2, and the impulse, x_corr / h, then make more of that: no more than 1000
// times, for strands of up to 12 particles. A step that is left out or wrong changes v by metres a second.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "grader/exercise/H6/calls.h"
#include "grader/suite/case_asker.h"
#include "grader/suite/implicit_system.h"
#include "grader/suite/trial.h"
#include "grader/suite/whole_run_points.h"
#include "hair/predictor_corrector.h"
#include "particles/force_sum.h"
#include "particles/gravity.h"
#include "particles/springs.h"

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
};

Step step(Trial& trial, const Hair& hair, double tolerance = kTolerance) {
  const int n = hair.cloud.count(), most = std::max(100, 60 * n);
  trial.describe(hair.cloud.name);
  Step step{{}, {}, {}, ForceServer(*hair.cloud.force, n, 6 * (most + most / 64) + 40)};
  particles::State state = hair.cloud.state;
  step.report = ask_student_for<Calls, hair::predictor_corrector>(
      trial, std::ref(step.asked), hair.cloud.particles, hair.strand, hair.h, tolerance, state,
      Filling{hair::kPredictorCorrectorScratch});
  step.x = state.x;
  step.v = state.v;
  trial.expect(step.x.allFinite() && step.v.allFinite(), "a step is not finite");
  return step;
}

// The five steps, and how far off their results may be.
struct Expected {
  VectorXd x, v;
  double x_error, v_error;
};

Expected expected_step(const Hair& hair) {
  Cloud cloud = hair.cloud;
  particles::State& state = cloud.state;
  const double h = hair.h;
  const ImplicitSystem first = implicit_system(cloud, h / 2, h);
  state.v += first.dv;
  state.x += h * state.v;
  const VectorXd predicted = state.x;
  MatrixXd scratch(state.x.size(), hair::kCorrectionScratch);
  hair::correct_lengths(hair.strand, hair::kLengthTolerance, hair::kMostCorrections, state.x, scratch);
  state.v += (state.x - predicted) / h;
  const ImplicitSystem second = implicit_system(cloud, h / 2, h);
  state.v += second.dv;

  const auto error = [](const ImplicitSystem& system) {
    return (kTolerance * system.rhs.norm() + system.rounding) / system.smallest;
  };
  // What the correction leaves of its errors is of the same kind: 1e-12 of each segment.
  const double lengths = 1e-12 * hair.strand.rest_length.norm();
  return {state.x, state.v, kGrowth * (h * error(first) + lengths),
          kGrowth * (error(first) + error(second) + lengths / h)};
}

double largest_length_error(const hair::Strand& strand, const VectorXd& x) {
  double largest = 0;
  for (int i = 0; i < strand.segments(); ++i) {
    const double l = (x.segment<3>(3 * i + 3) - x.segment<3>(3 * i)).norm();
    largest = std::max(largest, std::abs(l / strand.rest_length[i] - 1));
  }
  return largest;
}

// A strand at its rest lengths, in motion under gravity: masses of 0.7 to 1.4 `mass`, segments of about 1 cm, springs
// with h^2 k/m = `stiff`.
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
  // The root moves too, as a head does.
  hair.cloud.state.v.head<3>() = random_vector(random, 3, 0.1);
  return hair;
}

void lengths(Trial& trial) {
  Random& random = trial.random;
  for (int n : {1, 2, 5, 12}) {
    Hair hair = moving_hair(random, n, 1e-6, random.log_uniform(1, 1e3), 1.0 / random.integer(60, 240));
    for (int i = 0; i < 3; ++i) {
      const Step after = step(trial, hair);
      trial.expect_at_most(largest_length_error(hair.strand, after.x), 1e-10, "the error of a length");
      const Vector3d v = hair.cloud.state.v.head<3>(), x = hair.cloud.state.x.head<3>() + hair.h * v;
      // A velocity may come out of a difference of positions over h.
      trial.expect_at_most((after.v.head<3>() - v).norm(), 0x1p-50 * (x.norm() / hair.h + v.norm()),
                           "how much the root changes its velocity");
      trial.expect_at_most((after.x.head<3>() - x).norm(), 0x1p-50 * (x.norm() + hair.h * v.norm()),
                           "the error of the root's position");
      hair.cloud.state = {after.x, after.v};
    }
  }
}

void positions(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 4, 12}) {
    const Hair hair =
        moving_hair(random, n, 1e-6, random.log_uniform(0.3, 30), 1.0 / random.integer(60, 240));
    const Expected expected = expected_step(hair);
    trial.expect_at_most((step(trial, hair).x - expected.x).norm(), expected.x_error,
                         "the error of the positions");
  }
}

// Without any force both solves do nothing, and what is left is the correction and its impulse.
void impulse(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 4, 12}) {
    Hair hair = moving_hair(random, n, 1e-6, 0, 1.0 / random.integer(60, 240), 0);
    hair.cloud.name += ", no force";
    const Expected expected = expected_step(hair);
    trial.expect_at_most((step(trial, hair).v - expected.v).norm(), expected.v_error,
                         "the error of the velocities, where no force acts");
  }
}

void a_step(Trial& trial) {
  Random& random = trial.random;
  for (int n : {2, 4, 12}) {
    const Hair hair = moving_hair(random, n, 1e-6, random.log_uniform(0.5, 2), 1.0 / random.integer(60, 240));
    const Expected expected = expected_step(hair);
    trial.expect_at_most((step(trial, hair).v - expected.v).norm(), expected.v_error,
                         "the error of the velocities, for h^2 k/m near 1");
  }
}

void evaluated_at(Trial& trial) {
  Random& random = trial.random;
  for (int n : {3, 8}) {
    const Hair hair =
        moving_hair(random, n, 1e-6, random.log_uniform(0.3, 30), 1.0 / random.integer(60, 240));
    const Step after = step(trial, hair);
    trial.require(after.asked.forces == 2, "a step does not take two evaluations of the force",
                  std::to_string(after.asked.forces));
    trial.expect(to_vector(after.asked.forces_at[0]) == hair.cloud.state.x,
                 "the first solve's force is not evaluated at the old positions");
    trial.expect(to_vector(after.asked.forces_at[1]) == after.x,
                 "the second solve's force is not evaluated at the corrected positions");
  }
}

void cost(Trial& trial) {
  Random& random = trial.random;
  for (int n : {4, 16, 64}) {
    const Hair hair = moving_hair(random, n, 1e-6, 2, 1.0 / random.integer(60, 240));
    const Step after = step(trial, hair);
    const auto products = [](const particles::SolveReport& report) {
      return 1 + report.steps + report.steps / 64;
    };
    const int solves = products(after.report.filter) + products(after.report.second_filter);
    trial.expect(after.asked.dfdv == solves && after.asked.dfdx == solves + 2,
                 "a step takes other products with df/dx and df/dv than its two solves' reports say",
                 std::to_string(after.asked.dfdx) + " and " + std::to_string(after.asked.dfdv) +
                     ", reported " + std::to_string(solves));
    // As in h4_categories.cpp, with half of the stiffness: at most 35 steps, a third more for rounding.
    const int most = std::max(after.report.filter.steps, after.report.second_filter.steps);
    trial.expect_at_most(most, 60, "the number of steps of a solve for a strand that is not stiff");
    trial.expect(after.report.filter.converged && after.report.second_filter.converged &&
                     after.report.correction.converged && after.report.correction.error <= 1e-11,
                 "a step's report says that it has not converged");
  }
}

// The numbers of the assignment's table.
void revolution(Trial& trial) {
  const double length = trial.random.uniform(0.1, 0.5), mass = trial.random.log_uniform(1e-6, 1),
               turn = 2 * std::numbers::pi, h = 1.0 / 60;
  Hair hair;
  hair.h = h;
  hair.strand.mass = Eigen::Vector2d(mass, mass);
  hair.strand.rest_length = VectorXd::Constant(1, length);
  hair.strand.stretch_rigidity = 1e8 * mass * length;
  hair.cloud.name = "turning on a stiff spring";
  hair.cloud.particles = {hair.strand.mass, {1, 0}};
  hair.cloud.state = {VectorXd::Zero(6), VectorXd::Zero(6)};
  hair.cloud.state.x[3] = length;
  hair.cloud.state.v[4] = turn * length;
  hair.cloud.force = std::make_shared<particles::DampedSprings>(
      std::vector<particles::Spring>{{0, 1, 1e8 * mass, length}}, particles::Products::definite);
  for (int i = 0; i < 60; ++i) {
    const Step after = step(trial, hair);
    hair.cloud.state = {after.x, after.v};
    const Vector3d x = after.x.tail<3>(), v = after.v.tail<3>();
    trial.expect_at_most(std::abs(x.norm() / length - 1), 1e-12, "the error of the length");
    trial.expect_at_most(std::abs(x.dot(v)) / length, 2e-5 * length / 0.3,
                         "the velocity along a stiff spring");
  }
  const Vector3d x = hair.cloud.state.x.tail<3>(), v = hair.cloud.state.v.tail<3>();
  trial.expect_at_most(
      std::abs(x.cross(v)[2] / (length * length * turn) - 1 / std::sqrt(1 + turn * turn * h)), 1e-4,
      "the error of the angular momentum that is left after a revolution");
}

// Human hair, 30 segments in 30 cm: k/m = E / (density * l^2) = 2.3e10 / s^2.
void human_hair(Trial& trial) {
  Random& random = trial.random;
  const double h = 1.0 / random.integer(240, 960);
  Hair hair = moving_hair(random, 31, 1e-7, 2.3e10 * h * h, h);
  for (int i = 0; i < 3; ++i) {
    const Step after = step(trial, hair);
    trial.expect_at_most(largest_length_error(hair.strand, after.x), 1e-10, "the error of a length");
    double along = 0;
    for (int j = 0; j < hair.strand.segments(); ++j) {
      const Vector3d u = (after.x.segment<3>(3 * j + 3) - after.x.segment<3>(3 * j)).normalized();
      along = std::max(along, std::abs(u.dot(after.v.segment<3>(3 * j + 3) - after.v.segment<3>(3 * j))));
    }
    trial.expect_at_most(along, 1e-4, "the velocity that stretches a segment");
    hair.cloud.state = {after.x, after.v};
  }
}

// The correction has its own tolerance and limit, the solves have the caller's, and the impulse follows however the correction ended.
void other_limits(Trial& trial) {
  Random& random = trial.random;
  const Hair ordinary =
      moving_hair(random, 12, 1e-6, random.log_uniform(100, 300), 1.0 / random.integer(60, 240));
  const Step exact = step(trial, ordinary), rough = step(trial, ordinary, 1e-2);
  trial.expect_at_most(largest_length_error(ordinary.strand, rough.x), 1e-10,
                       "the error of a length after solves with a tolerance of 0.01");
  trial.expect(
      rough.report.filter.steps < exact.report.filter.steps,
      "solves with a tolerance of 0.01 take as many steps as exact ones",
      std::to_string(rough.report.filter.steps) + " and " + std::to_string(exact.report.filter.steps));

  // Flung about, it takes our correction 20 to 100 iterations. With its root far away nothing is converged (H5's contract). No
  // force acts: v is the way over h.
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
      trial.expect_at_most(largest_length_error(flung.strand, after.x), 1e-10,
                           "the error of a length of a strand that is flung about");
    trial.expect(after.report.correction.converged != is_hopeless,
                 "the report of a correction is not what correct_lengths said");
    const double rounding = 0x1p-48 * (after.x.norm() / flung.h + v.norm());
    trial.expect_at_most((after.v - (after.x - flung.cloud.state.x) / flung.h).norm(), rounding,
                         "the error of the impulse after a correction that is hard");
  }
}

}  // namespace

WholeRunPoints whole_run() {
  return {2, 4};
}

std::vector<Category> categories() {
  return {{"Lengths", "Lengths and the root", 3, lengths},
          {"Positions", "Positions", 4, positions},
          {"Impulse", "The impulse", 3, impulse},
          {"Step", "A whole step", 3, a_step},
          {"EvaluatedAt", "Where forces are evaluated", 2, evaluated_at},
          {"Cost", "Products and reports", 2, cost},
          {"OtherLimits", "Hard corrections and other tolerances", 1, other_limits},
          {"Revolution", "A revolution", 1, revolution},
          {"HumanHair", "A human hair", 1, human_hair}};
}

}  // namespace grader::h6
