// STAFF ONLY. Runs a scene with all of a submission's files together, `times` times from its beginning.
//
//   JSON, times -> trouble, work, number of bodies; the kinds of each body's coordinates;
//                  number of frames; of each: coordinates, their rates, points of dense hair
//                  (all from the last run)
#include "grader/judge/run/play_scene.h"
#include "grader/worker/session.h"

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  const hair::Scene scene = hair::parse_scene(session.request.get_document(), "scene");
  const int times = session.request.get<int>();
  grader::Played played;
  for (int i = 0; i < times; ++i) {
    played = {};
    grader::play_scene(scene, played);
  }

  const auto put = [&](const Eigen::VectorXd& values) {
    session.reply.put(std::span<const double>(values.data(), static_cast<std::size_t>(values.size())));
  };
  session.reply.put(played.trouble).put(played.solver_steps).put(played.correction_steps);
  session.reply.put(static_cast<std::uint64_t>(played.coordinates.size()));
  for (const std::uint32_t one : played.coordinates) session.reply.put(one);
  session.reply.put(static_cast<std::uint64_t>(played.frames.size()));
  for (std::size_t i = 0; i < played.frames.size(); ++i) {
    put(played.frames[i].x);
    put(played.frames[i].v);
    put(scene.dense.empty() ? Eigen::VectorXd() : played.dense[i]);
  }
}
