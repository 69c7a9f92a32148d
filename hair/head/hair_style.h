// How hair is done: what its strands have in common. Plain data, and styles that have names.
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
  int points;                        // of a strand, if nothing else is asked for
  double length;                     // along a strand; of tied hair, from the tie
  double varies;                     // strands are longer or shorter by up to this part of it
  double lift;                       // of the root's direction: 0 combed flat, 1 straight out
  double comb;                       // so far a strand goes as it is combed
  double stiffness;                  // over this length it turns to where it is drawn: down, or to the tie
  double tilt;                       // radians; roots' directions differ by up to this
  double radius = 0;                 // of curls, or the height of waves; 0: none
  double pitch = 0;                  // what a turn or a wave advances by
  bool flat = false;                 // waves; else curls
  int clump = 0;                     // strands in a clump; 0: there are none
  double gathered = 0;               // how much of the way to its clump's centre a tip is
  double fly_aways = 0;              // this part of the strands is in no clump, and stands out more
  std::optional<Vector3d> tie = {};  // the direction from the head's centre to where hair is tied
};

const std::vector<HairStyle>& hair_styles();

// Null: there is none of this name.
const HairStyle* find_hair_style(std::string_view name);

// The fewest points that follow a strand's curls or waves: eight for each turn, and 8 at least.
int fewest_points(const HairStyle& style);

}  // namespace hair
