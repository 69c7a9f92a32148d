// STAFF ONLY. Hidden cases of H8's geometry: Stumpff's functions, frames and Jacobians.
//
// Bounds: the contract's. A right formula in double precision stays far below them. Closed forms lose at most
// u / x^3 of c_6, which is 1e-13 for x above 0.1, where they are used. Frames and Jacobians are sums of few
// terms of their size.
#include <cmath>
#include <limits>

#include "hair/super_helix.h"
#include "reference/H8/answers.h"

namespace grader::h8 {
namespace {

constexpr double kFunctions = 1e-11, kFrames = 1e-10;

// 1/k!, and 2 / ((k - 2)! x) where it is less.
double size_of_function(int k, double x) {
  const double size = 1 / std::tgamma(k + 1);
  return k < 2 || x == 0 ? size : std::min(size, 2 / (std::tgamma(k - 1) * x));
}

void expect_functions(Trial& trial, double x) {
  const std::array<double, 8> c = ask_stumpff(trial, x), expected = hair::stumpff(x);
  Compared numbers{VectorXd(8), VectorXd(8), 1, {}, kFunctions};
  for (int k = 0; k < 8; ++k) {
    numbers.actual[k] = c[k] / size_of_function(k, x);
    numbers.expected[k] = expected[k] / size_of_function(k, x);
  }
  for (int k = 0; k < 8; ++k)
    trial.expect_at_most(std::abs(c[k] - expected[k]), kFunctions * size_of_function(k, x),
                         "c_" + std::to_string(k), numbers);
}

struct Place {
  MaterialFrame start;
  Vector3d curvature;
  double s;
};

// A random place in an element of about 1 cm.
Place any_place(Random& random, double angle) {
  const double s = random.uniform(0.002, 0.02);
  return {any_frame(random), angle / s * any_direction(random), s};
}

// The errors below are relative to their bound: NaN if a number is NaN, and infinite for an answer that does
// nothing.
constexpr double kNothing = std::numeric_limits<double>::infinity();

struct Judged {
  double error;
  Compared numbers;
};

Judged frame_error(Trial& trial, const Place& place) {
  const auto& [start, curvature, s] = place;
  const MaterialFrame answered = ask_frame(trial, start, curvature, s);
  const MaterialFrame expected = hair::frame_at(start, curvature, s);
  const double of_axes = (answered.axes - expected.axes).norm();
  Compared numbers{answered.axes.reshaped(), expected.axes.reshaped(), 9, start.axes.reshaped(), kFrames};
  if (of_axes <= kFrames)
    numbers = {
        (answered.position - start.position) / s, (expected.position - start.position) / s, 3, {}, kFrames};
  if (answered.position == start.position || answered.axes.isZero()) return {kNothing, numbers};
  return {((answered.position - expected.position).norm() / s + of_axes) / kFrames, numbers};
}

Judged jacobian_error(Trial& trial, const Place& place) {
  const auto& [start, curvature, s] = place;
  const hair::HelixJacobian answered = ask_jacobian(trial, start, curvature, s);
  const hair::HelixJacobian expected = hair::jacobian_at(start, curvature, s);
  Compared numbers{VectorXd(18), VectorXd(18), 9, {}, kFrames};
  numbers.actual << answered.turns.reshaped() / s, answered.moves.reshaped() / (s * s);
  numbers.expected << expected.turns.reshaped() / s, expected.moves.reshaped() / (s * s);
  if (answered.turns.isZero() || answered.moves.isZero()) return {kNothing, numbers};
  return {
      ((answered.turns - expected.turns).norm() / s + (answered.moves - expected.moves).norm() / (s * s)) /
          kFrames,
      numbers};
}

// A larger error is NaN or far too large a number: even a formula with a wrong sign stays below it.
constexpr double kMadness = 10 / kFrames;

using Error = Judged (*)(Trial&, const Place&);

// Checks a special element. A formula that is wrong for an ordinary one, too, costs only that category.
void expect_special(Trial& trial, Error error_of, const Place& place, const std::string& what) {
  auto [error, numbers] = error_of(trial, place);
  if (!(error <= 1) && error <= kMadness)
    trial.ask_aside([&, &error = error] {
      const double ordinary = error_of(trial, any_place(trial.random, 1.5)).error;
      if (ordinary > 1 && ordinary <= kMadness) error = 0;
    });
  trial.expect_at_most(error, 1, what, numbers);
}

// The largest difference of two strands' starts and ends, over its bound.
double difference(const std::vector<hair::HelixElement>& a, const std::vector<hair::HelixElement>& b) {
  double largest = 0, length = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    length += b[i].length;
    for (const auto frame : {&hair::HelixElement::start, &hair::HelixElement::end}) {
      const MaterialFrame &one = a[i].*frame, &other = b[i].*frame;
      const double error = (one.position - other.position).norm() / length + (one.axes - other.axes).norm();
      largest = largest >= error || std::isnan(largest) ? largest : error;
    }
  }
  return largest / (static_cast<double>(a.size()) * kFrames);
}

// The same with the ends of the student's own frame_at, so that a bug in it costs only its own category.
// These ends must be about as far away as ends are, since a frame_at that returns the start carries nothing.
// NaN if it does not answer.
double by_own_frames(Trial& trial, const MaterialFrame& root, const std::vector<hair::HelixElement>& answered,
                     std::vector<hair::HelixElement> elements) {
  MaterialFrame frame = root;
  double error = std::nan("");
  trial.ask_aside([&] {
    for (hair::HelixElement& element : elements) {
      element.start = frame;
      element.end = ask_frame(trial, frame, element.curvature, element.length);
      frame = element.end;
      const double gone = (element.end.position - element.start.position).norm() / element.length;
      if (!(gone >= 0.1 && gone <= 2)) return;
    }
    error = difference(answered, elements);
  });
  return error;
}

}  // namespace

void functions(Trial& trial) {
  for (const double most : {4.0, 40.0, 1e3, 1e6})
    for (int repeat = 0; repeat < 3; ++repeat) expect_functions(trial, trial.random.log_uniform(1.5, most));
}

// Checks 0, numbers near 0, and all others up to ordinary elements: there is no jump, wherever a series ends.
void nearly_straight(Trial& trial) {
  Random& random = trial.random;
  const auto expect_both = [&](double x) {
    expect_special(trial, frame_error, any_place(random, std::sqrt(x)),
                   "a frame of a nearly straight element");
    expect_special(trial, jacobian_error, any_place(random, std::sqrt(x)),
                   "a Jacobian of a nearly straight element");
  };
  expect_functions(trial, 0);
  expect_both(0);
  for (const double most : {1e-12, 1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0})
    for (int repeat = 0; repeat < 2; ++repeat) {
      expect_functions(trial, random.log_uniform(most / 10, most));
      expect_both(random.log_uniform(most / 10, most));
    }
}

void centre_line(Trial& trial) {
  for (int repeat = 0; repeat < 8; ++repeat) {
    const auto [error, numbers] = frame_error(trial, any_place(trial.random, trial.random.uniform(0.5, 3)));
    trial.expect_at_most(error, 1, "the centre line or the frame", numbers);
  }
}

void carried_frames(Trial& trial) {
  Random& random = trial.random;
  for (const int elements : {1, 2, 5, 20}) {
    const Hair hair = random_hair(random, {.elements = elements});
    const MaterialFrame root = any_frame(random);
    std::vector<hair::HelixElement> expected = hair.elements;
    hair::carry_frames(root, expected);
    const std::vector<hair::HelixElement> answered = ask_carried(trial, root, hair.elements);
    double error = difference(answered, expected);
    if (!(error <= 1)) {
      const double own = by_own_frames(trial, root, answered, expected);
      if (own <= 1) error = own;
    }
    trial.expect_at_most(error, 1, "where an element begins or ends");
  }
}

void jacobians(Trial& trial) {
  for (int repeat = 0; repeat < 8; ++repeat) {
    const auto [error, numbers] =
        jacobian_error(trial, any_place(trial.random, trial.random.uniform(0.5, 3)));
    trial.expect_at_most(error, 1, "how the frame turns or the point moves", numbers);
  }
}

void winding(Trial& trial) {
  for (const double most : {30.0, 60.0, 126.0})
    for (int repeat = 0; repeat < 2; ++repeat) {
      const double angle = trial.random.uniform(0.7 * most, most);
      expect_special(trial, frame_error, any_place(trial.random, angle), "a frame of an element that winds");
      expect_special(trial, jacobian_error, any_place(trial.random, angle),
                     "a Jacobian of an element that winds");
    }
}

}  // namespace grader::h8
