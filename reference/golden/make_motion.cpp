// STAFF ONLY. Makes the handout's file of a scene's run by the reference: make_motion SCENE.json OUT.json
// [POINTS [SHOWS]]. It has only positions, and only a part of many strands: at most POINTS points in all
// frames together (hair/view/motion.h). hairlab's page plays it. SHOWS tells of a mistake, which may break
// the run: OUT.json holds the right run, and gets both, as a list. OUT/ is for a run with small pictures.
#include <cstdio>
#include <exception>
#include <iostream>

#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/files/write_file.h"
#include "hair/lab/run/motion_of_run.h"
#include "hair/lab/run/run.h"

namespace {

// The right run has the solids.
std::string without_meshes(std::string motion) {
  const auto at = motion.find("\"meshes\":[");
  if (at != std::string::npos) motion.erase(at + 10, motion.find("],\"planes\"") - at - 10);
  return motion;
}

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
  if (count < 3 || count > 5) {
    std::fprintf(stderr, "make_motion SCENE.json OUT.json [POINTS [SHOWS]]\n");
    return 2;
  }
  const std::size_t most_points = count > 3 ? std::stoul(arguments[3]) : hair::kMostPointsShipped;
  const hair::TemporaryFolder folder("make-motion");
  const std::filesystem::path out = arguments[2];
  const bool pictures = !out.has_filename();
  hair::Scene scene = hair::read_scene(arguments[1]);
  if (!pictures) scene = thinned(std::move(scene), most_points);
  if (pictures && scene.look) scene.look->image_width = 240, scene.look->image_height = 180;
  if (count == 5) scene.shows = arguments[4];
  const std::filesystem::path run = pictures ? out.parent_path() : folder.path() / "run";
  hair::RunSettings settings;
  settings.out = run;
  settings.render = pictures;
  settings.for_page = !pictures;
  settings.most_points = most_points;
  std::ostream no_notes(nullptr);
  const hair::RunResult played = hair::run_scene(scene, settings, false, no_notes, nullptr);
  if (count < 5 && played.record.ending != hair::Ending::finished)
    throw std::runtime_error(scene.name + " broke: " + played.record.blow_up);
  if (pictures) return 0;
  const std::string motion = hair::bytes_of(run / hair::kMotionFile);
  hair::write_file(out,
                   count == 5 ? "[" + hair::bytes_of(out) + "," + without_meshes(motion) + "]\n" : motion);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "make_motion: %s\n", error.what());
  return 1;
}
