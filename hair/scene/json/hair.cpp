#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hair/scene/json/parts.h"
#include "hair/scene/json/roots.h"
#include "hair/simulation/models.h"
#include "hair/strand/variation.h"

namespace hair::json {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

struct ShapeText {
  std::optional<Wavy> wavy;
  std::optional<Curly> curly;
};

struct Spread {
  std::uint64_t seed = 0;
  double length = 0, tilt = 0, turn = 0;  // tilt and turn in degrees
};

void keys_of(Keys& keys, Spread& spread) {
  keys.about("Random differences. The same seed gives the same strands.");
  keys.whole("seed", spread.seed, {.least = 0, .most = kLargestSeed});
  keys.number("length", spread.length, {.least = 0, .most = 0.9}, "longer or shorter by up to this part");
  keys.number("tilt", spread.tilt, {.unit = "°", .least = 0, .most = 90}, "of the direction, up to");
  keys.number("turn", spread.turn, {.unit = "°", .least = 0, .most = 180},
              "of waves and curls about the strand, up to, either way");
}

// A group that has "roots".
struct RootedText {
  int segments;
  double length;
  Roots roots;
  ShapeText shape;
  Spread variation;
  GroupText group;
};

void keys_of(Keys& keys, RootedText& text) {
  keys.about("A group: strands that differ by their roots, and by chance.");
  keys.whole("segments", text.segments, {.needed = true, .least = 1, .most = 10'000},
             "of each strand: it has one particle more");
  keys.length("length", text.length, {.needed = true}, "of each strand");
  keys.part("roots", text.roots, {.needed = true}, "where they grow, and in which direction");
  keys.part("shape", text.shape, {.otherwise = "straight"}, "at rest");
  keys.part("variation", text.variation, {.otherwise = "none"}, "how strands differ");
  keys_of(keys, text.group);
}

RestForm form_of(const ShapeText& shape) {
  if (shape.wavy) return *shape.wavy;
  if (shape.curly) return *shape.curly;
  return Straight{};
}

StrandSpec with_variation(StrandSpec spec, const RootFrame& frame, const Spread& spread,
                          Variation& variation) {
  spec.length *= 1 + variation.uniform(-spread.length, spread.length);
  spec.root = varied(frame, kDegree * spread.tilt, kDegree * spread.turn, variation);
  return spec;
}

void add_rooted(const JsonValue& object, Reading& reading) {
  const RootedText text = read<RootedText>(object);
  const ModelRow& model = models()[text.group.model];
  if (&model == &models().front() && !reading.scene.hair.modelled.empty())
    object.fail("hair of masses and springs comes before hair of other models; move this group up");
  StrandSpec spec = spec_of(object, text.group);
  spec.elements = text.segments;
  spec.length = text.length;
  spec.form = form_of(text.shape);
  if (!spec.clamped && is_wave_or_curl(spec.form))
    object["clamped"].fail("wavy and curly hair must be clamped; write true, or leave the shape out");
  const long points = model.points(spec);
  Description& hair = reading.scene.hair;
  Rider* const rider = reading.rider(object, text.group.moves_with);
  Variation variation(text.variation.seed);
  const std::vector<RootFrame> roots =
      make_roots(object["roots"], text.roots, [&](const JsonValue& where, long count) {
        reading.expect(where, count, points);
        return reading.made(count);
      });
  for (const RootFrame& frame : roots) {
    if (rider) rider->strands.push_back(static_cast<int>(hair.strands.size() + hair.modelled.size()));
    try {
      add_strand(model, with_variation(spec, frame, text.variation, variation), hair);
    } catch (const std::invalid_argument& error) {
      object.fail(error.what());
    }
  }
  GroupRoots& group = reading.groups.back();
  group.points = static_cast<int>(points);
  group.rider = rider;
  if (text.roots.list) group.listed = roots;
  if (text.group.synthesis)
    add_synthesis(object["synthesis"], *text.group.synthesis,
                  text.roots.list ? GroupScalp() : scalp_of(text.roots, static_cast<int>(roots.size())),
                  reading);
}

}  // namespace

static void keys_of(Keys& keys, Wavy& wave) {
  keys.number("amplitude", wave.amplitude, {.unit = "m", .needed = true, .least = 0, .most = kLongest},
              "at most a wavelength");
  keys.length("wavelength", wave.wavelength, {.needed = true}, "at least four segments");
}

static void keys_of(Keys& keys, Curly& curl) {
  keys.number("radius", curl.radius, {.unit = "m", .needed = true, .least = 0, .most = kLongest});
  keys.length("pitch", curl.pitch, {.needed = true},
              "from one turn to the next; a turn takes at least four segments");
}

static void keys_of(Keys& keys, ShapeText& shape) {
  keys.one_of();
  keys.part("wavy", shape.wavy, {}, "a plane wave");
  keys.part("curly", shape.curly, {}, "a helix");
}

std::vector<ObjectKind> kinds_of_hair() {
  return {object<RootedText>(), {groomed_section, " with a groom"}};
}

void add_strand(const ModelRow& model, const StrandSpec& spec, Description& hair) {
  if (const std::string why = model.why_not(spec); !why.empty()) throw std::invalid_argument(why);
  if (&model == &models().front()) {
    hair.strands.push_back(discretise(spec));
    return;
  }
  hair.modelled.push_back({&model, spec});
}

void add_hair(const JsonValue& list, Reading& reading) {
  Description& hair = reading.scene.hair;
  for (const JsonValue& object : list.items()) {
    reading.rows.push_back(static_cast<int>(hair.strands.size()));
    reading.groups.push_back({static_cast<int>(hair.strands.size() + hair.modelled.size()), 0, nullptr, {}});
    if (object.has("groom"))
      add_groomed(object, reading);
    else
      add_rooted(object, reading);
  }
}

}  // namespace hair::json
