// STAFF ONLY. X1: hidden cases of add_air_drag.
//
// Rounding. A particle's relative velocity comes out of one subtraction, with an error of u = 2^-53 of each entry; its length, the
// products and the sum go through less than 8 more operations in either program, hence 32 u of c |w - v|^2, in N.
#include "grader/exercise/X1/calls.h"
#include "grader/suite/case_asker.h"
#include "grader/suite/random_vector.h"
#include "grader/suite/rounding.h"
#include "grader/suite/strand_trial.h"

namespace grader::x1 {
namespace {

struct Flight {
  double coefficient;
  VectorXd wind, v;

  double bound() const { return 32 * kUnit * coefficient * (wind - v).squaredNorm(); }
  VectorXd drag() const {
    VectorXd f = VectorXd::Zero(v.size());
    particles::add_air_drag(coefficient, wind, v, f);
    return f;
  }
};

Flight random_flight(Random& random, int particles, double wind) {
  const double speed = random.log_uniform(0.1, 100);
  return {random.log_uniform(1e-6, 10), wind * speed * random_vector(random, 3 * particles),
          speed * random_vector(random, 3 * particles)};
}

VectorXd ask(Trial& trial, const Flight& flight, VectorXd f) {
  trial.describe(std::to_string(flight.v.size() / 3) + " particles");
  ask_student_for<Calls, particles::add_air_drag>(trial, flight.coefficient, flight.wind, flight.v, f);
  return f;
}

void expect_drag(Trial& trial, const Flight& flight) {
  expect_vector(trial, ask(trial, flight, VectorXd::Zero(flight.v.size())), flight.drag(), flight.bound(),
                "the drag");
}

void at_rest(Trial& trial) {
  for (int particles : {1, 2, 3, 20})
    for (int repeat = 0; repeat < 3; ++repeat) expect_drag(trial, random_flight(trial.random, particles, 0));
}

void wind(Trial& trial) {
  for (int particles : {1, 2, 3, 20})
    for (int repeat = 0; repeat < 3; ++repeat) expect_drag(trial, random_flight(trial.random, particles, 1));
}

void added(Trial& trial) {
  for (int particles : {1, 6}) {
    const Flight flight = random_flight(trial.random, particles, 1);
    const VectorXd drag = flight.drag(), before = largest(drag) * random_vector(trial.random, 3 * particles);
    // One more rounding, of the sum.
    expect_vector(trial, ask(trial, flight, before), before + drag,
                  flight.bound() + 4 * kUnit * (largest(before) + largest(drag)),
                  "the drag that is added to what f held");
  }
}

void extremes(Trial& trial) {
  Random& random = trial.random;
  ask(trial, random_flight(random, 0, 1), VectorXd(0));
  Flight with_the_air = random_flight(random, 4, 1);
  with_the_air.v = with_the_air.wind;
  expect_drag(trial, with_the_air);
  Flight none = random_flight(random, 4, 1);
  none.coefficient = 0;
  expect_drag(trial, none);
  expect_drag(trial, {1e-200, VectorXd::Zero(9), 1e140 * random_vector(random, 9)});
  expect_drag(trial, {1, VectorXd::Zero(9), 1e-100 * random_vector(random, 9)});
}

}  // namespace

std::vector<Category> categories() {
  return {{"AtRest", "Air at rest", 3, at_rest},
          {"Wind", "Wind", 2, wind},
          {"Added", "Added to what is there", 1, added},
          {"Extremes", "None, slow and very fast particles", 1, extremes}};
}

}  // namespace grader::x1
