// STAFF ONLY. Tests that names are hidden in each spelling of downloads and tables, and that nothing else is.
#include "grader/roster/hidden_names.h"

#include <gtest/gtest.h>

namespace grader::inline roster {
namespace {

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
