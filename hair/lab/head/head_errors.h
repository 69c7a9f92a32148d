// The distance of hair made of guides from the same hair simulated.
//
// With d_ki the difference between the made and the simulated position of point i of strand k, in the head's
// axes, n points to a strand:
//
//   e_k   = sqrt(mean_i |d_ki|^2)          a strand's error at a moment
//   rms   = sqrt(mean_k e_k^2)             of all strands, also those that are guides
//   most  = the e_k that 95 % of the strands do not exceed: of K strands the ceil(0.95 K)-th from below
//
// A strand may have another shape than its neighbours from the start, and keep it. So there is also the error
// of the motion alone: d_ki less its value at the start, as if each strand were given its own shape once.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace hair::head_study {

struct HeadError {
  double rms = 0, most = 0;  // m
};

struct HeadErrors {
  HeadError start, end;   // when the head begins to move, and at the end
  HeadError all, motion;  // all moments but the start: the root mean square, and the highest `most`
};

class HeadErrorTally {
 public:
  explicit HeadErrorTally(int points) : points_(points) {}

  // Call this at each moment in order, the start first: 3 numbers a point, strand after strand, at least one,
  // as many each time. `turn`: the head's rotation since the start.
  void add(std::span<const double> made, std::span<const double> simulated, const Eigen::Matrix3d& turn);

  const HeadErrors& errors() const { return errors_; }

 private:
  int points_;
  int moments_ = 0;
  double squares_ = 0, motion_squares_ = 0;  // sums of rms^2
  HeadErrors errors_;
  std::vector<float> at_start_;  // d
  std::vector<double> of_strands_, motion_of_strands_;
};

}  // namespace hair::head_study
