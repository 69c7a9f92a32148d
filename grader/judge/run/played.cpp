// STAFF ONLY. Reads the frames of a worker's run.
#include "grader/judge/run/played.h"

#include <numeric>

#include "grader/judge/run/dense_strands.h"
#include "hair/scene/scene_run.h"

namespace grader::inline judge {

Played play_elsewhere(Trial& trial, const std::string& text, const hair::Scene& scene, int times) {
  MessageWriter request;
  request.put(text).put(times);
  MessageReader reply = trial.ask(request, [](int, const auto&, auto&) -> bool {
    throw MalformedMessage("a product, but no solver runs");
  });

  const hair::SceneRun ours(scene);
  const std::vector<int> dense = DenseStrands(scene, ours.strands()).sizes();
  const std::size_t dense_size =
      scene.dense.empty() ? 0 : 3 * std::reduce(dense.begin(), dense.end(), std::size_t{});
  const std::vector<std::uint32_t> coordinates = ours.coordinates();
  const Eigen::Index size = ours.state().x.size();
  Played played;
  played.trouble = reply.get_text();
  for (std::int64_t* steps : {&played.solver_steps, &played.correction_steps})
    *steps = reply.get<std::int64_t>();
  if (reply.get<std::uint64_t>() != coordinates.size()) throw MalformedMessage("another number of bodies");
  for (const std::uint32_t one : coordinates)
    if (reply.get<std::uint32_t>() != one) throw MalformedMessage("a body's coordinates of another kind");
  const auto frames = reply.get<std::uint64_t>();
  if (frames > static_cast<std::uint64_t>(scene.frames) + 1) throw MalformedMessage("too many frames");
  for (std::uint64_t i = 0; i < frames; ++i) {
    reply.get<double>();  // the worker's time is ignored: ours is the scene's
    particles::State state;
    for (Eigen::VectorXd* part : {&state.x, &state.v}) {
      const std::vector<double> values = reply.get_doubles(static_cast<std::size_t>(size));
      *part = Eigen::Map<const Eigen::VectorXd>(values.data(), size);
    }
    played.frames.push_back(std::move(state));
    const std::vector<double> points = reply.get_doubles(dense_size);
    if (!scene.dense.empty())
      played.dense.emplace_back(Eigen::Map<const Eigen::VectorXd>(points.data(), std::ssize(points)));
  }
  reply.expect_end();
  return played;
}

}  // namespace grader::judge
