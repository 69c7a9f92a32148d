#include "hair/io/plot/slope_guides.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hair/io/plot/lettering.h"

namespace hair::plot {

namespace {

constexpr double kLongest = 130, kShortest = 20;  // pixels
constexpr double kComfortable = 26;               // pixels to other drawings: more is no better
constexpr int kColumns = 20, kRows = 16;          // tried places

Spot between(const Spot& a, const Spot& b, double part) {
  return {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
}

// The spots that a guide covers: its line, and its label.
std::vector<Spot> spots_of(const PlacedGuide& guide, double label_width) {
  constexpr int kPieces = 10;
  std::vector<Spot> spots;
  for (int i = 0; i <= kPieces; ++i) spots.push_back(between(guide.from, guide.to, i / double{kPieces}));
  for (int i = 0; i <= 4; ++i)
    spots.push_back({guide.label.x + label_width * i / 4, guide.label.y - kSmall / 2});
  return spots;
}

// The least distance between two of these.
double distance(const std::vector<Spot>& spots, const std::vector<Spot>& taken) {
  double squared = std::numeric_limits<double>::infinity();
  for (const Spot& a : spots)
    for (const Spot& b : taken)
      squared = std::min(squared, (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
  return std::sqrt(squared);
}

// Beyond the comfortable distance, nearer is better.
double quality(double distance) {
  return distance < kComfortable ? distance : kComfortable + kComfortable / distance;
}

PlacedGuide place(const SlopeGuide& guide, const Box& box, const Scale& x, const Scale& y,
                  const std::vector<Spot>& taken) {
  const double across = box.width / (x.place(x.high()) - x.place(x.low()));  // pixels a decade
  const double up = box.height / (y.place(y.high()) - y.place(y.low()));
  const double norm = std::hypot(across, guide.slope * up);
  const double label_width = text_width(guide.name, kSmall), margin = 8;
  const double length = std::max(kShortest, std::min(kLongest, 0.4 * std::min(box.width, box.height)));
  const Spot along = {length * across / norm, -length * guide.slope * up / norm};

  PlacedGuide best = {};
  double best_quality = -1;
  for (int i = 0; i < kColumns; ++i)
    for (int j = 0; j < kRows; ++j) {
      // A label to the right of a rising line is at its upper end, one of a falling line at its lower end.
      const double free_width = box.width - 3 * margin - along.x - label_width;
      const double free_height = box.height - 2 * margin - kSmall - std::abs(along.y);
      PlacedGuide one;
      one.from.x = box.left + margin + std::max(0.0, free_width) * i / (kColumns - 1);
      one.from.y = box.top + margin + kSmall / 2 + std::max(0.0, free_height) * j / (kRows - 1) +
                   std::max(0.0, -along.y);
      one.to = {one.from.x + along.x, one.from.y + along.y};
      one.label = {one.to.x + margin, one.to.y + kSmall / 3};
      const double q = quality(distance(spots_of(one, label_width), taken));
      if (q > best_quality) {
        best_quality = q;
        best = one;
      }
    }
  return best;
}

}  // namespace

std::vector<PlacedGuide> place_guides(const std::vector<SlopeGuide>& guides, const Box& box, const Scale& x,
                                      const Scale& y, std::vector<Spot> taken) {
  std::vector<PlacedGuide> placed;
  for (const SlopeGuide& guide : guides) {
    placed.push_back(place(guide, box, x, y, taken));
    const std::vector<Spot> spots = spots_of(placed.back(), text_width(guide.name, kSmall));
    taken.insert(taken.end(), spots.begin(), spots.end());
  }
  return placed;
}

}  // namespace hair::plot
