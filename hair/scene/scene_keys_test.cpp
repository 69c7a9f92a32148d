// STAFF ONLY. Reading, errors and tables follow from a key's declaration alone.
#include <gtest/gtest.h>

#include "hair/io/files/bad_input.h"
#include "hair/scene/json/keys.h"
#include "hair/scene/scene.h"
#include "solver/test_refusal.h"

namespace reference_tests {
namespace {

using Eigen::Vector3d;
using hair::json::Keys, hair::json::object;

enum class Fur { smooth, rough };

struct Ear {
  double tip;
};

void keys_of(Keys& keys, Ear& ear) {
  keys.one_of();
  keys.number({.name = "tip", .least = 0, .most = 1}, ear.tip);
}

struct Cat {
  std::string name;
  Vector3d place;
  double weight = 4.5;
  std::optional<long> lives;
  std::optional<Vector3d> way;
  bool tame = true;
  Fur fur = Fur::rough;
  std::optional<Ear> ear;
  std::optional<hair::JsonValue> kittens;
};

void keys_of(Keys& keys, Cat& cat) {
  keys.about("It says so.");
  keys.text({.name = "name", .needed = true, .what = "that it hears"}, cat.name);
  keys.vector({.name = "place", .unit = "m", .needed = true, .least = -2, .most = 2}, cat.place);
  keys.number({.name = "weight", .unit = "kg", .least = 0.1, .most = 10}, cat.weight);
  keys.whole({.name = "lives", .least = 1, .most = 9, .otherwise = "nobody knows"}, cat.lives);
  keys.direction({.name = "way"}, cat.way);
  keys.flag({.name = "tame"}, cat.tame);
  keys.word({.name = "fur"}, {"smooth", "rough"}, cat.fur);
  keys.part({.name = "ear"}, cat.ear);
  keys.list({.name = "kittens", .otherwise = "none"}, cat.kittens, {object<Ear>(" of which little is seen")});
}

hair::JsonDocument document_of(const std::string& text) {
  return hair::parse_document(text, "cat.json");
}

Cat cat_of(const hair::JsonDocument& document) {
  return hair::json::read<Cat>(hair::JsonValue(*document, "cat.json"));
}

std::string complaint_of(const std::string& text) {
  return tests::refusal<hair::BadInput>([&] { cat_of(document_of(text)); });
}

TEST(SceneKeys, OfAnObjectSetWhatItHasAndLeaveTheDefaults) {
  const Cat few = cat_of(document_of(R"({"name": "Tom", "place": [0, 1, 2]})"));
  EXPECT_EQ(few.name, "Tom");
  EXPECT_EQ(few.place, Vector3d(0, 1, 2));
  EXPECT_EQ(few.weight, 4.5);
  EXPECT_FALSE(few.lives || few.way || few.ear || few.kittens);
  EXPECT_TRUE(few.tame);
  EXPECT_EQ(few.fur, Fur::rough);
  const hair::JsonDocument document =
      document_of(R"({"name": "Tom", "place": [0, 1, 2], "weight": 3, "lives": 7,
    "way": [0, 4, 0], "tame": false, "fur": "smooth", "ear": {"tip": 0.5}, "kittens": [1]})");
  const Cat all = cat_of(document);
  EXPECT_EQ(all.weight, 3);
  EXPECT_EQ(all.lives, 7);
  EXPECT_EQ(all.way, Vector3d(0, 1, 0));
  EXPECT_FALSE(all.tame);
  EXPECT_EQ(all.fur, Fur::smooth);
  EXPECT_EQ(all.ear->tip, 0.5);
  EXPECT_EQ(all.kittens->items().size(), 1U);
}

TEST(SceneKeys, WrongOnesAreNamedWithWhatTheDeclarationsAllow) {
  const std::string known = "name, place, weight, lives, way, tame, fur, ear, kittens";
  const auto said = [](const std::string& more) {
    return complaint_of(R"({"name": "Tom", "place": [0, 1, 2], )" + more + "}");
  };
  EXPECT_EQ(complaint_of(R"({"name": "Tom"})"),
            "cat.json: \"place\" is missing; an object here has: " + known);
  EXPECT_EQ(said(R"("age": 3)"), "cat.json: unknown key \"age\"; known here: " + known);
  EXPECT_EQ(said(R"("weight": 11)"), "cat.json: weight: 11 is not right; give a number from 0.1 to 10");
  EXPECT_EQ(said(R"("lives": 0)"), "cat.json: lives: 0 is not right; give a whole number from 1 to 9");
  EXPECT_EQ(said(R"("way": [0, 0, 0])"), "cat.json: way: has no direction; give one that is not [0, 0, 0]");
  EXPECT_EQ(said(R"("fur": "none")"), "cat.json: fur: \"none\" is not right; write one of: smooth, rough");
  EXPECT_EQ(said(R"("ear": {})"), "cat.json: ear: has 0 keys; give one of: tip");
  EXPECT_EQ(complaint_of(R"({"name": "Tom", "place": [0, 1, 3]})"),
            "cat.json: place[2]: 3 is not right; give a number from -2 to 2");
}

TEST(SceneKeys, AreInTablesAsTheyAreDeclared) {
  EXPECT_EQ(hair::json::key_tables(object<Cat>(), "A cat"), R"(## A cat

It says so.

| key | unit | default | bounds | what |
|---|---|---|---|---|
| `name` | | needed | | that it hears |
| `place` | m | needed | -2 to 2 | |
| `weight` | kg | 4.5 | 0.1 to 10 | |
| `lives` | | nobody knows | whole, 1 to 9 | |
| `way` | | | -1000000 to 1000000 | |
| `tame` | | true | true, false | |
| `fur` | | rough | smooth, rough | |
| `ear` | | | | |
| `kittens` | | none | | |

## `ear`

One of:

| key | unit | default | bounds | what |
|---|---|---|---|---|
| `tip` | | 0 | 0 to 1 | |

## `kittens[]` of which little is seen

One of:

| key | unit | default | bounds | what |
|---|---|---|---|---|
| `tip` | | 0 | 0 to 1 | |

)");
}

TEST(SceneKeys, OfAllObjectsOfASceneHaveASection) {
  const std::string tables = hair::scene_keys();
  for (const char* section :
       {"The scene", "`hair[]`", "`hair[]` with a groom", "`hair[].groom`", "`hair[].groom` that grows",
        "`hair[].material`", "`hair[].roots.list[]`", "`hair[].shape.curly`", "`links.strips`",
        "`obstacles[].bust`", "`motions[].keys[]`", "`toys[]`", "`toys[]` with a cloth",
        "`toys[].particles[]`", "`still_hair[]`", "`render`"}) {
    const std::string heading = "\n## " + std::string(section) + "\n";
    const std::size_t at = tables.find(heading);
    ASSERT_NE(at, std::string::npos) << section;
    EXPECT_EQ(tables.find(heading, at + 1), std::string::npos) << section << " stands twice";
  }
  EXPECT_NE(tables.find("| `tolerance` | | 1e-10 | 1e-15 to 1 | of an implicit solve"), std::string::npos)
      << tables;
  EXPECT_NE(tables.find("| `count` | | needed | whole, 1 to 10000000 | |"), std::string::npos) << tables;
}

}  // namespace
}  // namespace reference_tests
