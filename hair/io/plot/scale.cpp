#include "hair/io/plot/scale.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "hair/io/plot/page.h"

namespace hair::plot {

namespace {

constexpr double kRounding = 1e-9;  // part of an axis: a limit this near to a tick counts as the tick

void require_value(const Axis& axis, double value, const std::string& what) {
  if (!std::isfinite(value))
    throw std::invalid_argument(what + ": " + to_text(value) + " on the axis \"" + axis.title +
                                "\"; a value must be finite");
  if (axis.logarithmic && !(value > 0))
    throw std::invalid_argument(what + ": " + to_text(value) + " on the logarithmic axis \"" + axis.title +
                                "\"; a value must be positive");
}

std::string fixed(double value, int decimals) {
  std::array<char, 64> text = {};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value + 0.0,
                                     std::chars_format::fixed, decimals)
                           .ptr};
}

bool reads_well_in_full(int lowest_exponent, int highest_exponent) {
  return lowest_exponent >= -3 && highest_exponent <= 4;
}

// mantissa * 10^exponent, where the mantissa is 1, 2 or 5.
Tick decimal_tick(int mantissa, int exponent, bool in_full) {
  Tick tick = {mantissa * std::pow(10.0, exponent)};
  if (in_full) {
    tick.label = fixed(tick.value, std::max(0, -exponent));
  } else {
    tick.label = mantissa == 1 ? "10" : std::to_string(mantissa) + "\u00B7" + "10";
    tick.exponent = std::to_string(exponent);
  }
  return tick;
}

// 1, 2 or 5 times a power of ten, at least `least`.
double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const int mantissa : {1, 2, 5})
    if (mantissa * power >= least * (1 - kRounding)) return mantissa * power;
  return 10 * power;
}

}  // namespace

Scale::Scale(const Axis& axis, const std::vector<double>& values, double room, double pixel_low,
             double pixel_high, const std::string& what)
    : logarithmic_(axis.logarithmic), pixel_low_(pixel_low), pixel_high_(pixel_high) {
  for (const double value : values) require_value(axis, value, what);
  for (const std::optional<double>& limit : {axis.low, axis.high})
    if (limit) require_value(axis, *limit, what);

  double least = place(logarithmic_ ? 1 : 0), most = place(logarithmic_ ? 10 : 1);
  if (!values.empty()) {
    least = place(*std::min_element(values.begin(), values.end()));
    most = place(*std::max_element(values.begin(), values.end()));
  }
  double margin = room * (most - least);
  if (most - least <= kRounding * std::max(std::abs(least), std::abs(most)) || most == least)
    margin = logarithmic_ ? 0.5 : least == 0 ? 1 : 0.1 * std::abs(least);
  // An axis whose margin reaches 0 begins at 0.
  const bool from_zero = !logarithmic_ && least >= 0 && margin >= least;
  low_ = axis.low.value_or(from_zero ? 0 : value_at(least - margin));
  high_ = axis.high.value_or(value_at(most + margin));
  if (!(low_ < high_) || !std::isfinite(high_) || !std::isfinite(low_) || (logarithmic_ && !(low_ > 0)))
    throw std::invalid_argument(what + ": the axis \"" + axis.title + "\" goes from " + to_text(low_) +
                                " to " + to_text(high_) + "; it must grow, and stay in what a number can be");
}

double Scale::place(double value) const {
  return logarithmic_ ? std::log10(value) : value;
}

double Scale::value_at(double place) const {
  return logarithmic_ ? std::pow(10.0, place) : place;
}

double Scale::pixel(double value) const {
  const double part = (place(value) - place(low_)) / (place(high_) - place(low_));
  return pixel_low_ + part * (pixel_high_ - pixel_low_);
}

std::vector<Tick> Scale::ticks(int most) const {
  return logarithmic_ ? logarithmic_ticks(most) : linear_ticks(most);
}

std::vector<Tick> Scale::linear_ticks(int most) const {
  const double step = round_step((high_ - low_) / std::max(1, most)), slack = kRounding * (high_ - low_);
  const int step_exponent = static_cast<int>(std::floor(std::log10(step) + kRounding));
  const int exponent =
      static_cast<int>(std::floor(std::log10(std::max(std::abs(low_), std::abs(high_))) + kRounding));
  const bool in_full = reads_well_in_full(step_exponent, exponent);
  std::vector<Tick> ticks;
  const double first = std::ceil((low_ - slack) / step), last = std::floor((high_ + slack) / step);
  for (double i = first; i <= last; ++i) {
    Tick tick = {i * step};
    if (in_full || i == 0) {
      tick.label = i == 0 ? "0" : fixed(tick.value, std::max(0, -step_exponent));
    } else {
      const double mantissa = tick.value / std::pow(10.0, exponent);
      tick.label = fixed(mantissa, std::max(0, exponent - step_exponent)) + "\u00B7" + "10";
      tick.exponent = std::to_string(exponent);
    }
    ticks.push_back(tick);
  }
  return ticks;
}

std::vector<Tick> Scale::logarithmic_ticks(int most) const {
  const double from = place(low_) - kRounding, to = place(high_) + kRounding;
  const int first = static_cast<int>(std::floor(from)), last = static_cast<int>(std::ceil(to));
  const int decades = static_cast<int>(std::floor(to)) - static_cast<int>(std::ceil(from)) + 1;
  const int stride = std::max(1, static_cast<int>(std::ceil(decades / static_cast<double>(most))));
  const bool in_full = reads_well_in_full(first, last);
  const bool few = decades < 3;  // labels at 1, 2 and 5

  std::vector<Tick> ticks;
  int labels = 0;
  for (int exponent = first; exponent <= last; ++exponent)
    for (int mantissa = 1; mantissa <= 9; ++mantissa) {
      const double value = mantissa * std::pow(10.0, exponent), at = std::log10(value);
      if (at < from || at > to) continue;
      const bool labelled = mantissa == 1 ? exponent % stride == 0 : few && (mantissa == 2 || mantissa == 5);
      if (!labelled && mantissa > 1 && stride > 1) continue;
      ticks.push_back(labelled ? decimal_tick(mantissa, exponent, in_full) : Tick{value});
      labels += labelled;
    }
  return labels >= 2 ? ticks : linear_ticks(most);
}

}  // namespace hair::plot
