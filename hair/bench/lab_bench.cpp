// What a frame of hairlab costs, as tables:
//
//   lab_bench pipeline    by number of strands and stage
//   lab_bench parts       what each part that is left out saves
//   lab_bench beside      a scene without bending, obstacles and pictures, beside a program written for just that
//
// Human hair in 15 segments of 1 cm on the upper half of a head of 10 cm.
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "hair/bench/plain_program.h"
#include "hair/lab/run/run.h"
#include "hair/scene/playback.h"
#include "hair/strand/make_strand.h"
#include "hair/strand/rest_shape.h"
#include "solver/timing.h"

namespace {

using namespace hair;

constexpr int kSegments = 15;
constexpr double kHead = 0.1;  // m

Scene hair_on_head(int strands, Method method = Method::predictor_corrector) {
  Scene scene;
  scene.name = "bench";
  scene.shows = "hair on a head";
  scene.hair.method = method;
  scene.hair.step = 1.0 / 240;
  for (int i = 0; i < strands; ++i) {
    // Turned by the golden angle from one to the next, at equal steps of height: even on a sphere.
    const double z = (i + 0.5) / strands, angle = i * 2.399963229728653, flat = std::sqrt(1 - z * z);
    const Vector3d out(flat * std::cos(angle), flat * std::sin(angle), z);
    const auto x = straight_shape(kSegments, 0.01 * kSegments, {kHead * out, out, out.unitOrthogonal()}).x;
    scene.hair.strands.push_back({strand_from_rest({}, x), {x, Eigen::VectorXd::Zero(x.size())}});
  }
  return scene;
}

// A run's seconds for a frame, from the fastest of `runs` runs.
struct FrameSeconds {
  Seconds stages;
  double all = 0;
};

FrameSeconds time_frames(const Scene& scene, int frames, int runs) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("lab_bench-" + std::to_string(std::time(nullptr)));
  const std::atomic<bool> interrupted = false;
  FrameSeconds best{{}, INFINITY};
  for (int k = 0; k < runs; ++k) {
    const RunResult result = run_scene(scene, {folder, frames, true}, interrupted, std::cerr, nullptr);
    Seconds s = result.record.seconds;
    s.simulate /= frames;
    for (double* stage : {&s.measure, &s.write, &s.upload, &s.shadow, &s.draw, &s.read_back, &s.png, &s.film})
      *stage /= frames + 1;
    const double all =
        s.simulate + s.measure + s.write + s.upload + s.shadow + s.draw + s.read_back + s.png + s.film;
    if (all < best.all) best = {s, all};
  }
  std::filesystem::remove_all(folder);
  return best;
}

void pipeline() {
  std::puts("ms a frame, 8 steps of H6 each, pictures of 1280 x 720\n");
  std::puts(
      "| strands | simulate | measure | write | upload | shadow | draw | read back | PNG | film | frames/s "
      "|");
  std::puts("|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
  struct Row {
    int strands, frames, runs;
  };
  for (const Row row : {Row{1, 20, 3}, Row{100, 10, 3}, Row{1000, 5, 2}, Row{10'000, 2, 1}}) {
    Scene scene = hair_on_head(row.strands);
    scene.look.emplace();
    const FrameSeconds f = time_frames(scene, row.frames, row.runs);
    const Seconds& s = f.stages;
    std::printf("| %d | %.2f | %.2f | %.2f | %.2f | %.1f | %.1f | %.1f | %.1f | %.1f | %.2g |\n", row.strands,
                1e3 * s.simulate, 1e3 * s.measure, 1e3 * s.write, 1e3 * s.upload, 1e3 * s.shadow,
                1e3 * s.draw, 1e3 * s.read_back, 1e3 * s.png, 1e3 * s.film, 1 / f.all);
    std::fflush(stdout);
  }
}

void parts() {
  constexpr int kStrands = 100, kFrames = 10, kRuns = 3;
  Scene all = hair_on_head(kStrands);
  all.look.emplace();
  all.hair.obstacles.push_back({Sphere{Vector3d::Zero(), kHead}, 0.3});
  all.hair.drag = 1e-5;
  all.hair.wind = Vector3d(1, 0, 0);
  Scene without_bending = all, without_obstacles = all, without_drag = all, without_gravity = all,
        without_shadows = all, without_pictures = all;
  for (StrandStart& start : without_bending.hair.strands) start.strand.bend_rigidity = 0;
  without_obstacles.hair.obstacles.clear();
  without_drag.hair.drag = 0;
  without_gravity.hair.gravity.setZero();
  without_shadows.look->shadows = false;
  without_pictures.look.reset();

  std::puts("ms a frame: 100 strands, 8 steps of H6, one picture of 1280 x 720\n");
  std::puts("| scene | simulate | pictures | all | saved |");
  std::puts("|---|--:|--:|--:|--:|");
  double with_all = 0;
  const auto row = [&](const char* name, const Scene& scene) {
    const FrameSeconds f = time_frames(scene, kFrames, kRuns);
    const Seconds& s = f.stages;
    if (with_all == 0) with_all = f.all;
    std::printf("| %s | %.1f | %.1f | %.1f | %.0f %% |\n", name, 1e3 * s.simulate,
                1e3 * (s.upload + s.shadow + s.draw + s.read_back + s.png + s.film), 1e3 * f.all,
                100 * (1 - f.all / with_all));
    std::fflush(stdout);
  };
  row("with all parts", all);
  row("no bending", without_bending);
  row("no obstacles", without_obstacles);
  row("no drag, no wind", without_drag);
  row("no gravity", without_gravity);
  row("no shadows", without_shadows);
  row("no pictures", without_pictures);
}

// Turn by turn, so that what else the machine does meets both.
void beside() {
  constexpr int kTurns = 61;
  struct Row {
    const char* name;
    Method method;
    int strands;
    double step;
    int steps_per_frame, frames_a_turn;
  };
  std::puts("CPU time, ns for a particle's step; the ratio is the median of 61 turns\n");
  std::puts("| method | strands | plain program | scene | ratio | middle half of the ratios |");
  std::puts("|---|--:|--:|--:|--:|--:|");
  for (const Row& row : {Row{"symplectic Euler", Method::symplectic_euler, 1, 1e-6, 1000, 4},
                         Row{"symplectic Euler", Method::symplectic_euler, 100, 1e-6, 40, 1},
                         Row{"RK4", Method::runge_kutta_4, 1, 1e-6, 500, 2},
                         Row{"RK4", Method::runge_kutta_4, 100, 1e-6, 10, 1},
                         Row{"H4", Method::implicit_euler, 1, 1.0 / 240, 8, 2},
                         Row{"H4", Method::implicit_euler, 100, 1.0 / 240, 1, 1},
                         Row{"H6", Method::predictor_corrector, 1, 1.0 / 240, 8, 2},
                         Row{"H6", Method::predictor_corrector, 100, 1.0 / 240, 1, 1}}) {
    Scene scene = hair_on_head(row.strands, row.method);
    for (StrandStart& start : scene.hair.strands) start.strand.bend_rigidity = 0;
    scene.hair.step = row.step;
    scene.steps_per_frame = row.steps_per_frame;
    scene.frames_per_second = 1 / (row.step * row.steps_per_frame);
    Playback playback(scene);
    hair_bench::PlainProgram plain(scene.hair);

    std::vector<double> plains, scenes, ratios;
    for (int turn = 0; turn < kTurns; ++turn) {
      double times[2];
      for (const int who : {turn % 2, 1 - turn % 2}) {
        const double start = timing::cpu_seconds();
        if (who == 0)
          plain.steps(row.frames_a_turn * row.steps_per_frame);
        else
          for (int k = 0; k < row.frames_a_turn; ++k) playback.advance();
        times[who] = timing::cpu_seconds() - start;
      }
      const double particle_steps =
          static_cast<double>(row.frames_a_turn) * row.steps_per_frame * row.strands * (kSegments + 1);
      plains.push_back(1e9 * times[0] / particle_steps);
      scenes.push_back(1e9 * times[1] / particle_steps);
      ratios.push_back(times[1] / times[0]);
    }
    const particles::State state = playback.state();
    bool same = true;
    for (int i = 0; i < row.strands; ++i)
      same = same && state.x.segment(3 * (kSegments + 1) * i, 3 * (kSegments + 1)) == plain.state(i).x;
    if (!same) std::puts("these two don't do the same:");
    std::sort(ratios.begin(), ratios.end());
    std::printf("| %s | %d | %.1f | %.1f | %.3f | %.3f to %.3f |\n", row.name, row.strands,
                timing::median(plains), timing::median(scenes), ratios[kTurns / 2], ratios[kTurns / 4],
                ratios[3 * kTurns / 4]);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char* argv[]) {
  const std::string what = argc == 2 ? argv[1] : "";
  if (what == "pipeline")
    pipeline();
  else if (what == "parts")
    parts();
  else if (what == "beside")
    beside();
  else {
    std::cerr << "lab_bench: give one of pipeline, parts, beside\n";
    return 2;
  }
  return 0;
}
