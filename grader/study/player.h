// STAFF ONLY. Who plays a motion for a study, and by which clock: a worker, asked as for its end-to-end scenes.
//
// The clock is the kernel's, of all of the worker's threads, read by us after each answer. A play is charged with all
// that the worker took since the answer before: code can do its work earlier or later than it is asked to, for another
// play to be charged with it. It is told no time, and can hide none that it takes; but it can remember what it answered
// before, and then takes none.
#pragma once

#include <optional>
#include <string>

#include "grader/suite/end_to_end_scenes.h"
#include "grader/suite/played.h"
#include "grader/suite/student.h"

namespace grader {

struct Play {
  Played played;
  std::optional<double> seconds;  // CPU time of all times together; nothing: the worker is a new one
};

class Player {
 public:
  virtual ~Player() = default;
  // `scene` is what the text says. Throws CaseFailed or MalformedMessage.
  virtual Play play(const SceneText& text, const hair::Scene& scene, int times) = 0;
};

class WorkerPlayer : public Player {
 public:
  explicit WorkerPlayer(Student& student) : student_(student) {}
  Play play(const SceneText& text, const hair::Scene& scene, int times) override;

 private:
  Student& student_;
  int starts_ = 0;  // of its worker, when the clock was last read
  double clock_ = 0;
};

// Asks another, until that one times out, breaks the rules, crashes for the third time, or has taken so much time by the
// clock on the wall: then each play fails without being asked for.
class UntilItGivesUp : public Player {
 public:
  static constexpr int kMostCrashes = 3;

  UntilItGivesUp(Player& player, double most_wall_seconds) : player_(player), wall_left_(most_wall_seconds) {}
  Play play(const SceneText& text, const hair::Scene& scene, int times) override;

 private:
  Player& player_;
  double wall_left_;
  int crashes_ = 0;
  std::optional<CaseFailed> end_;
};

}  // namespace grader
