// How far hair that is made of guides is from the same hair simulated.
//
// With d_ki the distance of point i of strand k from where it is simulated, n points to a strand:
//
//   e_k   = sqrt(mean_i d_ki^2)            a strand's error at a moment
//   rms   = sqrt(mean_k e_k^2)             of all strands, also those that are guides
//   most  = the e_k that 95 % of the strands do not exceed: of K strands the ceil(0.95 K)-th from below
#pragma once

#include <span>
#include <vector>

namespace hair::head_study {

struct HeadError {
  double rms = 0, most = 0;  // m
};

struct HeadErrors {
  HeadError start, end;  // as the head begins to move, and at the end
  double rms = 0;        // over all moments but the start, root mean square
  double highest = 0;    // the highest `most` of these moments
};

class HeadErrorTally {
 public:
  explicit HeadErrorTally(int points) : points_(points) {}

  // At each moment in order, the start first: 3 numbers a point, strand after strand, at least one. Throws std::invalid_argument for
  // spans of other sizes.
  void add(std::span<const double> made, std::span<const double> simulated);

  const HeadErrors& errors() const { return errors_; }

 private:
  int points_;
  int moments_ = 0;
  double squares_ = 0;  // the sum of rms^2
  HeadErrors errors_;
  std::vector<double> of_strands_;
};

}  // namespace hair::head_study
