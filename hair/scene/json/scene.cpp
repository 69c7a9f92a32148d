#include <array>
#include <charconv>
#include <cmath>

#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"

namespace hair::json {

namespace {

// Of a solve's tolerance: rounding leaves more, and a solver that waits for 0 waits forever.
constexpr double kTightest = 1e-15;

// As short as it can be read back.
std::string exact_text(double number) {
  std::array<char, 32> text;
  return {text.data(), std::to_chars(text.begin(), text.end(), number).ptr};
}

void read_times(const JsonValue& object, Scene& scene) {
  scene.frames = static_cast<int>(object["frames"].whole_number(1, kMostFrames));
  scene.frames_per_second = number_or(object, "frames_per_second", scene.frames_per_second, 1e-3, 1e6);
  if (object.has("step") && object.has("steps_per_frame"))
    object["step"].fail("\"steps_per_frame\" says it already; keep one of the two");
  if (object.has("steps_per_frame"))
    scene.steps_per_frame = static_cast<int>(object["steps_per_frame"].whole_number(1, 1'000'000));
  if (object.has("step")) {
    const double steps = 1 / (scene.frames_per_second * object["step"].number(1e-9, 10));
    if (!(std::abs(steps - std::round(steps)) <= 1e-6 * steps) || steps > 1e6 + 0.5)
      object["step"].fail("makes " + exact_text(steps) +
                          " steps a frame; give one that makes a whole number, from 1 to 1000000");
    scene.steps_per_frame = static_cast<int>(std::lround(steps));
  }
  scene.hair.step = 1 / (scene.frames_per_second * scene.steps_per_frame);
}

void read_method(const JsonValue& object, Description& hair) {
  if (object.has("method")) {
    std::vector<std::string_view> ids;
    for (const MethodRow& row : methods()) ids.emplace_back(row.id);
    hair.method = methods()[object["method"].word(ids)].method;
  }
  if (object.has("geometric_term")) {
    constexpr GeometricTerm kTerms[] = {GeometricTerm::full, GeometricTerm::filtered, GeometricTerm::dropped};
    hair.geometric_term = kTerms[object["geometric_term"].word({"full", "filtered", "dropped"})];
  }
  if (object.has("bend_product")) {
    constexpr Products kProducts[] = {Products::exact, Products::definite};
    hair.bend_product = kProducts[object["bend_product"].word({"exact", "definite"})];
  }
  if (object.has("preconditioner"))
    hair.preconditioner = object["preconditioner"].word({"none", "band"}) == 1;
  hair.tolerance = number_or(object, "tolerance", hair.tolerance, kTightest, 1);
}

// What has nothing that it could be for.
void check_use(const JsonValue& object, const Reading& reading) {
  if (reading.particles == 0) object.fail("there is nothing that moves; give \"hair\" or \"toys\"");
  if (!has_strands(reading.scene)) {
    for (const char* key :
         {"method", "drag", "geometric_term", "bend_product", "preconditioner", "links", "obstacles"})
      if (object.has(key)) object[key].fail("is for hair, and there is none; leave it out");
  }
  if (!reading.scene.hair.modelled.empty() && !reading.scene.toys.empty())
    object["toys"].fail(
        "toys stand beside hair of masses and springs only; leave them out, or the \"model\"");
  if (!reading.scene.dense.empty() && !reading.scene.look)
    object["hair"].fail("\"synthesis\" is how hair is drawn; give \"render\", too");
  if (!reading.scene.still.empty() && !reading.scene.look)
    object["still_hair"].fail("is drawn and nothing else; give \"render\", too");
  for (const auto& [name, rider] : reading.motions)
    if (reading.scene.riders[rider].strands.empty() && reading.scene.riders[rider].obstacles.empty())
      object["motions"].fail("nothing moves with \"" + name +
                             "\"; write it as \"moves_with\", or leave it out");
}

}  // namespace

void Reading::expect(const JsonValue& where, long strands, long of_each) {
  particles += strands * of_each;
  if (particles > most_particles)
    where.fail("makes " + std::to_string(particles) + " particles in all; a scene has at most " +
               std::to_string(most_particles));
  if (particles * scene.frames > kMostStates)
    where.fail("makes " + std::to_string(particles) + " particles in " + std::to_string(scene.frames) +
               " frames; particles times frames are at most " + std::to_string(kMostStates));
}

Scene scene_of(const JsonDocument& document, const std::filesystem::path& file, Reading reading) {
  const JsonValue object(*document, file);
  object.check_keys({"shows", "frames"},
                    {"frames_per_second", "steps_per_frame", "step", "gravity", "wind", "method", "drag",
                     "geometric_term", "bend_product", "tolerance", "preconditioner", "hair", "links",
                     "obstacles", "motions", "toys", "still_hair", "render"});
  Scene& scene = reading.scene;
  scene.name = file.stem().string();
  scene.shows = object["shows"].text();
  read_times(object, scene);
  read_method(object, scene.hair);
  scene.hair.gravity = vector_or(object, "gravity", scene.hair.gravity, kFast);
  scene.hair.wind = vector_or(object, "wind", scene.hair.wind, kFast);
  scene.hair.drag = number_or(object, "drag", scene.hair.drag, 0, 1e6);
  if (object.has("motions")) read_motions(object["motions"], reading);
  if (object.has("obstacles")) read_obstacles(object["obstacles"], reading);
  if (object.has("hair")) read_hair(object["hair"], reading);
  if (object.has("links")) read_links(object["links"], reading);
  if (object.has("toys")) read_toys(object["toys"], reading);
  if (object.has("still_hair")) read_still_hair(object["still_hair"], reading);
  if (object.has("render")) scene.look = read_look(object["render"]);
  check_use(object, reading);
  return std::move(scene);
}

}  // namespace hair::json
