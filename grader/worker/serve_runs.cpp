// STAFF ONLY. Runs a scene with all of a submission's files together, `times` times from its beginning.
//
//   JSON, times -> trouble, work, number of bodies; the kinds of each body's coordinates;
//                  number of frames; of each: time, coordinates, their rates, points of dense hair
//                  (all from the last run)
#include <vector>

#include "grader/judge/run/dense_strands.h"
#include "grader/worker/session.h"
#include "hair/scene/scene_run.h"

namespace {

struct Frame {
  double time;
  particles::State state;
  Eigen::VectorXd dense;
};

// Runs until the scene ends or breaks.
std::string play(const hair::Scene& scene, std::vector<Frame>& frames, hair::Work& work,
                 std::vector<std::uint32_t>& coordinates) {
  hair::SceneRun scene_run(scene);
  grader::DenseStrands dense(scene, scene_run.strands());
  coordinates = scene_run.coordinates();
  frames.clear();
  const auto keep = [&] {
    const particles::State state = scene_run.state();
    frames.push_back({scene_run.time(), state, {}});
    if (!scene.dense.empty())
      frames.back().dense = dense.at(scene_run.centre_lines(state).x, scene_run.time());
  };
  keep();
  std::string trouble;
  for (int k = 0; k < scene.frames && trouble.empty(); ++k) {
    trouble = scene_run.advance().value_or("");
    if (trouble.empty()) keep();
  }
  work = scene_run.work();
  return trouble;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  hair::Scene scene = hair::parse_scene(session.request.get_document(), "scene");
  scene.hair.watched = false;  // students need not have written energies
  const int times = session.request.get<int>();
  std::vector<Frame> frames;
  hair::Work work;
  std::vector<std::uint32_t> coordinates;
  std::string trouble;
  for (int i = 0; i < times; ++i) trouble = play(scene, frames, work, coordinates);

  const auto span = [](const Eigen::VectorXd& values) {
    return std::span<const double>(values.data(), static_cast<std::size_t>(values.size()));
  };
  session.reply.put(trouble).put<std::int64_t>(work.solver_steps).put<std::int64_t>(work.correction_steps);
  session.reply.put(static_cast<std::uint64_t>(coordinates.size()));
  for (const std::uint32_t one : coordinates) session.reply.put(one);
  session.reply.put(static_cast<std::uint64_t>(frames.size()));
  for (const Frame& frame : frames)
    session.reply.put(frame.time).put(span(frame.state.x)).put(span(frame.state.v)).put(span(frame.dense));
}
