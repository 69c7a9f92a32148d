#include "hair/lab/study/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hair {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double distance(const Eigen::VectorXd& x, int i, int j) {
  return (x.segment<3>(3 * i) - x.segment<3>(3 * j)).norm();
}

void raise(double& largest, double value) {
  largest = std::max(largest, value);
}

// The rest lengths of a strand's segments, or of a toy's springs and rods that are longer than 0.
std::vector<RestLength> rest_lengths(const Problem& problem) {
  std::vector<RestLength> lengths;
  if (problem.is_toy()) {
    const Toy& toy = problem.scene.toys[0];
    for (const particles::Spring& spring : toy.springs)
      if (spring.rest_length > 0) lengths.push_back({spring.i, spring.j, spring.rest_length});
    for (const particles::Rod& rod : toy.constraints.rods)
      if (rod.length > 0) lengths.push_back({rod.i, rod.j, rod.length});
  } else {
    const Strand& strand = problem.scene.hair.strands[0].strand;
    for (int i = 0; i < strand.segments(); ++i) lengths.push_back({i, i + 1, strand.rest_length[i]});
  }
  return lengths;
}

}  // namespace

const NormName& name_of(Norm norm) {
  static constexpr std::array<NormName, kNorms> kNames = {{
      {"final_largest", "m", "largest error at the end", "the largest distance of a particle at the end"},
      {"final_rms", "m", "RMS error at the end", "the root mean square distance of the particles at the end"},
      {"trajectory", "m", "L2 error of the way",
       "the root mean square distance of the particles at all moments: the trajectory's L2 norm"},
      {"length", "", "error of the lengths",
       "the largest error of a segment's length at any moment, relative to its length at rest"},
      {"energy", "", "error of the energy",
       "the largest error of the energy at any moment, relative to the energy that moves: the most that "
       "kinetic energy and the change of potential energy add up to"},
      {"angular_momentum", "", "error of the angular momentum",
       "the largest error of the angular momentum about the origin at any moment, relative to the largest "
       "that the accurate motion has"},
  }};
  return kNames[static_cast<int>(norm)];
}

std::string with_unit(const NormName& norm) {
  return std::string(norm.title) + ", " + (*norm.unit ? norm.unit : "relative");
}

double size_of(const Problem& problem) {
  double size = 0;
  if (problem.is_toy()) {
    const Eigen::VectorXd& x = problem.scene.toys[0].start.x;
    for (int i = 1; i < static_cast<int>(x.size() / 3); ++i) raise(size, distance(x, i, 0));
  } else {
    size = problem.scene.hair.strands[0].strand.rest_length.sum();
  }
  return size > 0 ? size : 1;
}

Errors floors(const Problem& problem, double least) {
  const double size = size_of(problem);
  double shortest = size;
  for (const RestLength& one : rest_lengths(problem)) shortest = std::min(shortest, one.length);
  Errors errors;
  errors[Norm::final_largest] = errors[Norm::final_rms] = errors[Norm::trajectory] = least;
  errors[Norm::length] = 2 * least / shortest;
  errors[Norm::energy] = errors[Norm::angular_momentum] = least / size;
  return errors;
}

ErrorTally::ErrorTally(const Problem& problem, const Trajectory& accurate)
    : accurate_(accurate), lengths_(rest_lengths(problem)) {}

double ErrorTally::add(const SceneRun& scene_run) {
  const particles::State state = scene_run.state();
  const particles::State& truth = accurate_.at(moments_);
  const FrameMeasures measures = scene_run.measure(state), true_measures = scene_run.measure(truth);
  const Eigen::VectorXd &x = state.x, &true_x = truth.x;
  const double largest = largest_distance(x, true_x);
  if (moments_ == 0) potential_ = true_measures.potential;
  const double mean_square = 3 * (x - true_x).squaredNorm() / static_cast<double>(x.size());
  if (moments_ > 0) squares_ += mean_square;

  largest_[Norm::final_largest] = largest;
  largest_[Norm::final_rms] = std::sqrt(mean_square);
  for (const RestLength& one : lengths_)
    raise(largest_[Norm::length],
          std::abs(distance(x, one.i, one.j) - distance(true_x, one.i, one.j)) / one.length);
  raise(largest_[Norm::energy], std::abs(measures.energy() - true_measures.energy()));
  raise(largest_[Norm::angular_momentum],
        (measures.angular_momentum - true_measures.angular_momentum).norm());
  raise(most_energy_, true_measures.kinetic + std::abs(true_measures.potential - potential_));
  raise(most_angular_momentum_, true_measures.angular_momentum.norm());
  ++moments_;
  return largest;
}

Errors ErrorTally::errors() const {
  Errors errors = largest_;
  errors[Norm::trajectory] = std::sqrt(squares_ / std::max(1, moments_ - 1));
  if (lengths_.empty()) errors[Norm::length] = kNone;
  errors[Norm::energy] = most_energy_ > 0 ? largest_[Norm::energy] / most_energy_ : kNone;
  errors[Norm::angular_momentum] =
      most_angular_momentum_ > 0 ? largest_[Norm::angular_momentum] / most_angular_momentum_ : kNone;
  return errors;
}

}  // namespace hair
