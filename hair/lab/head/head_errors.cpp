#include "hair/lab/head/head_errors.h"

#include <algorithm>
#include <cmath>

namespace hair::head_study {
namespace {

// squares: e_k^2 for each strand; this function reorders them.
HeadError error_of(std::vector<double>& squares) {
  double sum = 0;
  for (const double square : squares) sum += square;
  const std::size_t strands = squares.size();
  const auto most = squares.begin() + static_cast<std::ptrdiff_t>((95 * strands + 99) / 100 - 1);
  std::nth_element(squares.begin(), most, squares.end());
  return {std::sqrt(sum / static_cast<double>(strands)), std::sqrt(*most)};
}

void add_moment(const HeadError& now, int moments, double& squares, HeadError& all) {
  squares += now.rms * now.rms;
  all = {std::sqrt(squares / moments), std::max(all.most, now.most)};
}

}  // namespace

void HeadErrorTally::add(std::span<const double> made, std::span<const double> simulated,
                         const Eigen::Matrix3d& turn) {
  const std::size_t numbers = 3 * static_cast<std::size_t>(points_);
  const bool starts = at_start_.empty();
  if (starts) at_start_.resize(made.size());
  of_strands_.assign(made.size() / numbers, 0);
  motion_of_strands_ = of_strands_;
  for (std::size_t at = 0; at < made.size(); at += 3) {
    const Eigen::Map<const Eigen::Vector3d> here(&made[at]), there(&simulated[at]);
    const Eigen::Vector3d d = turn.transpose() * (here - there);
    Eigen::Map<Eigen::Vector3f> at_start(&at_start_[at]);
    if (starts) at_start = d.cast<float>();
    of_strands_[at / numbers] += d.squaredNorm() / points_;
    motion_of_strands_[at / numbers] += (d - at_start.cast<double>()).squaredNorm() / points_;
  }
  errors_.end = error_of(of_strands_);
  if (starts) {
    errors_.start = errors_.end;
    return;
  }
  ++moments_;
  add_moment(errors_.end, moments_, squares_, errors_.all);
  add_moment(error_of(motion_of_strands_), moments_, motion_squares_, errors_.motion);
}

}  // namespace hair::head_study
