// The line of one strand on a head (grow.h): its middle line, and the curls or waves about it.
#pragma once

#include <vector>

#include "hair/head/hair_style.h"
#include "hair/head/head.h"

namespace hair {

using Line = std::vector<Vector3d>;

// The properties that differ from strand to strand.
struct StrandTraits {
  double length;                           // m; for tied hair, from the tie
  Vector3d direction;                      // at the root, of length 1
  double phase = 0;                        // the start phase of curls or waves, radians
  double size = 1;                         // the factor of their radius
  Vector3d tie_offset = Vector3d::Zero();  // m, from the middle of the tie
  double gathered = 0;                     // the part of the distance to its clump's line that its tip closes
};

struct LineSettings {
  double step;       // m
  double clearance;  // m, of the layer of hair
};

// Grows until it is traits.length long; tied hair, until it is that long behind the tie. `clump` is the
// middle line of its clump, grown with the same step; null: it is in none.
Line middle_line(const Head& head, const HairStyle& style, const RootFrame& root, const StrandTraits& traits,
                 const LineSettings& settings, const Line* clump);

// The strand about its middle line, which has steps of a sixteenth of a wave at most.
Line with_curls(const Line& middle, const HairStyle& style, const RootFrame& root,
                const StrandTraits& traits);

// The first `length` of the line; all of it, if it is shorter.
Line cut(Line line, double length);

// Moves points, but not the root, until no piece between two of them is inside the head.
void move_out_of(const Head& head, Eigen::VectorXd& x);

}  // namespace hair
