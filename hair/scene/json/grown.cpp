#include <memory>
#include <string>

#include "hair/head/bust.h"
#include "hair/head/ellipsoid_head.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

namespace {

struct GrownText {
  std::size_t style, head = 0;
  GrowSettings settings;
  std::optional<double> length;
  Vector3d at = Vector3d::Zero();
};

void keys_of(Keys& keys, GrownText& groom) {
  keys.about(
      "Hair in a style, on a head. It goes round the head, and round the shoulders of a bust: place the bust "
      "under `obstacles[].bust` alike. At rest it has the shape in which it grew, and only its weight moves "
      "it from there. As guides of dense hair, strands are in no clumps.");
  keys.word("style", groom.style, words_of(hair_styles(), &HairStyle::name), {.needed = true},
            "[what they look like](../lab/README.md#hairlab-info-convert-groom)");
  keys.whole("strands", groom.settings.strands, {.needed = true, .least = 1, .most = 100'000});
  keys.whole("points", groom.settings.points, {.least = 2, .most = kMostPoints, .otherwise = "the style's"},
             "of each strand; curls and waves need eight a turn");
  keys.number("length", groom.length,
              {.unit = "m", .least = kShortest, .most = kLongest, .otherwise = "the style's"});
  keys.word("head", groom.head, {"bust", "ellipsoid"}, {}, "what it grows on");
  keys.vector("at", groom.at, {.unit = "m"}, "where the middle of its skull is");
  keys.whole("seed", groom.settings.seed, {.least = 0, .most = kLargestSeed},
             "the same seed gives the same hair");
}

}  // namespace

const Section& grown_section() {
  return section_of<GrownText>();
}

StillHair read_grown(const JsonValue& groom) {
  const GrownText text = read<GrownText>(groom);
  StillHair hair;
  hair.style = hair_styles()[text.style];
  if (text.length) hair.style.length = *text.length;
  hair.settings = text.settings;
  hair.at = text.at;
  if (text.head == 1)
    hair.head = std::make_shared<EllipsoidHead>();
  else
    hair.head = std::make_shared<Bust>();
  return hair;
}

void keys_of(Keys& keys, StillText& still) {
  keys.about(
      "Hair that keeps the shape in which it grows, and goes with the head: what is tied, and what is short. "
      "It is only drawn. No exercise is called for it, and no other hair touches it.");
  keys.any("groom", still.groom, {.needed = true}, "[a groom that grows](#hairgroom-that-grows)");
  keys.text("moves_with", still.moves_with, {.otherwise = "nothing"}, "the name of a motion");
}

void add_still_hair(const JsonValue& list, Reading& reading) {
  for (const JsonValue& item : list.items()) {
    const StillText still = read<StillText>(item);
    const JsonValue& groom = *still.groom;
    StillHair hair = read_grown(groom);
    const int points = hair.settings.points > 0 ? hair.settings.points : hair.style.points;
    if (points < fewest_points(hair.style))
      groom["points"].fail("is too few to follow the style; give " +
                           std::to_string(fewest_points(hair.style)) + " at least");
    reading.dense_points += static_cast<long>(hair.settings.strands) * points;
    if (reading.dense_points > kMostDensePoints)
      groom["strands"].fail("makes " + std::to_string(reading.dense_points) +
                            " points in all; a scene draws at most " + std::to_string(kMostDensePoints));
    if (const Rider* rider = reading.rider(item, still.moves_with)) hair.motion = rider->motion;
    reading.scene.still.push_back(std::move(hair));
  }
}

}  // namespace hair::json
