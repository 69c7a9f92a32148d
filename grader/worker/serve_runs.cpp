// STAFF ONLY. Plays a scene with all of a submission's files together.
//
//   JSON -> trouble, number of frames; of each: time, x, v
#include <vector>

#include "grader/worker/session.h"
#include "hair/scene/playback.h"

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  const hair::Scene scene = hair::parse_scene(session.request.get_document(), "scene");
  hair::Playback playback(scene);
  struct Frame {
    double time;
    particles::State state;
  };
  std::vector<Frame> frames{{0, playback.state()}};
  std::string trouble;
  for (int k = 0; k < scene.frames && trouble.empty(); ++k) {
    trouble = playback.advance().value_or("");
    if (trouble.empty()) frames.push_back({playback.time(), playback.state()});
  }

  const auto span = [](const Eigen::VectorXd& values) {
    return std::span<const double>(values.data(), static_cast<std::size_t>(values.size()));
  };
  session.reply.put(trouble).put(static_cast<std::uint64_t>(frames.size()));
  for (const Frame& frame : frames)
    session.reply.put(frame.time).put(span(frame.state.x)).put(span(frame.state.v));
}
