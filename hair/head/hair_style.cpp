#include "hair/head/hair_style.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hair {

const std::vector<HairStyle>& hair_styles() {
  static const std::vector<HairStyle> styles = {
      {.name = "long-smooth",
       .shows = "long hair, combed back, that falls to the shoulders",
       .points = 32,
       .length = 0.3,
       .varies = 0.12,
       .layer = 0.016,
       .lift = 0.35,
       .comb = 0.05,
       .stiffness = 0.025,
       .tilt = 0.12,
       .clump = 60,
       .gathered = 0.7,
       .fly_aways = 0.01},
      {.name = "short-curly",
       .shows = "short hair in tight curls",
       .points = 64,
       .length = 0.16,
       .varies = 0.2,
       .layer = 0,
       .lift = 0.8,
       .comb = 0.02,
       .stiffness = 0.05,
       .tilt = 0.3,
       .radius = 0.0045,
       .pitch = 0.011,
       .clump = 40,
       .gathered = 0.85,
       .fly_aways = 0.02},
      {.name = "wavy",
       .shows = "hair to the chin, in waves",
       .points = 64,
       .length = 0.26,
       .varies = 0.12,
       .layer = 0.012,
       .lift = 0.45,
       .comb = 0.04,
       .stiffness = 0.03,
       .tilt = 0.15,
       .radius = 0.005,
       .pitch = 0.045,
       .flat = true,
       .clump = 60,
       .gathered = 0.75,
       .fly_aways = 0.015},
      {.name = "ponytail",
       .shows = "hair that is drawn tight to a tie behind the crown, and falls from there",
       .points = 40,
       .length = 0.24,
       .varies = 0.1,
       .layer = 0.006,
       .lift = 0.15,
       .comb = 0.02,
       .stiffness = 0.012,
       .tilt = 0.05,
       .clump = 80,
       .gathered = 0.2,
       .fly_aways = 0.005,
       .tie = Vector3d(0, 0.85, 0.53)}};
  return styles;
}

const HairStyle* find_hair_style(std::string_view name) {
  const auto& styles = hair_styles();
  const auto found =
      std::find_if(styles.begin(), styles.end(), [&](const HairStyle& one) { return one.name == name; });
  return found == styles.end() ? nullptr : &*found;
}

int fewest_points(const HairStyle& style) {
  if (style.radius == 0) return 8;
  const double around = 2 * std::numbers::pi * style.radius;
  // The length of a curl's turn; a wave's is shorter.
  const double turn = style.flat ? style.pitch : std::hypot(around, style.pitch);
  const double turns = (1 + style.varies) * style.length / turn;
  return std::max(8, static_cast<int>(std::ceil(8 * turns)) + 1);
}

}  // namespace hair
