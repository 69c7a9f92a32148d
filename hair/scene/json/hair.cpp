#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hair/scene/json/fibre.h"
#include "hair/scene/json/parts.h"
#include "hair/scene/json/roots.h"
#include "hair/scene/json/values.h"
#include "hair/simulation/models.h"
#include "hair/strand/variation.h"

namespace hair::json {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr int kMostSegments = 10'000;

RestForm read_form(const JsonValue& group) {
  if (!group.has("shape")) return Straight{};
  const JsonValue object = group["shape"];
  const std::string kind = object.only_key({"wavy", "curly"});
  const JsonValue numbers = object[kind];
  if (kind == "wavy") {
    numbers.check_keys({"amplitude", "wavelength"});
    return Wavy{numbers["amplitude"].number(0, kLongest), length(numbers["wavelength"])};
  }
  numbers.check_keys({"radius", "pitch"});
  return Curly{numbers["radius"].number(0, kLongest), length(numbers["pitch"])};
}

struct Spread {
  double length = 0, tilt = 0, turn = 0;
  std::uint64_t seed = 0;
};

Spread read_spread(const JsonValue& group) {
  if (!group.has("variation")) return {};
  const JsonValue object = group["variation"];
  object.check_keys({}, {"seed", "length", "tilt", "turn"});
  Spread spread;
  spread.length = number_or(object, "length", 0, 0, 0.9);
  spread.tilt = kDegree * number_or(object, "tilt", 0, 0, 90);
  spread.turn = kDegree * number_or(object, "turn", 0, 0, 180);
  if (object.has("seed")) spread.seed = static_cast<std::uint64_t>(object["seed"].whole_number(0, 1L << 53));
  return spread;
}

struct Group {
  const ModelRow* model;
  StrandSpec spec;  // but for its root
  Spread spread;

  StrandSpec make(const RootFrame& frame, Variation& variation) const {
    StrandSpec own = spec;
    own.length *= 1 + variation.uniform(-spread.length, spread.length);
    own.root = varied(frame, spread.tilt, spread.turn, variation);
    return own;
  }
};

Group read_group(const JsonValue& object) {
  object.check_keys({"segments", "length", "roots"},
                    {"model", "material", "shape", "clamped", "start", "variation", "root_velocity",
                     "moves_with", "synthesis"});
  Group group;
  group.model = read_model(object);
  StrandSpec& spec = group.spec;
  spec.elements = static_cast<int>(object["segments"].whole_number(1, kMostSegments));
  spec.length = length(object["length"]);
  spec.fibre = read_fibre(object);
  spec.form = read_form(object);
  spec.start = read_held(object);
  group.spread = read_spread(object);
  spec.clamped = boolean_or(object, "clamped", true);
  if (!spec.clamped && is_wave_or_curl(spec.form))
    object["clamped"].fail("wavy and curly hair must be clamped; write true, or leave the shape out");
  spec.root_velocity = read_root_velocity(object);
  return group;
}

// States are written with one kind of coordinates.
void check_one_model(const JsonValue& object, const Description& hair) {
  const auto differs = [&](const ModelledStrand& strand) {
    return strand.model != hair.modelled.front().model;
  };
  if (hair.modelled.empty()) return;
  if (!hair.strands.empty() || std::any_of(hair.modelled.begin(), hair.modelled.end(), differs))
    object.fail("all hair of a scene has the same model; write the same \"model\" in each group");
}

// A group that has "roots".
void read_rooted(const JsonValue& object, Reading& reading) {
  const Group group = read_group(object);
  const auto expect = [&](const JsonValue& where, long count) {
    reading.expect(where, count, group.model->points(group.spec));
  };
  Description& hair = reading.scene.hair;
  Rider* const rider = reading.rider(object);
  Variation variation(group.spread.seed);
  const std::vector<RootFrame> roots = read_roots(object["roots"], expect);
  for (const RootFrame& frame : roots) {
    if (rider) rider->strands.push_back(static_cast<int>(hair.strands.size() + hair.modelled.size()));
    try {
      add_strand(*group.model, group.make(frame, variation), hair);
    } catch (const std::invalid_argument& error) {
      object.fail(error.what());
    }
  }
  GroupRoots& read = reading.groups.back();
  read.points = static_cast<int>(group.model->points(group.spec));
  read.rider = rider;
  const bool listed = object["roots"].has("list");
  if (listed) read.listed = roots;
  if (object.has("synthesis"))
    read_synthesis(object, listed ? GroupScalp() : scalp_of(object["roots"], static_cast<int>(roots.size())),
                   reading);
}

}  // namespace

const ModelRow* read_model(const JsonValue& group) {
  if (!group.has("model")) return &models().front();
  std::vector<std::string_view> names;
  for (const ModelRow& row : models()) names.emplace_back(row.id);
  return &models()[group["model"].word(names)];
}

void add_strand(const ModelRow& model, const StrandSpec& spec, Description& hair) {
  if (const std::string why = model.why_not(spec); !why.empty()) throw std::invalid_argument(why);
  if (&model == &models().front()) {
    hair.strands.push_back(discretise(spec));
    return;
  }
  hair.modelled.push_back({&model, spec});
}

void read_hair(const JsonValue& list, Reading& reading) {
  Description& hair = reading.scene.hair;
  for (const JsonValue& object : list.items()) {
    reading.rows.push_back(static_cast<int>(hair.strands.size()));
    reading.groups.push_back({static_cast<int>(hair.strands.size() + hair.modelled.size()), 0, nullptr, {}});
    if (object.has("groom"))
      read_groom(object, reading);
    else
      read_rooted(object, reading);
    check_one_model(object, hair);
  }
}

}  // namespace hair::json
