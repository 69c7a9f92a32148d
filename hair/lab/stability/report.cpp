#include "hair/lab/stability/report.h"

#include <algorithm>

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

  // An exception of an exercise costs only the methods that call it.
  const auto guarded = [&](const StudyMethod& method, const auto& work) {
    LeftOut left_out{method, {}};
    try {
      work();
      return true;
    } catch (const BadInput&) {
      throw;
    } catch (const NotImplemented& stub) {
      left_out.stub = stub;
      left_out.why = stub.what();
    } catch (const std::exception& error) {
      left_out.why = error.what();
    }
    if (std::ranges::none_of(report.left_out, [&](const LeftOut& one) { return one.method.id == method.id; }))
      report.left_out.push_back(left_out);
    return false;
  };
  std::vector<StudyMethod> all = methods_for(problem, settings.absent);
  // The way of solving does not change where a method breaks.
  std::erase_if(all, [](const StudyMethod& method) { return !method.preconditioner; });
  // Methods that make the same matrix of this hair share a map.
  std::vector<std::vector<StudyMethod>> groups;
  for (const StudyMethod& method : all)
    guarded(method, [&] {
      for (std::vector<StudyMethod>& group : groups)
        if (alike_when_hanging(hair, group[0], method)) return group.push_back(method);
      groups.push_back({method});
    });
  report.maps_asked = static_cast<int>(2 * groups.size());
  if (!groups.empty())
    guarded(groups[0][0], [&] { report.frequencies = frequencies_of(with_options(hair, groups[0][0])); });

  int maps = 0;
  for (const std::vector<StudyMethod>& group : groups)
    for (const Swept sweep : {Swept::stiffness, Swept::drag}) {
      if (interrupted) break;
      const std::string what = "map " + std::to_string(++maps) + " of " + std::to_string(report.maps_asked) +
                               ": " + group[0].name + ", " + name_of(sweep);
      const bool went = guarded(group[0], [&] {
        StabilityMap map = make_map(hair, group[0], sweep, settings.maps, interrupted, [&](long runs) {
          if (runs % 10 == 1) tell(what + ": " + std::to_string(runs) + " runs");
        });
        map.alike.assign(group.begin() + 1, group.end());
        if (map.grid.complete) report.maps.push_back(std::move(map));
      });
      if (!went) break;
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
