// STAFF ONLY. Makes the handout's file of a scene's run by the reference: make_motion SCENE.json OUT.json
// [POINTS]. It has only positions, and only a part of many strands: at most POINTS points in all frames
// together (hair/view/motion.h). hairlab's page plays it.
#include <cstdio>
#include <exception>
#include <iostream>

#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/files/write_file.h"
#include "hair/lab/run/motion_of_run.h"
#include "hair/lab/run/run.h"

namespace {

// The scene with as many strands of dense hair as the page shows.
hair::Scene thinned(hair::Scene scene, std::size_t most_points) {
  const std::size_t most = most_points / static_cast<std::size_t>(scene.frames + 1);
  for (hair::DenseHair& dense : scene.dense) {
    auto& children = dense.description.children;
    const std::size_t every = children.size() * static_cast<std::size_t>(dense.description.points) / most + 1;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < children.size(); i += every) children[kept++] = children[i];
    children.resize(kept);
  }
  return scene;
}

}  // namespace

int main(int count, char** arguments) try {
  if (count != 3 && count != 4) {
    std::fprintf(stderr, "make_motion SCENE.json OUT.json [POINTS]\n");
    return 2;
  }
  const std::size_t most_points = count == 4 ? std::stoul(arguments[3]) : hair::kMostPointsShipped;
  const hair::TemporaryFolder folder("make-motion");
  const hair::Scene scene = thinned(hair::read_scene(arguments[1]), most_points);
  const std::filesystem::path run = folder.path() / "run";
  hair::RunSettings settings;
  settings.out = run;
  settings.render = false;
  settings.draws = settings.only_shown = true;
  settings.most_points = most_points;
  std::ostream no_notes(nullptr);
  const hair::RunResult played = hair::run_scene(scene, settings, false, no_notes, nullptr);
  if (played.record.ending != hair::Ending::finished)
    throw std::runtime_error(scene.name + " broke: " + played.record.blow_up);
  hair::write_file(arguments[2], hair::bytes_of(run / hair::kMotionFile));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "make_motion: %s\n", error.what());
  return 1;
}
