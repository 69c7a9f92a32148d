// Fine hair as a layer of a picture: strands that are thinner than a pixel, drawn by how much of each pixel
// they cover.
//
// A strand that is w pixels wide, seen through a tent of two pixels, covers its pixels by w in all, wherever
// between pixels it lies, and whatever its slope (a line of X. Wu, "An Efficient Antialiasing Technique",
// SIGGRAPH 1991, is the limit w -> 0). Pieces of strands are sorted from near to far in each tile of the
// picture, and laid under what is nearer: T. Porter and T. Duff, "Compositing Digital Images", SIGGRAPH 1984.
// This has no noise, as random samples would have, and needs no samples beside pixels. Where nothing shines
// through any more, hair is neither drawn nor shaded. Equal distances are in the order of strands; so the
// bytes are always the same, with any number of threads.
#pragma once

#include <functional>
#include <vector>

#include "hair/render/fine_strands.h"
#include "hair/render/hair_shading.h"
#include "hair/render/view.h"
#include "hair/simulation/strand_threads.h"

namespace hair {

// Pictures of floats, row after row from the bottom up. A pixel has two parts, with a solid in it and
// without: at a solid's edge hair behind it covers the one and not the other.
struct HairLayer {
  int width, height;
  std::vector<float>
      pixels;  // red, green and blue, times how much hair covers; and the part that it leaves of a solid
  std::vector<float> empty;  // the part that it leaves of the background
};

// What hair meets in a picture.
struct HairSurroundings {
  // The solids' distances (along the view, in its unit) at samples x samples places in each pixel, row after
  // row from the bottom up; empty: there are none.
  std::vector<float> distances = {};
  int samples = 1;
  // Hair between the light and a point, and the part of the light that solids let through; empty: no shadows.
  std::function<float(const Eigen::Vector3f&)> opacity = {}, lit = {};
};

HairLayer draw_hair_layer(const StrandsDrawing& drawing, const FineStrands& strands, const View& view,
                          int width, int height, const HairSurroundings& around, StrandThreads& threads);

// The integral of the tent max(1 - |t|, 0) from -infinity to u.
inline float tent_integral(float u) {
  if (u <= -1) return 0;
  if (u >= 1) return 1;
  return u < 0 ? 0.5F * (1 + u) * (1 + u) : 1 - 0.5F * (1 - u) * (1 - u);
}

}  // namespace hair
