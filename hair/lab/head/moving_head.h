// A head that moves with its hair: all of its strands, or some of them, simulated. There are two ways: given
// code with the exercises, strand by strand; and, in a program that has one, an engine that steps many
// strands at a time.
//
// In both the hair has stretch, bending, gravity, drag in the air, and collides with the head if that is
// asked for. Strands do not touch each other. Times are frames: kFrame s, of kStepsPerFrame equal steps.
#pragma once

#include <memory>
#include <span>

#include "hair/lab/head/head_hair.h"
#include "hair/scene/motion.h"

namespace hair::head_study {

inline constexpr double kFramesPerSecond = 30;
inline constexpr int kStepsPerFrame = 2;
inline constexpr double kDrag = 2e-4;     // N s/m^2, per metre of hair
inline constexpr double kFriction = 0.2;  // Coulomb's mu of the head

// It waits for kSettle frames, in which hair settles; then it turns to one side and back within kMoving
// frames.
inline constexpr int kSettle = 15, kMoving = 30;
inline constexpr double kTurn = 60;  // degrees
Motion turn_of_head();

class MovingHead {
 public:
  virtual ~MovingHead() = default;
  // Goes to the next frame. Throws std::runtime_error if a strand breaks; passes on exercises' exceptions.
  virtual void advance() = 0;
  // Strand after strand, 3n numbers each, m.
  virtual void read(std::span<double> points) const = 0;
};

struct MovingHeadSettings {
  std::shared_ptr<const Bust> bust;
  bool collides = true;
  int threads = 1;
};

// `which` of the head's strands: ascending. With H1, H2 (for straight hair) and H4.
std::unique_ptr<MovingHead> given_head(const GrownHead& head, std::span<const std::size_t> which,
                                       const MovingHeadSettings& settings);

// The engine: straight hair only; it also corrects lengths. The program defines both functions. Without an
// engine, has_fast_head is false and fast_head returns null.
bool has_fast_head();
std::unique_ptr<MovingHead> fast_head(const GrownHead& head, std::span<const std::size_t> which,
                                      const MovingHeadSettings& settings);

}  // namespace hair::head_study
