// Maps the values of an axis to pixels, linearly or logarithmically, and chooses the axis' ticks.
#pragma once

#include <string>
#include <vector>

#include "hair/io/plot/figure.h"

namespace hair::plot {

struct Tick {
  double value = 0;

  // "0.1", or "10" with the exponent "-6". A minor tick has no label.
  std::string label = {}, exponent = {};

  bool is_minor() const { return label.empty(); }
};

class Scale {
 public:
  // The limits are the axis' own, or fit the values with a margin at either end: `room` is the margin
  // relative to the length, 0 if the drawing fills the axis. pixel_low and pixel_high belong to the lower and
  // upper limit. Throws std::invalid_argument, with `what` in the message, for a value that is not finite, or
  // not positive on a logarithmic axis, and for a lower limit that is not below the upper one.
  Scale(const Axis& axis, const std::vector<double>& values, double room, double pixel_low, double pixel_high,
        const std::string& what);

  double pixel(double value) const;
  double low() const { return low_; }
  double high() const { return high_; }
  bool contains(double value) const { return value >= low_ && value <= high_; }
  bool logarithmic() const { return logarithmic_; }

  // Ticks in increasing order, about `most` of them with labels.
  std::vector<Tick> ticks(int most) const;

  // The value itself, or its logarithm on a logarithmic axis. Differences of places are lengths on the axis.
  double place(double value) const;
  double value_at(double place) const;

 private:
  std::vector<Tick> linear_ticks(int most) const;
  std::vector<Tick> logarithmic_ticks(int most) const;

  bool logarithmic_;
  double low_, high_;
  double pixel_low_, pixel_high_;
};

}  // namespace hair::plot
