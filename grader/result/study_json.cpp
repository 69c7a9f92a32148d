// STAFF ONLY.
#include "grader/result/study_json.h"

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "hair/io/plot/readable.h"

namespace grader {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const StudyPoint& point) {
  Json all = {{"steps", point.steps}, {"end", to_string(point.end)}};
  if (!point.note.empty()) all["note"] = hair::valid_utf8(point.note);
  if (point.end == StudyEnd::finished) all["error"] = point.error;
  if (point.end != StudyEnd::broke) {
    all["solver_steps"] = point.solver_steps;
    all["correction_steps"] = point.correction_steps;
  }
  all["first_seconds"] = point.first_seconds;
  all["seconds"] = point.seconds;
  return all;
}

StudyPoint point_from(const Json& json) {
  StudyPoint point;
  point.steps = json.at("steps");
  point.note = json.value("note", "");
  point.error = json.value("error", 0.0);
  point.solver_steps = json.value("solver_steps", std::int64_t{0});
  point.correction_steps = json.value("correction_steps", std::int64_t{0});
  point.first_seconds = json.at("first_seconds");
  point.seconds = json.at("seconds").get<std::vector<double>>();
  for (const StudyEnd end : {StudyEnd::finished, StudyEnd::ran_away, StudyEnd::broke})
    if (json.at("end") == to_string(end)) point.end = end;
  return point;
}

Json to_json(const StudyCurve& curve) {
  Json points = Json::array();
  for (const StudyPoint& point : curve.points) points.push_back(to_json(point));
  return {{"stable_steps", curve.stable_steps},
          {"stable_everywhere", curve.stable_everywhere},
          {"points", points}};
}

StudyCurve curve_from(const Json& json) {
  StudyCurve curve;
  curve.stable_steps = json.at("stable_steps");
  curve.stable_everywhere = json.at("stable_everywhere");
  for (const Json& point : json.at("points")) curve.points.push_back(point_from(point));
  return curve;
}

Json to_json(const PartStudy& part) {
  Json all = {{"name", part.name},
              {"duration", part.duration},
              {"own_steps", part.own_steps},
              {"order", part.order},
              {"truth", part.truth},
              {"least_error", part.least_error},
              {"rounds", part.rounds},
              {"time_ratio", nullptr},
              {"note", hair::valid_utf8(part.note)},
              {"student", to_json(part.student)},
              {"reference", to_json(part.reference)}};
  if (part.ratio)
    all["time_ratio"] = {
        {"median", part.ratio->median}, {"least", part.ratio->least}, {"most", part.ratio->most}};
  return all;
}

PartStudy part_from(const Json& json) {
  PartStudy part;
  part.name = json.at("name");
  part.duration = json.at("duration");
  part.own_steps = json.at("own_steps");
  part.order = json.at("order");
  part.truth = json.at("truth");
  part.least_error = json.at("least_error");
  part.rounds = json.at("rounds");
  part.note = json.at("note");
  part.student = curve_from(json.at("student"));
  part.reference = curve_from(json.at("reference"));
  if (const Json& ratio = json.at("time_ratio"); !ratio.is_null())
    part.ratio = {ratio.at("median"), ratio.at("least"), ratio.at("most")};
  return part;
}

}  // namespace

std::string study_json(const SubmissionStudy& study) {
  Json scenes = Json::array();
  for (const SceneStudy& scene : study.scenes) {
    Json parts = Json::array();
    for (const PartStudy& part : scene.parts) parts.push_back(to_json(part));
    scenes.push_back({{"name", scene.name},
                      {"shows", scene.shows},
                      {"left_out", hair::valid_utf8(scene.left_out)},
                      {"parts", parts}});
  }
  const Json all = {{"student_seconds", study.student_seconds},
                    {"reference_seconds", study.reference_seconds},
                    {"scenes", scenes}};
  return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

SubmissionStudy study_from_json(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    SubmissionStudy study;
    study.student_seconds = json.at("student_seconds");
    study.reference_seconds = json.at("reference_seconds");
    for (const Json& one : json.at("scenes")) {
      SceneStudy& scene =
          study.scenes.emplace_back(SceneStudy{one.at("name"), one.at("shows"), one.at("left_out")});
      for (const Json& part : one.at("parts")) scene.parts.push_back(part_from(part));
    }
    return study;
  } catch (const Json::exception& error) {
    throw std::runtime_error(std::string("no study: ") + error.what());
  }
}

}  // namespace grader
