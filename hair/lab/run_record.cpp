#include "hair/lab/run_record.h"

#include <nlohmann/json.hpp>

namespace hair {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

const char* name_of(Ending ending) {
  switch (ending) {
    case Ending::finished:
      return "finished";
    case Ending::interrupted:
      return "interrupted";
    case Ending::blow_up:
      return "blow-up";
  }
  return "";
}

Json json_of(const Work& work) {
  return {{"strand_steps", work.strand_steps},
          {"solver_steps", work.solver_steps},
          {"correction_steps", work.correction_steps},
          {"unconverged", work.unconverged},
          {"contacts", work.contacts},
          {"penetration", work.penetration}};
}

// The work since the frame before.
Json json_of(int k, const FrameRecord& frame, const Work& before) {
  return {{"frame", k},
          {"time", frame.time},
          {"kinetic", frame.measures.kinetic},
          {"potential", frame.measures.potential},
          {"energy", frame.measures.energy()},
          {"momentum", json_of(frame.measures.momentum)},
          {"angular_momentum", json_of(frame.measures.angular_momentum)},
          {"stretch", frame.measures.stretch},
          {"solver_steps", frame.work.solver_steps - before.solver_steps},
          {"correction_steps", frame.work.correction_steps - before.correction_steps},
          {"unconverged", frame.work.unconverged - before.unconverged},
          {"contacts", frame.work.contacts - before.contacts}};
}

Json json_of(const Seconds& seconds) {
  return {{"simulate", seconds.simulate},   {"measure", seconds.measure}, {"write", seconds.write},
          {"upload", seconds.upload},       {"shadow", seconds.shadow},   {"draw", seconds.draw},
          {"read_back", seconds.read_back}, {"png", seconds.png},         {"film", seconds.film}};
}

Json or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json or_null(const std::optional<std::string>& text) {
  return text ? Json(*text) : Json(nullptr);
}

}  // namespace

const char* method_name(Method method) {
  switch (method) {
    case Method::forward_euler:
      return "forward_euler";
    case Method::symplectic_euler:
      return "symplectic_euler";
    case Method::midpoint:
      return "midpoint";
    case Method::runge_kutta_4:
      return "runge_kutta_4";
    case Method::implicit_euler:
      return "implicit_euler";
    case Method::predictor_corrector:
      return "predictor_corrector";
    case Method::newton_euler:
      return "newton_euler";
  }
  return "";
}

std::string run_json(const Scene& scene, const RunRecord& record) {
  const bool hair = !scene.hair.strands.empty();
  const Json head = {
      {"program", "hairlab"},
      {"format", 1},
      {"scene", scene.name},
      {"shows", scene.shows},
      {"exercises", exercises_of(scene)},
      {"ended", name_of(record.ending)},
      {"blow_up", or_null(record.blow_up)},
      {"frames_asked", record.frames_asked + 1},
      {"frames_written", record.frames.size()},
      {"frames_per_second", scene.frames_per_second},
      {"steps_per_frame", scene.steps_per_frame},
      {"step", scene.hair.step},
      {"method", hair ? Json(method_name(scene.hair.method)) : Json(nullptr)},
      {"strands", record.strands.size()},
      {"particles", record.particles},
      {"no_pictures", or_null(record.no_pictures)},
      {"no_film", or_null(record.no_film)},
      {"opengl", or_null(record.opengl)},
      {"work", json_of(record.frames.empty() ? Work{} : record.frames.back().work)},
  };
  std::string text = "{\n";
  for (const auto& [key, value] : head.items()) text += "  " + Json(key).dump() + ": " + value.dump() + ",\n";
  text += "  \"frames\": [";
  Work before;
  for (std::size_t k = 0; k < record.frames.size(); ++k) {
    const FrameRecord& frame = record.frames[k];
    text += (k == 0 ? "\n    " : ",\n    ") + json_of(static_cast<int>(k), frame, before).dump();
    before = frame.work;
  }
  return text + "\n  ],\n  \"seconds\": " + json_of(record.seconds).dump() + "\n}\n";
}

}  // namespace hair
