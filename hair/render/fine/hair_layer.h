// Fine hair as a layer of a picture: strands thinner than a pixel, drawn by the part of each pixel that they
// cover.
//
// A strand that is w pixels wide, seen through a tent of two pixels, covers its pixels by w in total, for any
// position between pixels and any slope (a line of X. Wu, "An Efficient Antialiasing Technique", SIGGRAPH
// 1991, is the limit w -> 0). Pieces of strands are sorted from near to far in each tile of the picture, and
// composited under nearer ones: T. Porter and T. Duff, "Compositing Digital Images", SIGGRAPH 1984. Random
// samples would add noise, and more samples than pixels; this method needs neither. Hair behind opaque hair
// is neither drawn nor shaded. Equal distances are in the order of strands, so the bytes are the same with
// any number of threads.
#pragma once

#include <functional>
#include <vector>

#include "hair/render/fine/fine_strands.h"
#include "hair/render/fine/hair_shading.h"
#include "hair/render/view.h"
#include "hair/simulation/strand_threads.h"

namespace hair {

// Pictures of floats, row after row, the lowest first. A pixel has two parts, one in front of a solid and one
// in front of the background: at a solid's edge, hair behind it covers only the second part.
struct HairLayer {
  int width, height;
  std::vector<float>
      pixels;  // red, green and blue, times the covered part; and the part of a solid that stays visible
  std::vector<float> empty;  // the part of the background that stays visible
};

// The solids and the light around hair in a picture.
struct HairSurroundings {
  // The solids' distances (along the view, in its unit) at samples x samples places in each pixel, row after
  // row, the lowest first; empty: there are none.
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
