// A scene that plays: assembled once, with the parts that it needs and no others, then frame after frame.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hair/scene/scene.h"
#include "hair/strand/body.h"
#include "particles/state.h"

namespace hair {

// Of all strands and toys together.
struct FrameMeasures {
  double stretch = 0;                    // the largest |l - l0| / l0 of all segments, springs and rods
  double kinetic = 0, potential = 0;     // J
  Vector3d momentum = Vector3d::Zero();  // kg m/s
  Vector3d angular_momentum = Vector3d::Zero();  // kg m^2/s, about the origin

  double energy() const { return kinetic + potential; }
};

class Playback {
 public:
  // Throws std::invalid_argument as Simulation does.
  explicit Playback(const Scene& scene);
  ~Playback();
  Playback(const Playback&) = delete;
  Playback& operator=(const Playback&) = delete;

  // Back to the start, and on from there in the steps of `scene`: for those who play it again and again, for nothing
  // is assembled anew. Only states, root frames, obstacles and steps may differ from the original scene. Work is counted
  // from 0. Throws std::invalid_argument for other particles.
  void restart(const Scene& scene);

  // To the next frame. Nothing, or where it broke: "strand 0, step 17: filter". After that it stays where it
  // is and says the same. What a stub throws, passes.
  std::optional<std::string> advance();

  double time() const;  // s
  int frame() const;    // 0 at the start
  long steps() const;   // since the start, the one that broke among them

  // The coordinates of all bodies: strand after strand, then toy after toy. Of masses and springs these are positions.
  particles::State state() const;
  std::vector<Coordinates> coordinates() const;    // what each body's numbers are
  const std::vector<int>& strands() const;         // the number of points of each strand
  const std::vector<Obstacle>& obstacles() const;  // where they are now
  Work work() const;                               // of the hair; of toys the solver's steps

  // Of any state of the scene's particles at the present frame: a state that came from elsewhere is measured
  // by our own forces.
  FrameMeasures measure(const particles::State& state) const;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hair
