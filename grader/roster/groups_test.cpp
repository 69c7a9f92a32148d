// STAFF ONLY. Tests that a group without members in the download gets them from the roster, and that no
// ambiguous name gives anybody a grade.
#include "grader/roster/groups.h"

#include <gtest/gtest.h>

#include "solver/test_refusal.h"

namespace grader::inline roster {
namespace {

using tests::says;

// Canvas exports a group set so, with people who are in no group.
const char* kCanvas =
    "name,canvas_user_id,user_id,login_id,sections,group_name,canvas_group_id,group_id\n"
    "\"Doe, Jane\",4713,900,jd,Lab A,Team 7,55,\n"
    "\"Lee, Sam\",4714,901,sl,Lab B,Team 7,55,\n"
    "\"Poe, Ann\",4715,902,ap,Lab A,\"Hair, wet\",56,\n"
    "\"Roe, Max\",4716,903,mr,Lab A,,,\n";

Roster roster_with(const std::string& text) {
  return Roster(parse_csv(text, "r.csv"));
}

std::string members(const HandIn& hand_in) {
  std::string all;
  for (const Owner& one : hand_in.owner.members) all += "[" + one.name + " " + one.id + "]";
  return all;
}

TEST(Groups, OfCanvasHaveTheRostersMembers) {
  const Roster roster = roster_with(kCanvas);
  EXPECT_EQ(roster.people()[0].section, "Lab A");
  EXPECT_EQ(roster.people()[0].id(IdKind::sis), "900");
  std::vector<HandIn> all = {{"team7_4714", {.name = "team7", .id = "4714"}, "canvas"},
                             {"hairwet_4715", {.name = "hairwet", .id = "4715"}, "canvas"},
                             {"roemax_4716", {.name = "roemax", .id = "4716"}, "canvas"}};
  const std::vector<std::string> said = find_members(all, roster).said;
  EXPECT_TRUE(all[0].owner.group);
  EXPECT_EQ(all[0].owner.name, "Team 7");
  EXPECT_EQ(all[0].owner.id, "4714") << "feedback goes to this one's attachment";
  EXPECT_EQ(members(all[0]), "[Doe, Jane 4713][Lee, Sam 4714]");
  EXPECT_EQ(members(all[1]), "[Poe, Ann 4715]");
  EXPECT_FALSE(all[2].owner.group);
  EXPECT_EQ(said,
            std::vector<std::string>{"2 hand-ins have names of the roster's groups and count for 3 people"});

  const ClassList list = class_list(roster, all);
  EXPECT_EQ(list.rows[0].hand_ins, std::vector<std::string>{"team7_4714"});
  EXPECT_EQ(list.rows[1].hand_ins, std::vector<std::string>{"team7_4714"});
  EXPECT_TRUE(list.strangers.empty());
  EXPECT_TRUE(list.absent().empty());
}

TEST(Groups, OfMoodleAreFoundWhateverTheirNumber) {
  // 4713 is a participant's number, and the group's.
  const Roster roster = roster_with(
      "Identifier,Full name,Email address,Groups\nParticipant 4713,Max Roe,m@u.de,Lab A\n"
      "Participant 4714,Jane Doe,j@u.de,\"Lab A, Team 7\"\nParticipant 4715,Sam Lee,s@u.de,\"Team 7, Lab "
      "B\"\n");
  std::vector<HandIn> all = {{"Team_7_4713", {.name = "Team 7", .id = "4713"}, "moodle"},
                             {"Team_8_4714", {.name = "Team 8", .id = "4714", .group = true}, "moodle"}};
  find_members(all, roster);
  EXPECT_EQ(members(all[0]), "[Jane Doe 4714][Sam Lee 4715]");
  EXPECT_EQ(members(all[1]), "");
  EXPECT_EQ(roster.people()[1].section, "Lab A, Team 7") << "Moodle's groups may be sections";
}

TEST(Groups, ANameThatIsAlsoSomethingElsesFindsNobody) {
  const auto said_of = [](const std::string& text, std::vector<HandIn> all) {
    const Membership found = find_members(all, roster_with(text));
    for (const HandIn& one : all) EXPECT_EQ(members(one), "") << one.name;
    return found.doubts.empty() ? found.said.empty() ? "" : found.said[0] : "look at " + found.doubts[0];
  };
  // A section of this name is not the owner.
  EXPECT_EQ(
      said_of("id,name,group\n1,Jane Doe,Lab A\n2,Sam Lee,Lab B\n",
              {{"laba_2", {.name = "laba", .id = "2"}, "canvas"}}),
      "look at laba_2: has the name of the roster's group Lab A, but does not count as that group's: Sam Lee "
      "handed it in, who "
      "is in another group of the roster or in none");
  const char* named_as_a_person = "id,name,group\n1,Jane Doe,Jane Doe\n2,Sam Lee,Jane Doe\n";
  for (const char* system : {"canvas", "folders"})
    EXPECT_TRUE(says(said_of(named_as_a_person, {{"x", {.name = "Jane Doe", .id = "1"}, system}}),
                     "a person of the roster has this name, too"));
  for (const char* system : {"canvas", "moodle"})
    EXPECT_TRUE(says(said_of("id,name,group\n1,Jane Doe,Team 11\n2,Sam Lee,Team 1-1\n3,Ann Poe,team 11\n",
                             {{"x", {.name = "team11", .id = "1"}, system}}),
                     "the group Team 1-1 would be called so, too"));
  // Canvas grades each member alone here.
  EXPECT_TRUE(says(said_of(kCanvas, {{"team7_4713", {.name = "team7", .id = "4713"}, "canvas"},
                                     {"team7_4714", {.name = "team7", .id = "4714"}, "canvas"}}),
                   "other hand-ins have its name, too"));
  EXPECT_EQ(said_of(kCanvas, {{"anon_x", {.name = "team7", .id = "x", .anonymous = true}, "canvas"}}), "");
  EXPECT_EQ(said_of("id,name\n1,Jane Doe\n", {{"team7", {.name = ""}, "folders"}}), "");
}

// The roster proves one reading of a name in Canvas's download, or none: then a person must look.
TEST(Groups, WhoseNamesEndInNumbersAreProvenByTheRoster) {
  const Roster with_groups = roster_with(
      "name,canvas_user_id,group_name\nAda Ada,1001,Group_1\nBob Bob,1002,Group_1\nCarl Carl,1003,Lab 2_3\n"
      "Mallory,4712,\n");
  const Roster without = roster_with("id,name\n1001,Ada Ada\n1002,Bob Bob\n4712,Mallory\n"),
               named = roster_with("name,email\nMallory,m@u.de\n");
  struct Case {
    const char* name;
    const Roster* roster;
    std::string owner;  // has name, number, "?" for a doubt
    std::string inside;
  };
  const std::vector<Case> cases = {
      {"group_1_1001_9001_conj_grad.cpp", &with_groups, "group_1 1001", "conj_grad.cpp"},
      {"group_1_1001_9001_conj_grad-2.cpp", &with_groups, "group_1 1001", "conj_grad.cpp"},
      {"group_1_1001_text.html", &with_groups, "group_1 1001", ""},
      {"lab2_3_1003_9001_handin.zip", &with_groups, "lab2_3 1003", "handin.zip"},
      {"group_1_1001_9001_conj_grad.cpp", &without, "group_1 1001?", "conj_grad.cpp"},
      {"group_1_1001_9001_conj_grad.cpp", nullptr, "group 1?", "9001_conj_grad.cpp"},
      {"group_1_2001_9001_conj_grad.cpp", &with_groups, "group_1 2001?", "conj_grad.cpp"},
      {"crew_1_2001_9001_conj_grad.cpp", &with_groups, "crew 1?", "9001_conj_grad.cpp"},
      // A student's name of a file gives it to nobody else.
      {"mallory_4712_9001_1001_conj_grad.cpp", &with_groups, "mallory 4712", "1001_conj_grad.cpp"},
      {"mallory_4712_1001_9001_conj_grad.cpp", &with_groups, "mallory 4712", "9001_conj_grad.cpp"},
      {"mallory_4712_1001_9001_conj_grad.cpp", &named, "mallory 4712", "9001_conj_grad.cpp"},
  };
  for (const Case& one : cases) {
    const KnownOwner known = one.roster ? known_by(*one.roster) : KnownOwner();
    const NamedPath found = told_by_name(one.name, false, known).value().named;
    EXPECT_EQ(found.owner.name + " " + found.owner.id + (found.doubt.empty() ? "" : "?"), one.owner)
        << one.name;
    EXPECT_EQ(found.inside, one.inside) << one.name;
  }
}

TEST(Groups, MembersThatADownloadSaysStay) {
  std::vector<HandIn> all = {
      {"x", {.name = "Team 7", .group = true, .members = {{.name = "Y", .email = "y@u.de"}}}, "gradescope"}};
  EXPECT_TRUE(find_members(all, roster_with(kCanvas)).said.empty());
  EXPECT_EQ(members(all[0]), "[Y ]");
}

}  // namespace
}  // namespace grader::roster
