// STAFF ONLY.
#include "grader/study/player.h"

namespace grader {

Play WorkerPlayer::play(const SceneText& text, const hair::Scene& scene, int times) {
  Trial trial(student_, Random("", text.name));
  trial.describe(text.name);
  Play play;
  play.played = play_elsewhere(trial, text.json, scene, times);
  const double now = student_.worker_cpu_seconds().value_or(0);
  if (starts_ == student_.starts() && now > clock_) play.seconds = now - clock_;
  starts_ = student_.starts();
  clock_ = now;
  return play;
}

}  // namespace grader
