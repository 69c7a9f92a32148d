// STAFF ONLY. What the scores of whole runs tell apart, as Markdown: each exercise's hidden scene, played by
// the reference as it is, by the reference as another compiler has it (target `other_objects`, if it was
// built), and with a small difference.
//
//   picture_scores [SEED...]
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "grader/course/course.h"
#include "grader/judge/run/play_scene.h"
#include "grader/judge/run/student_play.h"
#include "grader/judge/run/whole_run.h"
#include "solver/timing.h"

namespace {

namespace fs = std::filesystem;
using namespace grader;

Played play(const hair::Scene& scene) {
  Played played;
  play_scene(scene, played);
  return played;
}

std::vector<std::string> other_compilers() {
  std::vector<std::string> names;
  if (fs::exists(HAIR_OTHER_OBJECTS))
    for (const fs::directory_entry& folder : fs::directory_iterator(HAIR_OTHER_OBJECTS))
      names.push_back(folder.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

// By a worker, as a submission's object for `exercise` is played.
Played play_object(const Exercise& exercise, const fs::path& object, const HiddenScene& hidden) {
  WorkerSetup setup;
  setup.kit = HAIR_KIT_DIR;
  setup.exercise = exercise.id;
  setup.provided = exercise.prerequisites;
  setup.objects = {object};
  setup.log = fs::path(HAIR_KEPT) / "worker.log";
  setup.isolation = Isolation::none;
  setup.cpu_seconds = 100;  // what is not optimised takes its time
  Student student(setup);
  Trial trial(student, Random("", ""));
  return play_with_student(trial, fs::path(HAIR_PLAYERS) / (exercise.id + ".so"), hidden.scene);
}

// Every number of the start moved by a few roundings: what another order of summation does, many times over.
hair::Scene with_other_roundings(hair::Scene scene) {
  Random random("", "roundings");
  const auto move = [&](Eigen::VectorXd& x) {
    const double size = x.cwiseAbs().maxCoeff();
    for (double& entry : x) entry += 1e-13 * size * random.uniform(-1, 1);
  };
  for (hair::StrandStart& start : scene.hair.strands) move(start.state.x);
  for (hair::Toy& toy : scene.toys) move(toy.start.x);
  return scene;
}

hair::Scene with_gravity_times(double factor, hair::Scene scene) {
  scene.hair.gravity *= factor;
  for (hair::Toy& toy : scene.toys) toy.gravity *= factor;
  return scene;
}

void print_row(const char* exercise, const std::string& difference, const RunComparison& run,
               const std::vector<PictureResult>& pictures) {
  double energy = 0, stretch = 0, apart = 0, blurred = 0, flip = 0;
  for (const Moment& moment : run.moments) {
    energy = std::max(energy, std::abs(moment.theirs.energy() - moment.ours.energy()) / run.kinetic);
    stretch = std::max(stretch, moment.theirs.stretch / std::max(moment.ours.stretch, kLeastStretch));
    apart = std::max({apart, moment.apart / run.size, moment.dense_apart / run.size});
  }
  for (const PictureResult& picture : pictures) {
    blurred = std::max(blurred, picture.blurred_rmse);
    flip = std::max(flip, picture.flip);
  }
  std::printf("| %s | %s | %.1e | %.1e | %.3f | %.5f | %.5f |\n", exercise, difference.c_str(), apart, energy,
              stretch, blurred, flip);
}

void print_scene(const Exercise& exercise, const HiddenScene& hidden, const fs::path& kept) {
  const auto row = [&](const std::string& difference, const Played& played, std::size_t without = 1000) {
    RunComparison run = compare_runs(hidden.scene, hidden.pictures, played);
    for (Shot& shot : run.shots) {
      shot.same = false;
      if (without < shot.student.strands.sizes.size()) {
        hair::StrandsDrawing& strands = shot.student.strands;
        int before = 0;
        for (std::size_t i = 0; i < without; ++i) before += strands.sizes[i];
        strands.points.erase(strands.points.begin() + before,
                             strands.points.begin() + before + strands.sizes[without]);
        strands.sizes.erase(strands.sizes.begin() + static_cast<std::ptrdiff_t>(without));
      }
    }
    print_row(exercise.id.c_str(), difference, run, draw_shots(run.shots, run.camera, kept));
  };
  const double start = timing::cpu_seconds();
  const Played right = play(hidden.scene);
  std::printf("| %s | %s, %.3f s of CPU time | | | | | |\n", exercise.id.c_str(), hidden.scene.shows.c_str(),
              timing::cpu_seconds() - start);
  for (const std::string& compiler : other_compilers()) {
    const fs::path object = fs::path(HAIR_OTHER_OBJECTS) / compiler / (exercise.id + ".so");
    if (fs::exists(object)) row(compiler, play_object(exercise, object, hidden));
  }
  row("the start moved by 1e-13", play(with_other_roundings(hidden.scene)));
  row("gravity 1 % larger", play(with_gravity_times(1.01, hidden.scene)));
  if (!hidden.scene.hair.strands.empty())
    row("one strand of " + std::to_string(hidden.scene.hair.strands.size()) + " missing", right,
        hidden.scene.hair.strands.size() / 2);
}

}  // namespace

int main(int argc, char* argv[]) {
  try {
    std::vector<std::string> seeds(argv + 1, argv + argc);
    if (seeds.empty()) seeds = {"a", "b", "c"};
    std::printf(
        "| scene | difference | particles, of its size | energy, of the kinetic | stretch, of ours | blurred "
        "RMSE | "
        "FLIP |\n");
    std::printf("|---|---|--:|--:|--:|--:|--:|\n");
    const std::vector<Exercise> course =
        read_course(fs::path(HAIR_PROJECT) / "handout/exercises.json").exercises;
    fs::create_directories(HAIR_KEPT);
    for (const Exercise& exercise : course) {
      const fs::path file = fs::path(HAIR_HIDDEN_SCENES) / (exercise.id + ".json");
      if (!fs::exists(file)) continue;
      for (const std::string& seed : seeds) {
        const fs::path kept = fs::path(HAIR_KEPT) / (exercise.id + "-" + seed);
        fs::remove_all(kept);
        print_scene(exercise, read_hidden_scene(file, seed), kept);
      }
    }
    return 0;
  } catch (const CaseFailed& failure) {
    std::cerr << "picture_scores: " << failure.feedback << "\n" << failure.detail << "\n";
    return 1;
  } catch (const std::exception& error) {
    std::cerr << "picture_scores: " << error.what() << "\n";
    return 1;
  }
}
