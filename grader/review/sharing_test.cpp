// STAFF ONLY. Tests that items are shared out fairly, and stay where they are.
#include "grader/review/sharing.h"

#include <gtest/gtest.h>

namespace grader::inline review {
namespace {

Item item(const std::string& place, std::vector<std::string> people, const std::string& owner = "") {
  Item one{.kind = ItemKind::blown_up, .place = place, .people = std::move(people), .owner = owner};
  one.is_group = one.people.size() > 1;
  return one;
}

// Writes the items of each TA after sharing.
std::string shared(std::vector<Item>& items, const std::vector<std::string>& graders, ShareBy by,
                   const std::vector<ClassLine>& people = {}) {
  const std::map<RowOfItem, std::string> owners = shared_out(items, graders, by, people);
  std::map<std::string, std::string> of;
  for (Item& one : items) {
    if (const auto owner = owners.find(one.row()); owner != owners.end()) one.owner = owner->second;
    std::string& text = of[one.owner];
    text += " " + one.place;
    for (const std::string& name : one.people) text += name;
  }
  std::string all;
  for (const auto& [who, text] : of) all += who + ":" + text + "\n";
  return all;
}

TEST(Sharing, IsEvenAndAPersonsItemsAreOneTas) {
  std::vector<Item> items = {item("1", {"a"}), item("1", {"b"}), item("1", {"c"}), item("2", {"a"}),
                             item("1", {"d"}), item("2", {"d"}), item("1", {"e"})};
  EXPECT_EQ(shared(items, {"ada", "bob"}, ShareBy::evenly), "ada: 1a 1c 2a 1e\nbob: 1b 1d 2d\n");
  // Nothing changes for the rest when items go and come.
  items.erase(items.begin() + 1, items.begin() + 3);
  items.insert(items.begin(), {item("1", {"f"}), item("3", {"d"})});
  EXPECT_EQ(shared(items, {"ada", "bob"}, ShareBy::evenly), "ada: 1a 2a 1e\nbob: 1f 3d 1d 2d\n");
  // A TA who leaves has none any more, one who comes gets only what is free.
  EXPECT_EQ(shared(items, {"cy", "ada"}, ShareBy::evenly), "ada: 1a 2a 1e\ncy: 1f 3d 1d 2d\n");
  EXPECT_EQ(shared(items, {}, ShareBy::evenly), "ada: 1a 2a 1e\ncy: 1f 3d 1d 2d\n");
}

TEST(Sharing, IsBySectionsWhicheverItemsThereAre) {
  std::vector<ClassLine> people;
  for (const auto& [hand_in, section] : std::vector<std::pair<std::string, std::string>>{
           {"a", "T1"}, {"b", "T1"}, {"c", "T1"}, {"d", "T2"}, {"e", "T3"}, {"f", "T3"}, {"x", ""}})
    people.push_back({hand_in, hand_in, hand_in, "", section, ""});
  std::vector<Item> items = {item("1", {"f"}),           item("1", {"a"}),
                             item("1", {"d"}),           item("1", {"x"}),
                             item("2", {"a", "d", "e"}), item("3", {"b", "c", "e"}),
                             item("4", {"a"}, "bob"),    item("5", {"a", "b", "c"}, "bob")};
  EXPECT_EQ(shared(items, {"ada", "bob"}, ShareBy::section, people),
            "ada: 1a 1x 3bce\nbob: 1f 1d 2ade 4a 5abc\n")
      << "three people each; most of a group count";
}

TEST(Sharing, SaysHowFarEachIs) {
  std::vector<Item> items = {item("1", {"a"}, "ada"), item("2", {"a"}, "ada"), item("1", {"b"}, "bob"),
                             item("1", {"c"})};
  items[0].decided_by = "bob";
  const std::map<RowOfItem, DeskRow> rows = {
      {items[0].row(), {"x", "bob"}}, {{"conflict S1", "a"}, {"x", "bob"}}, {{"changed", "a"}, {"x"}}};
  std::string all;
  for (const ProgressOfTa& one : progress(items, rows))
    all += one.who + " " + std::to_string(one.decided) + " of " + std::to_string(one.items) + ", " +
           std::to_string(one.has_decided) + "\n";
  EXPECT_EQ(all, " 0 of 1, 0\nada 1 of 2, 0\nbob 0 of 1, 2\n") << "also one that has left the list";
}

}  // namespace
}  // namespace grader::review
