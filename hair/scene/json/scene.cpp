#include <cmath>

#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

namespace {

constexpr double kMostSteps = 1'000'000;  // a frame

struct SceneText {
  Scene scene;  // without the parts in lists
  std::optional<double> step;
  std::optional<LinksText> links;
  std::optional<JsonValue> hair, obstacles, motions, toys, still_hair;
};

void keys_of_hair(Keys& keys, Description& hair) {
  keys.vector("gravity", hair.gravity, {.unit = "m/s²"});
  keys.vector("wind", hair.wind, {.unit = "m/s"}, "of the air that drags; without `drag` it has no effect");
  keys.word(
      "method", hair.method, words_of(methods(), &MethodRow::id),
      {.otherwise = "predictor_corrector; of rigid links, super-helices and linked hair implicit_euler"},
      "how hair moves");
  keys.number("drag", hair.drag, {.unit = "N s/m²", .least = 0, .most = 1e6},
              "of the air, for each metre of hair; 2e-4 is right for hair that moves slowly");
  keys.word("geometric_term", hair.geometric_term, {"full", "filtered", "dropped"},
            {.otherwise = "filtered; with H6 dropped"}, "of a segment's product: see `../geometric_term.h`");
  keys.word("bend_product", hair.bend_product, {"exact", "definite"}, {}, "of bending's product");
  // Rounding leaves more than this, and a solver that waits for 0 never ends.
  keys.number("tolerance", hair.tolerance, {.least = 1e-15, .most = 1},
              "of an implicit solve, relative to its right-hand side");
  keys.word("preconditioner", hair.preconditioner, {"none", "band"}, {},
            "with `band`, implicit solves use the forces' band: see `particles/preconditioner.h`");
}

void keys_of(Keys& keys, SceneText& text) {
  Scene& scene = text.scene;
  keys.text("shows", scene.shows, {.needed = true}, "one line for people; the file's name is the scene's");
  keys.whole("frames", scene.frames, {.needed = true, .least = 1, .most = kMostFrames},
             "after the first, which is the start");
  keys.number("frames_per_second", scene.frames_per_second, {.unit = "1/s", .least = 1e-3, .most = 1e6});
  keys.whole("steps_per_frame", scene.steps_per_frame, {.least = 1, .most = kMostSteps},
             "a step takes 1 / (`frames_per_second` x `steps_per_frame`)");
  keys.number("step", text.step, {.unit = "s", .least = 1e-9, .most = 10},
              "instead of `steps_per_frame`; it must make a whole number of them");
  keys_of_hair(keys, scene.hair);
  keys.list("hair", text.hair, {.objects = kinds_of_hair()}, "a list of groups of strands");
  keys.part("links", text.links, {.otherwise = "none"},
            "a control mesh: hair is linked to its neighbours (H9)");
  keys.list("obstacles", text.obstacles, {.objects = {object<ObstacleText>()}},
            "a list of what hair can't go through");
  keys.list("motions", text.motions, {.objects = {object<MotionText>()}},
            "a list of motions, which roots and obstacles can follow");
  keys.list("toys", text.toys, {.objects = kinds_of_toys()}, "a list of toys");
  keys.list("still_hair", text.still_hair, {.otherwise = "none", .objects = {object<StillText>()}},
            "a list of hair that is drawn, and does not move on its own");
  keys.part("render", scene.look, {}, "how it is drawn");
}

void set_step(const JsonValue& object, const std::optional<double>& step, Scene& scene) {
  if (step && object.has("steps_per_frame"))
    object["step"].fail("\"steps_per_frame\" says it already; keep one of the two");
  if (step) {
    const double steps = 1 / (scene.frames_per_second * *step);
    if (!(std::abs(steps - std::round(steps)) <= 1e-6 * steps) || steps > kMostSteps + 0.5)
      object["step"].fail("makes " + exact_text(steps) +
                          " steps a frame; give one that makes a whole number, from 1 to 1000000");
    scene.steps_per_frame = static_cast<int>(std::lround(steps));
  }
  scene.hair.step = 1 / (scene.frames_per_second * scene.steps_per_frame);
}

// Sets the method of a scene that names none.
void set_usual_method(bool linked, Description& hair) {
  if (!hair.modelled.empty())
    hair.method = hair.modelled.front().model->usual_method;
  else if (linked)
    hair.method = Method::implicit_euler;
}

// Refuses keys that have no effect.
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
  SceneText text = read<SceneText>(object);
  Scene& scene = reading.scene;
  scene = std::move(text.scene);
  scene.name = file.stem().string();
  set_step(object, text.step, scene);
  if (text.motions) add_motions(*text.motions, reading);
  if (text.obstacles) add_obstacles(*text.obstacles, reading);
  if (text.hair) add_hair(*text.hair, reading);
  if (!object.has("method")) set_usual_method(text.links.has_value(), scene.hair);
  if (text.links) add_links(object["links"], *text.links, reading);
  if (text.toys) add_toys(*text.toys, reading);
  if (text.still_hair) add_still_hair(*text.still_hair, reading);
  check_use(object, reading);
  return std::move(scene);
}

}  // namespace hair::json

namespace hair {

Scene parse_scene(const std::string& text, const std::string& name) {
  return json::scene_of(parse_document(text, name), name, {});
}

std::string scene_keys() {
  return "# The keys of a scene\n\nA key that is not in these tables is an error, and so is a key that "
         "stands twice. A scene has at most " +
         std::to_string(json::kMostParticles) + " particles, and particles times frames are at most " +
         std::to_string(json::kMostStates) + ".\n\n" +
         json::key_tables(json::object<json::SceneText>(), "The scene");
}

}  // namespace hair
