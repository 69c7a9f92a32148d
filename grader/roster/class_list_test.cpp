// STAFF ONLY. Tests that each person on the roster has a row, and each hand-in a person or a stranger; and
// that names are hidden in each spelling of downloads and tables, and nothing else is.
#include "grader/roster/class_list.h"
#include "grader/roster/hidden_names.h"

#include <gtest/gtest.h>

namespace grader::inline roster {
namespace {

using Names = std::vector<std::string>;

TEST(ClassList, HasEverybodyAndListsStrangersApart) {
  const Roster roster(parse_csv("id,name\n1,A\n2,B\n3,C\n", "r.csv"));
  const Owner team{.name = "Team 7",
                   .id = "70",
                   .email = "",
                   .group = true,
                   .members = {{"A", "1", ""}, {"", "2", ""}, {"X", "9", ""}}};
  const ClassList list = class_list(roster, {{"team7", team, "canvas"},
                                             {"team7", team, "canvas"},  // as in another week
                                             {"b_2", {"", "2", ""}, "canvas"},
                                             {"z_8", {"Z", "8", ""}, "canvas"}});
  ASSERT_EQ(list.rows.size(), 3u);
  EXPECT_EQ(list.rows[0].hand_ins, Names{"team7"});
  EXPECT_EQ(list.rows[1].hand_ins, (Names{"team7", "b_2"}));
  ASSERT_EQ(list.absent().size(), 1u);
  EXPECT_EQ(list.absent()[0]->name, "C");
  ASSERT_EQ(list.strangers.size(), 2u);
  EXPECT_EQ(list.strangers[0].hand_in, "team7");
  EXPECT_EQ(list.strangers[0].owner.name, "X");
  EXPECT_EQ(list.strangers[1].hand_in, "z_8");
  EXPECT_EQ(
      list.to_look_at,
      (Names{
          "B: has two hand-ins, team7 and b_2",
          "nobody on the roster is found for 2 of those who handed in, while these of the roster handed in "
          "nothing: C (3); a roster whose column \"id\" has the download's numbers tells who is who"}));
}

// Moodle's names carry a number of its own.
TEST(ClassList, NamesakesAreFoundByANumberOrAPersonMustLook) {
  const auto handed_in = [](const std::string& roster, const std::string& system = "moodle") {
    const ClassList list =
        class_list(Roster(parse_csv(roster, "r.csv")), {{"a", {.name = "Wei Li", .id = "4714"}, system},
                                                        {"b", {.name = "Wei Li", .id = "4715"}, system},
                                                        {"c", {.name = "Ana Adams", .id = "4711"}, system}});
    std::string all;
    for (const ClassList::Row& row : list.rows)
      for (const std::string& one : row.hand_ins)
        all += one + "=" + row.person.ids[0] + row.person.ids[4] + " ";
    return all + (list.to_look_at.empty() ? "" : list.to_look_at.back().substr(34, 3));
  };
  EXPECT_EQ(handed_in("id,name\n4715,\"Li, Wei\"\n4714,Wei Li\n4711,\"Adams, Ana\"\n"),
            "b=4715 a=4714 c=4711 ");
  EXPECT_EQ(handed_in("Identifier,Full name\nParticipant 4714,Wei Li\nParticipant 4715,Wei Li\n"),
            "a=4714 b=4715 ")
      << "nobody is missing";
  EXPECT_EQ(handed_in("id,name\n900,Wei Li\n901,Wei Li\n902,Ana Adams\n"), "c=902 2 o");
  EXPECT_EQ(handed_in("id,name\n4714,Wei Li\n901,Wei Li\n902,Ana Adams\n"), "a=4714 c=902 1 o");
  EXPECT_EQ(handed_in("id,name\n4714,Bo Ek\n4711,Ana Adams\n"), "c=4711 2 o") << "the names differ";
}

// A group hands in under one member's number, and the roster has no groups.
TEST(ClassList, AnotherNameIsLookedAtWhileSomebodyIsMissing) {
  const HandIn team{"team7_1", {.name = "team7", .id = "1"}, "canvas"};
  const auto list = [&](const char* roster) {
    return class_list(Roster(parse_csv(roster, "r.csv")), {team});
  };
  EXPECT_EQ(list("id,name\n1,A\n2,B\n").to_look_at.size(), 1U);
  EXPECT_EQ(list("id,name\n1,A\n").to_look_at.size(), 0U);
}

std::vector<Names> cells_of(const std::vector<ClassLine>& lines) {
  std::vector<Names> cells;
  for (const ClassLine& line : lines)
    cells.push_back({line.hand_in, line.name, line.id, line.section, line.note});
  return cells;
}

TEST(ClassList, GivesEverybodyALine) {
  const Roster roster(parse_csv("id,name,section\n1,A,x\n3,C,y\n", "r.csv"));
  const Owner team{
      .name = "Team 7", .id = "70", .email = "", .group = true, .members = {{"A", "1", ""}, {"X", "9", ""}}};
  const std::vector<HandIn> hand_ins{{"team7", team, "canvas"},
                                     {"z_8", {"Z", "8", ""}, "canvas"},
                                     {"old", {}, ""},
                                     {"f", {.name = "F"}, "folders"}};
  EXPECT_EQ(cells_of(lines_of(class_list(roster, hand_ins), hand_ins)),
            (std::vector<Names>{{"team7", "A", "1", "x", ""},
                                {"", "C", "3", "y", "nothing handed in"},
                                {"team7", "X", "9", "", "its name is on no roster"},
                                {"z_8", "Z", "8", "", "its name is on no roster"},
                                {"old", "", "", "", "its id is on no roster"},
                                {"f", "F", "", "", "its name is on no roster"}}));
  EXPECT_EQ(cells_of(lines_of({}, hand_ins)),
            (std::vector<Names>{
                {"team7", "A", "1", "", ""}, {"team7", "X", "9", "", ""}, {"z_8", "Z", "8", "", ""}}));
}

TEST(ClassList, NamesPeopleAsTheyAreReadAndNobodyTwice) {
  const Roster roster(parse_csv("id,name\n1,\"Mu\xcc\x88ller, A\"\n2,B\n", "r.csv"));
  const Owner team{.name = "Team 7", .group = true, .members = {{.id = "1"}, {.name = "B", .id = "2"}}};
  const Owner joined{.name = "A, B", .group = true, .members = {{.name = "A"}, {.name = "B"}}};
  const std::vector<HandIn> hand_ins{{"mullera_1", {.name = "müllera", .id = "1"}, "canvas"},
                                     {"team7", team, "canvas"},
                                     {"pair", joined, "gradescope"},
                                     {"x", {.name = "x"}, "canvas"},
                                     {"folder", {.name = "folder"}, "folders"}};
  EXPECT_EQ(
      names_for_people(class_list(roster, hand_ins), hand_ins),
      (NamesForPeople{{"mullera_1", "Müller, A"}, {"team7", "Team 7 (Müller, A; B)"}, {"pair", "B; A"}}));
  const NamesForPeople without = names_for_people({}, hand_ins);
  EXPECT_EQ(without.at("mullera_1"), "müllera");
  EXPECT_EQ(called("mullera_1", without), "müllera (mullera_1)");
  EXPECT_EQ(called("folder", without), "folder");
}

HiddenNames two_people() {
  const std::vector<HandIn> hand_ins{
      {"code-1", {.name = "müllerlüdenscheidtjörg", .id = "4711"}, "canvas", "mullerludenscheidtjorg_4711"},
      {"code-2", {.name = "Jane Doe", .id = "12", .email = "jd@u.de"}, "moodle", "Jane_Doe_12"}};
  const Roster roster(parse_csv(
      "id,sis user id,name\n4711,ab123,\"Müller-Lüdenscheidt, Jörg\"\n12,,\n99,,Adam Away\n", "r.csv"));
  return {hand_ins, class_list(roster, hand_ins)};
}

TEST(HiddenNames, InEachSpelling) {
  const HiddenNames hidden = two_people();
  for (const char* name :
       {"müllerlüdenscheidtjörg", "mullerludenscheidtjorg_4711", "Müller-Lüdenscheidt, Jörg", "4711", "ab123",
        "Jörg Müller-Lüdenscheidt", "Jorg Muller-Ludenscheidt"})
    EXPECT_EQ(hidden.in("a " + std::string(name) + "."), "a code-1.") << name;
  for (const char* name : {"Jane Doe", "jane doe", "JANE_DOE", "Jane_Doe_12", "jd@u.de", "janedoe"})
    EXPECT_EQ(hidden.in("class/" + std::string(name) + "_x"), "class/code-2_x") << name;
  EXPECT_EQ(hidden.in("Adam Away: nothing"), "somebody: nothing");
  EXPECT_EQ(hidden.in("Jane_Doe_12/jane-notes.txt"), "code-2/code-2-notes.txt");
}

TEST(HiddenNames, OnlyAsWords) {
  const HiddenNames hidden = two_people();
  for (const char* text : {"47110 points", "xjane doe", "12 of 14", "Jane", "müller"})
    EXPECT_EQ(hidden.in(text), text);
}

TEST(HiddenNames, SingleNamesInWhatIsTheirs) {
  const HiddenNames hidden = two_people();
  EXPECT_EQ(hidden.in_own("// Jörg was here, jorg too", "code-1"), "// code-1 was here, code-1 too");
  EXPECT_EQ(hidden.in_own("Jane", "code-2"), "code-2");
  EXPECT_EQ(hidden.in_own("Jane", "code-1"), "Jane");
  EXPECT_EQ(hidden.in_own("with Jane Doe", "code-1"), "with code-2");
}

}  // namespace
}  // namespace grader::roster
