// STAFF ONLY. Serves the scenes of hair/runs.h, with all of a submission's files together.
//
//   name -> trouble, number of frames; of each: time, x, v, stretch, energy
#include "grader/worker/session.h"
#include "hair/runs.h"

extern "C" __attribute__((visibility("default"))) void serve(grader::Session& session) {
  const hair::RunResult run = hair::do_run(session.request.get_text());
  const auto span = [](const Eigen::VectorXd& values) {
    return std::span<const double>(values.data(), static_cast<std::size_t>(values.size()));
  };
  session.reply.put(run.trouble).put(static_cast<std::uint64_t>(run.frames.size()));
  for (const hair::Frame& frame : run.frames)
    session.reply.put(frame.time)
        .put(span(frame.state.x))
        .put(span(frame.state.v))
        .put(frame.stretch)
        .put(frame.energy);
}
