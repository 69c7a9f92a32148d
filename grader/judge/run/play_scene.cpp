// STAFF ONLY. Runs a scene and keeps its frames.
#include "grader/judge/run/play_scene.h"

#include "grader/judge/run/dense_strands.h"
#include "hair/scene/scene_run.h"

namespace grader::inline judge {

void play_scene(const hair::Scene& scene, Played& played) {
  hair::Scene unwatched = scene;  // students need not have written energies
  unwatched.hair.watched = false;
  hair::SceneRun scene_run(unwatched);
  DenseStrands dense(scene, scene_run.strands());
  const auto keep = [&] {
    played.frames.push_back(scene_run.state());
    if (!scene.dense.empty())
      played.dense.push_back(dense.at(scene_run.centre_lines(played.frames.back()).x, scene_run.time()));
  };
  keep();
  for (int k = 0; k < scene.frames && played.trouble.empty(); ++k) {
    played.trouble = scene_run.advance().value_or("");
    if (played.trouble.empty()) keep();
  }
  const hair::Work work = scene_run.work();
  played.solver_steps = work.solver_steps;
  played.correction_steps = work.correction_steps;
}

}  // namespace grader::judge
