// STAFF ONLY. The whole run of an exercise: the suite runs a hidden scene from start to end, with the
// submission's functions for this exercise and the reference's for all others. Each call of the submission
// goes to a worker of its own, which holds the submission's object, provided prerequisites (provided.h), and
// nothing else. One category judges the run and its pictures.
//
// The run. It must end with finite numbers. It must start as the scene says, and held particles must
// stay where the reference has them. Energy and stretch, by our own forces, must agree with the
// reference's run within kEnergy and kStretch. Positions are not compared: correct solutions may differ
// by rounding, which a scene can amplify (measured in grader/MEASURED.md, with the mistakes that these
// bounds find). Dense hair (H10) is made anew in each frame from the reference's guides: nothing amplifies
// its rounding, and its points are compared.
//
// Its pictures. We draw a few frames of the submission and of the reference. The RMSE of the blurred pictures
// and the mean FLIP must each be below a limit (compare.h).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/judge/cases/suite_table.h"
#include "grader/judge/cases/trial.h"
#include "grader/judge/run/run_comparison.h"
#include "grader/result/result.h"
#include "hair/scene/scene.h"

namespace grader::inline judge {

// The scene of an exercise's whole run: reference/H1/scene.json for H1, with small variations by a seed, so
// that its result is not predictable. The seed is the same for a class, so that pictures can be compared.
//
//   {"canary": "STAFF ONLY: ...",
//    "scene": SCENE,                              as hair/scenes/README.md describes it
//    "vary": {"/toys/0/start/2/x": 0.05, ...},    numbers of SCENE, with the largest variation of each
//    "pictures": [10, 20, 30]}                    frames to draw
struct HiddenScene {
  std::string text;  // is sent to the worker
  hair::Scene scene;
  std::vector<int> pictures;
};

// Throws BadInput for a file in another format.
HiddenScene read_hidden_scene(const std::filesystem::path& file, const std::string& seed);

// Limits the error of held particles, relative to the scene's size: the rounding of their motion.
inline constexpr double kHeld = 1e-9;
// Limits the difference of energies at a moment, relative to the largest kinetic energy of the reference's
// run.
inline constexpr double kEnergy = 0.01;
// Limits the stretch: the larger of kStretch times the reference's and kLeastStretch.
inline constexpr double kStretch = 1.5;
inline constexpr double kLeastStretch = 1e-4;
// Limits the distance of a point of dense hair from ours, relative to the scene's size. Most of the distance
// that H10's contract allows is from weights: roots that are off by 1e-10 of a triangle's longest edge change
// each of three weights by 1e-9 if its height is a tenth of that, as in the hidden scene; guides differ by
// less than the scene's size.
inline constexpr double kDense = 1e-8;

// Right runs send 50,000 messages at most. A solver that does not converge asks for products without end:
// that is a wrong answer, not a slow one, whichever limit it meets first.
inline constexpr double kManyMessages = 100'000;

class WholeRun {
 public:
  // `worker` answers for the exercise as in its cases, and `runner` runs the scene with it
  // (grader/judge/run/play.h). The reference's pictures are stored in `kept_pictures`; without it no pictures
  // are drawn. `cases` is the worker of the exercise's other cases: it ends first, and if the suite gave up
  // on it, there is no whole run.
  WholeRun(WorkerSetup worker, std::filesystem::path runner, HiddenScene scene,
           std::optional<std::filesystem::path> kept_pictures, Student& cases);

  Category category(const std::string& exercise);

  Student& student() { return student_; }
  const std::vector<PictureResult>& pictures() const { return pictures_; }
  const RunMotions& motions() const { return motions_; }
  double picture_seconds() const { return picture_seconds_; }  // is CPU time

 private:
  void judge(Trial& trial);
  Played play(Trial& trial);
  Played play_unless_given_up(Trial& trial);
  void draw(const RunComparison& run);
  void judge_run(Trial& trial, const RunComparison& run, const std::string& trouble) const;
  void judge_pictures(Trial& trial) const;

  Student student_;
  std::filesystem::path runner_;
  HiddenScene hidden_;
  std::optional<std::filesystem::path> kept_pictures_;
  Student& cases_;
  std::vector<PictureResult> pictures_;
  RunMotions motions_;
  double picture_seconds_ = 0;
};

}  // namespace grader::judge
