// STAFF ONLY. What whole runs cost, with the reference as the student: requests, messages and CPU time of each
// exercise's run, beside the CPU time of the same scene in one process.
//
//   run_costs [ROUNDS]
#include <stdlib.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include "grader/course/course.h"
#include "grader/judge/run/hidden_scene.h"
#include "grader/judge/run/student_play.h"
#include "hair/scene/playback.h"
#include "solver/timing.h"

namespace {

namespace fs = std::filesystem;
using namespace grader;

double play_in_one_process(const hair::Scene& scene) {
  const double start = timing::process_cpu_seconds();
  hair::Playback playback(scene);
  for (int frame = 0; frame < scene.frames; ++frame)
    if (playback.advance()) throw std::runtime_error("the reference breaks");
  return timing::process_cpu_seconds() - start;
}

struct Cost {
  int requests = 0;
  double messages = 0, megabytes = 0, suite = 0, worker = 0, idle = 0;
};

Cost cost_of(const Exercise& exercise, const hair::Scene& scene, const fs::path& log) {
  WorkerSetup setup;
  setup.kit = HAIR_KIT_DIR;
  setup.exercise = exercise.id;
  setup.provided = exercise.prerequisites;
  setup.objects = {setup.kit / "lib" / (exercise.id + ".so")};
  setup.log = log;
  setup.isolation = Isolation::none;
  const PlayFunction play = load_player(fs::path(HAIR_PLAYERS) / (exercise.id + ".so"));
  Student student(setup);
  Trial trial(student, Random("", ""));
  Cost cost;
  PlayResult result;
  const double start = timing::process_cpu_seconds();
  play(
      scene,
      [&](const MessageWriter& request, const Products& products) {
        ++cost.requests;
        return trial.ask(request, products);
      },
      result);
  cost.suite = timing::process_cpu_seconds() - start;
  student.finish();
  if (result.end != PlayEnd::finished) throw std::runtime_error(exercise.id + ": " + result.note);
  cost.worker = student.cpu_seconds();
  cost.messages = setup.allowance->spent.messages;
  cost.megabytes = setup.allowance->spent.megabytes;
  cost.idle = setup.allowance->spent.idle_seconds;
  return cost;
}

}  // namespace

int main(int argc, char* argv[]) {
  try {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 5;
    const fs::path log = fs::temp_directory_path() / "run-costs.log";
    std::printf(
        "| run of | requests | messages | MB | suite, CPU ms | worker, CPU ms | together | in one process, "
        "CPU "
        "ms | idle, ms |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    for (const Exercise& exercise :
         read_course(fs::path(HAIR_PROJECT) / "handout/exercises.json").exercises) {
      const fs::path file = fs::path(HAIR_HIDDEN_SCENES) / (exercise.id + ".json");
      if (!fs::exists(file)) continue;
      const hair::Scene scene = read_hidden_scene(file, "a").scene;
      Cost least;
      double alone = 0;
      for (int round = 0; round < rounds; ++round) {
        const Cost cost = cost_of(exercise, scene, log);
        if (round == 0 || cost.suite + cost.worker < least.suite + least.worker) least = cost;
        const double once = play_in_one_process(scene);
        alone = round == 0 ? once : std::min(alone, once);
      }
      std::printf("| %s | %d | %.0f | %.1f | %.0f | %.0f | %.0f | %.0f | %.0f |\n", exercise.id.c_str(),
                  least.requests, least.messages, least.megabytes, 1e3 * least.suite, 1e3 * least.worker,
                  1e3 * (least.suite + least.worker), 1e3 * alone, 1e3 * least.idle);
    }
    fs::remove(log);
    return 0;
  } catch (const CaseFailed& failure) {
    std::cerr << "run_costs: " << failure.feedback << "\n" << failure.detail << "\n";
  } catch (const std::exception& error) {
    std::cerr << "run_costs: " << error.what() << "\n";
  }
  return 1;
}
