// STAFF ONLY. Loads the reference's runner, and reads the frames of a worker's run.
#include "grader/judge/run/played.h"

#include <dlfcn.h>

#include <numeric>
#include <stdexcept>

#include "grader/judge/run/play_scene.h"
#include "hair/scene/scene_run.h"

namespace grader::inline judge {

PlayFunction load_runner(const std::filesystem::path& runner) {
  void* object = dlopen(runner.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* function = object == nullptr ? nullptr : dlsym(object, kRunnerName);
  if (function == nullptr) throw std::runtime_error(std::string("no runner: ") + dlerror());
  return reinterpret_cast<PlayFunction>(function);
}

Played play_with_student(Trial& trial, const std::filesystem::path& runner, const hair::Scene& scene) {
  const Ask ask = [&](const MessageWriter& request, const Products& products) {
    return trial.ask(request, products,
                     "asks for far more products or forces in a run than a solution takes");
  };
  PlayResult play;
  load_runner(runner)(scene, ask, play);
  if (play.end == PlayEnd::malformed) throw MalformedMessage(play.note);
  if (play.end == PlayEnd::threw)
    trial.fail(Status::crashed, "the scene can't go on with its numbers", play.note);
  return std::move(play.played);
}

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
  const std::vector<std::uint32_t>& coordinates = ours.coordinates();
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
