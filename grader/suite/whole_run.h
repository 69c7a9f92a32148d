// STAFF ONLY. The whole run of an exercise: a worker with the submission's file for it, and the reference's
// for all others that are called, plays a hidden scene from its beginning to its end. Two categories judge
// what comes of it.
//
// The run. It ends, with numbers. It starts where the scene says, and what is held stays where the reference
// has it. Energy and stretch, by our own forces, are what the reference's run has, give or take what kEnergy
// and kStretch allow. Nobody's positions are asked for: right solutions may be apart by rounding, which a
// scene lets grow, if little; how little, and what these bounds tell apart, is measured (grader/README.md,
// "Whole runs").
//
// Its pictures. A few frames, the submission's and the reference's, drawn by us: RMSE of the blurred pictures
// and mean FLIP, each below a threshold.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/report/result.h"
#include "grader/suite/hidden_scene.h"
#include "grader/suite/run_comparison.h"
#include "grader/suite/suite_table.h"
#include "grader/suite/trial.h"

namespace grader {

// What is held may be off by this part of the scene's size: the rounding of its motion.
inline constexpr double kHeld = 1e-9;
// The largest difference of energies at a moment, as a part of the largest kinetic energy of the reference's
// run.
inline constexpr double kEnergy = 0.01;
// The largest stretch may be this many times the reference's, or kLeastStretch.
inline constexpr double kStretch = 1.5;
inline constexpr double kLeastStretch = 1e-4;
// Of pictures.
inline constexpr double kBlurredRmse = 0.0005, kFlip = 0.001;

inline constexpr const char* kRunTitle = "The whole run";
inline constexpr const char* kPicturesTitle = "Pictures of it";

// Who plays the scene: as `cases` answers for the exercise's other cases, with its own object, which is the
// last, and for all other exercises, of which `exercises` is the order, the reference's, or stubs where the
// scene calls none.
WorkerSetup whole_run_worker(const WorkerSetup& cases, const hair::Scene& scene,
                             const std::vector<std::string>& exercises);

class WholeRun {
 public:
  // The reference's pictures are kept in `kept_pictures`; without it none are drawn. `cases` is who answers
  // for the exercise's other cases: one whose worker the suite gave up on is not asked again.
  WholeRun(WorkerSetup worker, HiddenScene scene, std::optional<std::filesystem::path> kept_pictures,
           const Student& cases);

  // In the order in which they are run.
  std::vector<Category> categories(const std::string& exercise);

  Student& student() { return student_; }
  const std::vector<PictureResult>& pictures() const { return pictures_; }
  double picture_seconds() const { return picture_seconds_; }  // of CPU time

 private:
  void judge_run(Trial& trial);
  void judge_pictures(Trial& trial);

  Student student_;
  HiddenScene hidden_;
  std::optional<std::filesystem::path> kept_pictures_;
  const Student& cases_;
  std::optional<RunComparison> run_;  // once it was played
  std::vector<PictureResult> pictures_;
  double picture_seconds_ = 0;
};

}  // namespace grader
