// STAFF ONLY.
#include "grader/suite/played.h"

namespace grader {

Played play_elsewhere(Trial& trial, const std::string& text, const hair::Scene& scene, int times) {
  MessageWriter request;
  request.put(text).put(times);
  MessageReader reply = trial.ask(request, [](int, const auto&, auto&) -> bool {
    throw MalformedMessage("a product that nobody asked for");
  });

  std::size_t size = 0;
  for (const hair::StrandStart& start : scene.hair.strands)
    size += static_cast<std::size_t>(start.state.x.size());
  for (const hair::Toy& toy : scene.toys) size += static_cast<std::size_t>(toy.start.x.size());
  Played played;
  played.trouble = reply.get_text();
  for (std::int64_t* steps : {&played.solver_steps, &played.correction_steps})
    *steps = reply.get<std::int64_t>();
  if (reply.get<std::uint64_t>() != scene.hair.strands.size() + scene.toys.size())
    throw MalformedMessage("another number of bodies");
  for (std::size_t i = 0; i < scene.hair.strands.size() + scene.toys.size(); ++i)
    if (reply.get<std::uint32_t>() != hair::kPositions)
      throw MalformedMessage("coordinates that are no positions");
  const auto frames = reply.get<std::uint64_t>();
  if (frames > static_cast<std::uint64_t>(scene.frames) + 1) throw MalformedMessage("too many frames");
  for (std::uint64_t i = 0; i < frames; ++i) {
    reply.get<double>();  // the time that it was there: ours is the scene's
    particles::State state;
    for (Eigen::VectorXd* part : {&state.x, &state.v}) {
      const std::vector<double> values = reply.get_doubles(size);
      *part = Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(size));
    }
    played.frames.push_back(std::move(state));
  }
  reply.expect_end();
  return played;
}

}  // namespace grader
