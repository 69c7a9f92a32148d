// A drawing with every kind of object, for tests.
#pragma once

#include <cmath>

#include "hair/render/camera.h"
#include "hair/render/drawing.h"

namespace hair {

struct TestScene {
  Drawing drawing;
  Camera camera;
};

// Two hundred wavy strands on a head, ground, tubes, a ball, a ring and a sheet; `scale` metres wide.
inline TestScene test_scene(double aspect, double scale = 1) {
  Drawing drawing;
  drawing.strands.width = 3e-3 * scale;
  for (int i = 0; i < 200; ++i) {
    const double around = 2.4 * i, polar = 0.01 * i;
    const Vector3d out(std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                       std::cos(polar));
    drawing.strands.sizes.push_back(12);
    for (int k = 0; k < 12; ++k) {
      const double s = k / 11.0;
      drawing.strands.points.emplace_back(
          scale * (Vector3d(0, 0, 0.5) + (0.15 + 0.1 * s) * out +
                   Vector3d(0.01 * std::sin(9 * s + i), 0.01 * std::cos(8 * s + i), -0.3 * s * s)));
    }
  }
  drawing.obstacles.push_back({Sphere{scale * Vector3d(0, 0, 0.5), 0.15 * scale}});
  drawing.obstacles.push_back(
      {Capsule{scale * Vector3d(0, 0, 0.1), scale * Vector3d(0, 0, 0.3), 0.08 * scale}});
  drawing.obstacles.push_back({Plane{Vector3d::Zero(), Vector3d(0, 0, 1)}});
  drawing.tubes.push_back(
      {scale * Vector3d(0.3, 0, 0.1), scale * Vector3d(0.5, 0.2, 0.6), 0.02 * scale, {0.2F, 0.5F, 0.3F}});
  drawing.balls.push_back({scale * Vector3d(0.5, 0.2, 0.6), 0.05 * scale, {0.7F, 0.1F, 0.1F}});
  drawing.rings.push_back({scale * Vector3d(-0.45, 0, 0.3),
                           Vector3d(0.3, 1, 0.2),
                           0.12 * scale,
                           0.01 * scale,
                           {0.6F, 0.5F, 0.1F}});
  Sheet sheet{8, 6, {}, {0.1F, 0.3F, 0.6F}};
  for (int r = 0; r < 8; ++r) {
    for (int c = 0; c < 6; ++c) {
      sheet.points.emplace_back(
          scale * Vector3d(0.3 + 0.04 * c, -0.2 + 0.02 * std::sin(c + 0.5 * r), 0.05 + 0.04 * r));
    }
  }
  drawing.sheets.push_back(sheet);

  Bounds bounds;
  bounds.extend(scale * Vector3d(-0.5, -0.3, 0));
  bounds.extend(scale * Vector3d(0.5, 0.3, 0.7));
  return {drawing, frame_camera(bounds, aspect)};
}

}  // namespace hair
