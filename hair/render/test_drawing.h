// A drawing with every kind of object, for tests.
#pragma once

#include "hair/render/camera.h"
#include "hair/render/drawing.h"

namespace hair {

struct TestScene {
  Drawing drawing;
  Camera camera;
};

// Two hundred wavy strands on a head, ground, tubes, a ball, a ring and a sheet; `scale` metres wide.
TestScene test_scene(double aspect, double scale = 1);

}  // namespace hair
