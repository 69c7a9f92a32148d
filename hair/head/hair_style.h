// A hair style: the common properties of its strands. Plain data, and named styles.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "hair/strand/rest_shape.h"

namespace hair {

// All lengths in m.
struct HairStyle {
  const char* name;
  const char* shows;                 // one line
  int points;                        // per strand, unless a number is given
  double length;                     // along a strand; for tied hair, from the tie
  double varies;                     // lengths differ by up to this part
  double layer;                      // the thickness of all hair, where it lies on the head or the shoulders
  double lift;                       // the root's direction: 0 combed flat, 1 straight out
  double comb;                       // the length over which a strand follows its combed direction
  double stiffness;                  // the length over which it turns to its target: down, or to the tie
  double tilt;                       // radians; the largest difference of a root's direction
  double radius = 0;                 // a curl's, or the height of waves; 0: none
  double pitch = 0;                  // the advance per turn or wave
  bool flat = false;                 // waves; otherwise curls
  int clump = 0;                     // strands per clump; 0: no clumps
  double gathered = 0;               // the part of the distance to its clump's centre that a tip closes
  double fly_aways = 0;              // the part of the strands that is in no clump, and stands out more
  std::optional<Vector3d> tie = {};  // the direction from the head's centre to the tie
};

const std::vector<HairStyle>& hair_styles();

// Null if no style has this name.
const HairStyle* find_hair_style(std::string_view name);

// The fewest points that follow a strand's curls or waves: eight for each turn, and 8 at least.
int fewest_points(const HairStyle& style);

}  // namespace hair
