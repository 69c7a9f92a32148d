#include <algorithm>
#include <string>

#include "hair/scene/json/parts.h"
#include "hair/scene/json/values.h"

namespace hair::json {

namespace {

constexpr double kGathered = 0.6;
constexpr long kMostDense = 1'000'000;

// Of the last group, and of the rows before it that its guides stand in, too.
std::size_t first_row(const JsonValue& object, const Reading& reading) {
  const std::vector<GroupRoots>& groups = reading.groups;
  if (!object.has("rows")) return groups.size() - 1;
  const JsonValue rows = object["rows"];
  const auto count = static_cast<std::size_t>(rows.whole_number(1, 1000));
  if (count > groups.size())
    rows.fail("is more than the groups that are there; there are " + std::to_string(groups.size()));
  const GroupRoots& last = groups.back();
  for (std::size_t i = groups.size() - count; i < groups.size(); ++i) {
    const std::string which = "hair[" + std::to_string(i) + "] ";
    if (groups[i].listed.empty()) rows.fail(which + "is no list of roots; all rows are lists");
    if (groups[i].dense)
      rows.fail(which + "has dense hair of its own; give one row the \"synthesis\" of all");
    if (groups[i].points != last.points)
      rows.fail(which + "has strands of " + std::to_string(groups[i].points) + " points, and this group of " +
                std::to_string(last.points) + "; give them as many");
    if (groups[i].rider != last.rider)
      rows.fail(which + "does not move with what this group moves with; write the same \"moves_with\"");
  }
  return groups.size() - count;
}

}  // namespace

void read_synthesis(const JsonValue& group, GroupScalp scalp, Reading& reading) {
  const JsonValue object = group["synthesis"];
  object.check_keys({"strands"},
                    {"mode", "spread", "jitter", "length", "seed", "rows", "clump", "gathered", "fly_aways"});
  const std::size_t row = first_row(object, reading);
  std::vector<GroupRoots>& groups = reading.groups;
  if (!groups.back().listed.empty()) {
    std::vector<RootFrame> roots;
    for (std::size_t i = row; i < groups.size(); ++i)
      roots.insert(roots.end(), groups[i].listed.begin(), groups[i].listed.end());
    scalp = scalp_of(roots);
  }
  const auto strands = static_cast<int>(object["strands"].whole_number(1, kMostDense));
  reading.dense_points += static_cast<long>(strands) * groups.back().points;
  if (reading.dense_points > kMostDensePoints)
    object["strands"].fail("makes " + std::to_string(reading.dense_points) +
                           " points in all; a scene draws at most " + std::to_string(kMostDensePoints));

  DenseHair dense{groups[row].first, {}, {}};
  SynthesisDescription& made = dense.description;
  made.points = groups.back().points;
  if (object.has("mode"))
    made.mode = static_cast<SynthesisMode>(object["mode"].word({"interpolate", "extrapolate", "blend"}));
  made.spread = number_or(object, "spread", made.spread, 0, 100);
  made.jitter = number_or(object, "jitter", made.jitter, 0, 1);
  made.length = number_or(object, "length", made.length, 0, 0.9);
  if (object.has("clump")) made.clump = static_cast<int>(object["clump"].whole_number(0, kMostDense));
  made.gathered = number_or(object, "gathered", made.clump > 0 ? kGathered : 0, 0, 1);
  made.fly_aways = number_or(object, "fly_aways", made.fly_aways, 0, 1);
  if (object.has("seed")) made.seed = static_cast<std::uint64_t>(object["seed"].whole_number(0, 1L << 53));
  made.combed = scalp.combed;
  made.guides = std::move(scalp.guides);
  made.children = scalp.more(strands, made.seed);
  if (made.children.empty())
    object.fail(
        "the roots are on a line, and have no room for more between them; give three at least that are not");
  if (groups.back().rider) dense.motion = groups.back().rider->motion;
  for (std::size_t i = row; i < groups.size(); ++i) groups[i].dense = true;
  reading.scene.dense.push_back(std::move(dense));
}

}  // namespace hair::json
