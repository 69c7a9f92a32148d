// STAFF ONLY. Reads a hidden scene and varies its numbers by the seed.
#include "grader/judge/run/hidden_scene.h"

#include <nlohmann/json.hpp>

#include "grader/course/input.h"
#include "grader/judge/cases/random.h"

namespace grader::inline judge {

HiddenScene read_hidden_scene(const std::filesystem::path& file, const std::string& seed) {
  const nlohmann::json document = read_json(file);
  const JsonValue value(document, file);
  value.check_keys({"canary", "scene", "vary", "pictures"});

  nlohmann::json scene = document["scene"];
  const JsonValue vary = value["vary"];
  for (const std::string& place : vary.keys()) {
    const double most = vary[place].number(0, 1e3), part = Random(seed, place).uniform(-1, 1);
    try {
      nlohmann::json& number = scene.at(nlohmann::json::json_pointer(place));
      number = number.get<double>() + most * part;
    } catch (const nlohmann::json::exception&) {
      vary[place].fail("the scene has no number there; expected a JSON pointer to one");
    }
  }

  HiddenScene hidden{scene.dump(), {}, {}};
  hidden.scene = hair::parse_scene(hidden.text, file.string());
  for (const JsonValue& frame : value["pictures"].items())
    hidden.pictures.push_back(static_cast<int>(frame.number(0, hidden.scene.frames)));
  return hidden;
}

}  // namespace grader::judge
