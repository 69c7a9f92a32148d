// The light that a point of a hair reflects to the eye.
//
// J. T. Kajiya and T. L. Kay, "Rendering Fur with Three Dimensional Textures", SIGGRAPH 1989: it depends on
// the strand's tangent alone. Diffuse: the sine of the angle between tangent T and light L (their equation
// 14). Highlights: with the half-way vector H between light and eye, sin(T, H)^p, as in T. Scheuermann,
// "Practical Real-Time Hair Rendering and Shading" (SIGGRAPH 2004 sketches). There are two highlights with
// shifted tangents: one towards the root and white, one towards the tip and of the hair's colour, as found by
// S. R. Marschner et al., "Light Scattering from Human Hair Fibers" (SIGGRAPH 2003).
#pragma once

#include <cstdint>

#include "hair/render/drawing.h"

namespace hair {

// sin(T, L); both of length 1.
float kajiya_diffuse(const Eigen::Vector3f& tangent, const Eigen::Vector3f& light);

// sin(T', H)^sharpness, where T' is T shifted by `shift` along `across`, which is of length 1 and
// perpendicular to T.
float shifted_highlight(const Eigen::Vector3f& tangent, const Eigen::Vector3f& across,
                        const Eigen::Vector3f& half_way, float shift, float sharpness);

// The colour and the highlights of one strand. They are the same in each picture.
struct StrandTint {
  Colour root, tip;
  float shift;  // the highlights' shift
};
StrandTint strand_tint(const StrandsDrawing& strands, std::uint32_t id);

struct HairPoint {
  Eigen::Vector3f at, tangent;  // the view's axes; the tangent has length 1
  float along;                  // 0 at the root, 1 at the tip
  float opacity;                // optical depth of the hair between it and the light
  float lit;                    // the part of the light that solids let through
};

// `up`: away from the ground, in the view's axes. The result is linear, 0 to 1.
Colour shaded_hair(const HairPoint& point, const StrandTint& tint, const Eigen::Vector3f& up);

}  // namespace hair
