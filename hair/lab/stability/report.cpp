#include "hair/lab/stability/report.h"

#include <algorithm>
#include <cmath>

#include "hair/io/files/bad_input.h"
#include "solver/timing.h"

namespace hair {

namespace {

Problem problem_of(const Scene& scene, const StabilitySettings& settings) {
  if (scene.hair.strands.empty() && scene.hair.modelled.empty())
    throw BadInput(scene.name + ": it has no hair; stability maps are of a strand that hangs");
  Scene bare = scene;  // the surroundings of hanging hair have no effect
  bare.hair.obstacles.clear();
  bare.riders.clear();
  for (StrandStart& start : bare.hair.strands) start.rest_curvature.resize(0);
  ProblemSettings one;
  one.strand = settings.strand;
  one.segments = settings.segments;
  const std::optional<int> own = segments_to_divide(bare, settings.strand);
  if (!one.segments && own) one.segments = std::min(std::max(*own, 1), kMapSegments);
  return make_problem(bare, one);
}

Frequencies frequencies_of(const Description& hair) {
  const Hanging hanging = hang(hair, 1, false);
  return {hanging.along_modes.omega.maxCoeff(), hanging.across_modes.omega.maxCoeff(),
          fastest_by_tension(hair, hanging)};
}

}  // namespace

MapSettings quick_maps() {
  return {32, 32, 2000, 48};
}

StabilityReport study_stability(const Scene& scene, const StabilitySettings& settings,
                                const std::atomic<bool>& interrupted, const Tell& tell) {
  const double start = timing::cpu_seconds();
  const Problem problem = problem_of(scene, settings);
  const Description& hair = problem.scene.hair;
  StabilityReport report;
  report.scene = scene.name;
  report.drag = hair.drag;
  const StrandStart& original = scene.hair.strands[static_cast<std::size_t>(settings.strand)];
  const Strand& strand = hair.strands[0].strand;
  report.segments = strand.segments();
  report.scene_segments = original.strand.segments();
  report.length = strand.rest_length.sum();
  report.EA = strand.stretch_rigidity;
  report.EI = strand.bend_rigidity;
  report.mass = strand.mass.sum();
  report.was_curved = original.rest_curvature.size() > 0;

  // Methods that make the same matrix of this hair share a map.
  std::vector<StudyMethod> methods;
  std::vector<std::vector<StudyMethod>> alike;
  const auto leave_out = [&](const StudyMethod& method, const std::exception& error,
                             const std::optional<NotImplemented>& stub) {
    if (std::none_of(report.left_out.begin(), report.left_out.end(),
                     [&](const LeftOut& one) { return one.method.id == method.id; }))
      report.left_out.push_back({method, error.what(), stub});
  };
  // An exception of an exercise costs only the methods that call it.
  const auto guarded = [&](const StudyMethod& method, const auto& work) {
    try {
      work();
      return true;
    } catch (const BadInput&) {
      throw;
    } catch (const NotImplemented& stub) {
      leave_out(method, stub, stub);
    } catch (const std::exception& error) {
      leave_out(method, error, {});
    }
    return false;
  };
  std::vector<StudyMethod> all = methods_for(problem, settings.absent);
  // The way of solving does not change where a method breaks.
  std::erase_if(all, [](const StudyMethod& method) { return !method.preconditioner; });
  for (const StudyMethod& method : all) {
    guarded(method, [&] {
      for (std::size_t i = 0; i < methods.size(); ++i)
        if (alike_when_hanging(hair, methods[i], method)) {
          alike[i].push_back(method);
          return;
        }
      methods.push_back(method);
      alike.emplace_back();
    });
  }
  report.maps_asked = static_cast<int>(2 * methods.size());
  if (!methods.empty())
    guarded(methods[0], [&] { report.frequencies = frequencies_of(with_options(hair, methods[0])); });

  int maps = 0;
  for (std::size_t i = 0; i < methods.size() && !interrupted; ++i)
    for (const Swept sweep : {Swept::stiffness, Swept::drag}) {
      const std::string what = "map " + std::to_string(++maps) + " of " + std::to_string(report.maps_asked) +
                               ": " + methods[i].name +
                               (sweep == Swept::stiffness ? ", stiffness" : ", drag");
      const bool went = guarded(methods[i], [&] {
        StabilityMap map = make_map(hair, methods[i], sweep, settings.maps, interrupted, [&](long runs) {
          if (runs % 10 == 1) tell(what + ": " + std::to_string(runs) + " runs");
        });
        map.alike = alike[i];
        if (map.grid.complete) report.maps.push_back(std::move(map));
      });
      if (!went || interrupted) break;
    }
  for (const StudyMethod& method : all) {
    if (interrupted) break;
    tell("extreme cases: " + method.name);
    guarded(method, [&] {
      for (ExtremeRun& run : run_extremes(hair, method, interrupted))
        report.extremes.push_back(std::move(run));
    });
  }
  report.interrupted = interrupted;
  report.cpu_seconds = timing::cpu_seconds() - start;
  return report;
}

}  // namespace hair
