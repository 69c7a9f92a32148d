#include <algorithm>
#include <string>

#include "hair/scene/json/keys.h"
#include "hair/scene/json/parts.h"

namespace hair::json {

namespace {

constexpr double kMostDense = 1'000'000;

// The first row of guides: that of the last group, or of earlier groups if "rows" says so.
std::size_t first_row(const JsonValue& object, std::size_t count, const Reading& reading) {
  const std::vector<GroupRoots>& groups = reading.groups;
  if (!object.has("rows")) return groups.size() - 1;
  const JsonValue rows = object["rows"];
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

void keys_of(Keys& keys, SynthesisText& text) {
  keys.about(
      "Dense hair (H10). The group's strands move, and are guides: others are drawn, at roots that are "
      "spread over the same line, disc, cap or bust, over the head that a groom grows on, or over the "
      "triangles between the roots of a list or of a groom's file, without those that have very long sides. "
      "It has no effect on how hair moves.");
  SynthesisDescription& made = text.made;
  keys.whole("strands", text.strands, {.needed = true, .least = 1, .most = kMostDense},
             "that are drawn; a scene draws at most 50 million points of them");
  keys.word(
      "mode", made.mode, {"interpolate", "extrapolate", "blend"}, {},
      "between three guides; as a wisp, beside the nearest guide; the first at roots, the second at tips");
  keys.number("spread", made.spread, {.least = 0, .most = 100},
              "how wide wisps are at their tips, over how wide they are at their roots");
  keys.number("jitter", made.jitter, {.least = 0, .most = 1},
              "each strand's spread is larger or smaller by up to this part");
  keys.number("length", made.length, {.least = 0, .most = 0.9},
              "each strand is larger or smaller by up to this part");
  keys.whole("seed", made.seed, {.least = 0, .most = kLargestSeed},
             "of jitter, length, clumps and fly-aways");
  keys.whole("rows", text.rows, {.least = 1, .most = 1000},
             "so many groups, which are lists of roots, are guides together: this one, and those before it");
  keys.whole("clump", made.clump, {.least = 0, .most = kMostDense},
             "strands grow towards a common one, about so many together; 0: no clumps");
  keys.number("gathered", text.gathered, {.least = 0, .most = 1}, "how much of the way to that one a tip is");
  keys.number("fly_aways", made.fly_aways, {.least = 0, .most = 1},
              "this part of the strands stands out from the others, in no clump");
}

void add_synthesis(const JsonValue& object, const SynthesisText& text, GroupScalp scalp, Reading& reading) {
  const std::size_t row = first_row(object, text.rows, reading);
  std::vector<GroupRoots>& groups = reading.groups;
  if (!groups.back().listed.empty()) {
    std::vector<RootFrame> roots;
    for (std::size_t i = row; i < groups.size(); ++i)
      roots.insert(roots.end(), groups[i].listed.begin(), groups[i].listed.end());
    scalp = scalp_of(roots);
  }
  reading.dense_points += static_cast<long>(text.strands) * groups.back().points;
  if (reading.dense_points > kMostDensePoints)
    object["strands"].fail("makes " + std::to_string(reading.dense_points) +
                           " points in all; a scene draws at most " + std::to_string(kMostDensePoints));

  DenseHair dense{groups[row].first, text.made, {}};
  SynthesisDescription& made = dense.description;
  made.points = groups.back().points;
  made.gathered = made.clump > 0 || object.has("gathered") ? text.gathered : 0;
  made.combed = scalp.combed;
  made.guides = std::move(scalp.guides);
  made.children = scalp.more(reading.made(text.strands), made.seed);
  if (made.children.empty())
    object.fail(
        "the roots are on a line, and have no room for more between them; give three at least that are not");
  if (groups.back().rider) dense.motion = groups.back().rider->motion;
  for (std::size_t i = row; i < groups.size(); ++i) groups[i].dense = true;
  reading.scene.dense.push_back(std::move(dense));
}

}  // namespace hair::json
