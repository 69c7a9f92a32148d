// The times of a picture's parts, one after the other.
#pragma once

#include "hair/render/opengl/gl.h"
#include "solver/timing.h"

namespace hair {

class Laps {
 public:
  // Costs nothing if `on` is false.
  explicit Laps(bool on) : on_(on) {}

  // Adds the time since the last lap, when OpenGL has finished its commands.
  void lap(const gl::Functions& gl, double& sum) {
    if (!on_) return;
    gl.Finish();
    const double time = timing::wall_seconds();
    sum += time - last_;
    last_ = time;
  }

 private:
  bool on_;
  double last_ = timing::wall_seconds();
};

}  // namespace hair
