// A head that moves with its hair: all of its strands, or some of them, simulated with the exercises, strand
// by strand.
//
// The hair has stretch, bending, gravity, drag in the air, and collides with the head if that is
// asked for. Strands do not touch each other. Times are frames: kFrame s, of kStepsPerFrame equal steps.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "hair/head/bust.h"
#include "hair/head/hair_style.h"
#include "hair/scene/motion.h"
#include "hair/scene/scene_run.h"

namespace hair::head_study {

// The hair of a head that is simulated strand by strand: its style on the bust, and its rest shape.
struct HeadHair {
  std::string id, title;  // "curly", "Curly hair"
  HairStyle style;
  int points;   // per strand
  bool curved;  // its rest shape is the grown one; else it is straight, and falls onto the head
};

// Straight hair; straight hair without random differences between strands (directions, lengths, clumps,
// fly-aways); wavy and curly hair.
const std::vector<HeadHair>& head_hairs();

// Strands of `points` points each, in metres, in the head's axes.
struct GrownHead {
  const HeadHair* hair = nullptr;
  std::vector<RootFrame> roots;          // axis: the scalp's normal
  std::vector<Eigen::VectorXd> strands;  // 3 points each
  double length = 0;                     // m, the mean of the strands'
};

// The same strands each time. Throws std::invalid_argument as grow_groom does.
GrownHead grow_head(const Bust& bust, const HeadHair& hair, int strands);

inline constexpr double kFramesPerSecond = 30;
inline constexpr int kStepsPerFrame = 2;
inline constexpr double kDrag = 2e-4;     // N s/m^2, per metre of hair
inline constexpr double kFriction = 0.2;  // Coulomb's mu of the head

// It waits for kSettle frames, in which hair settles; then it turns to one side and back within kMoving
// frames.
inline constexpr int kSettle = 15, kMoving = 30;
inline constexpr double kTurn = 60;  // degrees
Motion turn_of_head();

struct MovingHeadSettings {
  std::shared_ptr<const Bust> bust;
  bool collides = true;
};

class MovingHead {
 public:
  // `which` of the head's strands: ascending. With H1, H2 (for straight hair) and H4.
  MovingHead(const GrownHead& head, std::span<const std::size_t> which, const MovingHeadSettings& settings);

  // To the next frame; the CPU time that it took. Throws std::runtime_error if a strand breaks; passes on
  // what exercises throw.
  double advance();
  // Strand after strand, 3n numbers each, m; valid until the next advance().
  std::span<const double> points();

 private:
  SceneRun scene_run_;
  particles::State state_;
};

}  // namespace hair::head_study
