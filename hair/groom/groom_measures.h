// Statistics of a groom: numbers of strands, lengths, curvatures, positions, and oddities.
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "hair/groom/groom.h"
#include "hair/groom/root_sphere.h"

namespace hair {

// Statistics of a set of numbers; all 0 if it is empty. The median and `most` are numbers of the set.
struct Spread {
  double min = 0, median = 0, mean = 0;
  double most = 0;  // nine of ten numbers are at most this
  double max = 0;
};

Spread spread_of(std::vector<double> numbers);

// A property that many programs do not expect.
struct Oddity {
  std::string what;  // "bald roots"
  long count;
  std::size_t strand;  // the first one
};

// Statistics of the strands with two points or more, all of them finite; lengths in the groom's unit.
struct GroomMeasures {
  long strands = 0, points = 0;  // all strands and all points
  Spread points_of_strand, length, segment;
  // At each point between two segments without length 0: the inverse radius of the circle through the three
  // points (Menger's curvature), and the angle in degrees by which the line turns.
  Spread curvature, bend;
  Eigen::AlignedBox3d box, roots;  // they hold the finite ones of all points, and of all roots
  // The metres in a unit if the roots' box is as long as a scalp, 0.2 m; 0 if there are too few roots.
  double unit_guess = 0;
  std::optional<RootSphere> root_sphere;  // the best fit to the roots: about the head's
  std::vector<Oddity> odd;
};

GroomMeasures measure_groom(const Groom& groom);

}  // namespace hair
