// STAFF ONLY. Compares steps of strands with the program of written_down.cpp, and prints Markdown. It fails
// if a step costs more than its limit allows, or moves the strand elsewhere.
#include <algorithm>
#include <cstdio>

#include "hair/lab/study/written_down.h"
#include "hair/simulation/models.h"
#include "hair/simulation/simulation.h"
#include "solver/timing.h"

namespace {

using namespace hair;

constexpr int kRounds = 9;

struct Case {
  const char* method;  // an id of study_methods.cpp
  double step;         // s
  int steps_per_moment;
  double limit;
};
// Explicit steps call H1 and H2, which both measure each segment: the program measures it once.
constexpr Case kCases[] = {{"h4-filtered", 1.0 / 240, 3, 5},
                           {"h6", 1.0 / 240, 2, 5},
                           {"symplectic-euler", 1e-6, 200, 1.5},
                           {"runge-kutta-4", 1e-6, 60, 1.5}};

Problem swing(double bend_factor, double duration) {
  StrandSpec spec;
  spec.elements = 15;
  spec.length = 0.15;
  spec.root.axis = Vector3d::UnitX();
  spec.root.side = -Vector3d::UnitY();
  spec.fibre.bend_factor = bend_factor;
  spec.clamped = true;
  Problem problem;
  problem.scene.frames = kMoments;
  problem.scene.hair.strands = {discretise(spec)};
  problem.duration = duration;
  return problem;
}

// The CPU time of the steps, and the strand's positions after them.
WrittenRun played(const Problem& problem, const StudyMethod& method, int steps_per_moment, bool watched) {
  Description description = with_method(problem, method, steps_per_moment).hair;
  description.watched = watched;
  Simulation simulation(std::move(description));
  const double begin = timing::cpu_seconds();
  simulation.advance(kMoments * steps_per_moment);
  WrittenRun run{timing::cpu_seconds() - begin, Eigen::VectorXd(simulation.body(0).size())};
  Eigen::VectorXd v(run.x.size());
  simulation.body(0).read(run.x, v);
  return run;
}

}  // namespace

int main() {
  bool holds = true;
  std::printf(
      "| ns a segment and step | written down | hairlab | ratio | watched | at most |\n"
      "|---|--:|--:|--:|--:|--:|\n");
  for (const double bend_factor : {1.0, 0.0})
    for (const Case& one : kCases) {
      const Problem problem = swing(bend_factor, one.step * one.steps_per_moment * kMoments);
      const std::vector<StudyMethod> methods = methods_for(problem);
      const StudyMethod& method = *std::ranges::find(methods, one.method, &StudyMethod::id);
      std::vector<double> written, plain, ratios, watched;
      double off = 0;
      for (int round = 0; round < kRounds; ++round) {
        const WrittenRun here = played(problem, method, one.steps_per_moment, false),
                         other = *run_written_down(problem, method, one.steps_per_moment);
        plain.push_back(here.seconds);
        written.push_back(other.seconds);
        ratios.push_back(here.seconds / other.seconds);
        watched.push_back(played(problem, method, one.steps_per_moment, true).seconds / other.seconds);
        off = (here.x - other.x).norm();
      }
      const double ns = 1e9 / (15.0 * kMoments * one.steps_per_moment), ratio = timing::median(ratios);
      std::printf("| %s%s | %.1f | %.1f | %.2f | %.2f | %.1f |\n", method.name.c_str(),
                  bend_factor > 0 ? "" : ", no bending", ns * timing::median(written),
                  ns * timing::median(plain), ratio, timing::median(watched), one.limit);
      holds = holds && ratio <= one.limit && off <= 1e-7;
    }
  return holds ? 0 : 1;
}
