// STAFF ONLY. Tests that rosters are read as systems export them and as spreadsheets write them again, and
// that nobody is taken for somebody else.
#include "grader/roster/roster.h"

#include <gtest/gtest.h>

#include "grader/course/input.h"
#include "grader/text/letters.h"
#include "solver/test_refusal.h"

namespace grader::inline roster {
namespace {

using std::string;
using tests::says;

Roster roster_of(const string& text) {
  return Roster(parse_csv(text, "roster.csv"));
}

string error_of(const string& text) {
  return tests::refusal<BadInput>([&] { roster_of(text); });
}

// Returns the person's name, or why there is none.
string found(const Roster& roster, const Owner& owner, const string& system) {
  const Roster::Match match = roster.find(owner, system);
  return match.person ? roster.people()[*match.person].name : "nobody: " + match.told;
}

TEST(Roster, ReadsWhatSystemsExport) {
  struct Example {
    const char *system, *text;
    Owner owner;
    const char* name;
  };
  const std::vector<Example> examples = {
      {"canvas",
       "Student,ID,SIS User ID,SIS Login ID,Section,Lab 3 (8801)\n,,,,,Manual Posting\n    Points "
       "Possible,,,,,10\n"
       "\"O'Brien, Seán\",4712,9,so12,Lab A,7.5\n",
       {"obrienseán", "4712", ""},
       "O'Brien, Seán"},
      {"canvas",
       "Student,ID,SIS Login ID,Section\n\"Müller-Lüdenscheidt, Jörg\",4711,jm,A\n",
       {"müllerlüdenscheidtjörg", "", ""},
       "Müller-Lüdenscheidt, Jörg"},
      {"moodle",
       "Identifier,Full name,Email address,Status,Grade\nParticipant 4711,Jörg "
       "Müller-Lüdenscheidt,j@u.de,Submitted,\n",
       {"Jörg Müller-Lüdenscheidt", "4711", ""},
       "Jörg Müller-Lüdenscheidt"},
      {"moodle",
       "First name,Surname,ID number,Email address,Groups\nSea\xcc\x81n,O'Brien,77,so@u.ie,Team 7\n",
       {"Seán OBrien", "4712", ""},
       "Seán O'Brien"},
      {"gradescope",
       "First Name,Last Name,SID,Email,Sections\nSeán,O'Brien,so12,SO@u.ie,A\n",
       {"", "", "So@U.ie"},
       "Seán O'Brien"},
      {"classroom",
       "identifier,github_username,github_id,name\nso@u.ie,SeanOB,123,Seán\n",
       {"", "seanob", ""},
       "Seán"},
      {"brightspace",
       "OrgDefinedId,Username,Last Name,First Name,End-of-Line Indicator\n#400123,#so12,O'Brien,Seán,#\n",
       {"Seán O'Brien", "400123", ""},
       "Seán O'Brien"},
      {"blackboard",
       "Last Name,First Name,Username,Student ID\nO'Brien,Seán,so12,9\n",
       {"", "so12", ""},
       "Seán O'Brien"},
      {"autolab", "email,first_name\nso@u.ie,x\n", {"", "so@u.ie", ""}, ""},
      {"folders", "id,name\n4711,A\n4712,B\n", {"4712", "", ""}, "B"},
  };
  for (const Example& example : examples)
    EXPECT_EQ(found(roster_of(example.text), example.owner, example.system), example.name) << example.text;
}

TEST(Roster, PointsRowsAreNobody) {
  EXPECT_EQ(roster_of("Student,ID,Section\n    Points Possible,,\nA,1,x\n").people().size(), 1u);
}

TEST(Roster, ZerosInFrontComeBackAndAreSaid) {
  const Roster roster = roster_of("id;name\r\n4711;A\r\n04712;B\r\n");
  const auto match = roster.find({"", "004711", ""}, "canvas");
  ASSERT_TRUE(match.person);
  EXPECT_EQ(match.told, "id 004711 is 4711 on the roster: they differ by zeros in front");
  EXPECT_EQ(roster.find({"", "04712", ""}, "canvas").told, "");
  EXPECT_EQ(found(roster_of("id,name\n07,A\n007,B\n"), {"", "7", ""}, "canvas"),
            "nobody: its ids name 2 people on the roster");
  EXPECT_EQ(found(roster_of("id,name\n07,A\n007,B\n"), {"", "007", ""}, "canvas"), "B");
}

// A spreadsheet or a page may have added invisible letters on either side.
TEST(Roster, AnIdHasOneForm) {
  for (const char* form :
       {"1001", "1001.0", "1001.00", "1001,0", "=\"1001\"", "\u200b1001", "10\u00ad01", "1001\ufeff",
        "\u00a01001", "1\u202f001", "\u2060=\"1001\"", "1001\u200d", "1001\ufe0f"}) {
    SCOPED_TRACE(legible(form));
    const Roster roster = roster_of("id;name\n" + csv_line({form, "A"}, ';') + "1002;B\n");
    EXPECT_EQ(found(roster, {.id = "1001"}, "canvas"), "A");
    EXPECT_EQ(found(roster_of("id,name\n1001,A\n"), {.id = form}, "canvas"), "A");
  }
  EXPECT_EQ(found(roster_of("login,name\n1001.5,A\na.0,B\n"), {.id = "1001"}, "folders"),
            "nobody: its id 1001 is on no roster");
  EXPECT_EQ(found(roster_of("id,name\n1,A\n"), {.id = "\u202e1"}, "canvas"), "A");
  EXPECT_EQ(found(roster_of("id,name\n1,A\n"), {.id = "x\uff11"}, "canvas"),
            "nobody: its id x１ is on no roster");
}

TEST(Roster, NumbersThatASpreadsheetChangedAreSaidAndFindNobody) {
  const Roster roster =
      roster_of("id,name\n12345678901234500,A\n1.23457E+11,B\n123456789012345,C\n12345678901234567,D\n");
  ASSERT_EQ(roster.said().size(), 2u);
  EXPECT_TRUE(says(roster.said()[0], "line 2: id 12345678901234500 has only zeros beyond its 15th digit"));
  EXPECT_TRUE(says(roster.said()[1], "line 3: id 1.23457E+11 is a shortened number"));
  EXPECT_EQ(found(roster, {"", "12345678901234500", ""}, "canvas"),
            "nobody: its id 12345678901234500 is on no roster");
  EXPECT_EQ(found(roster, {"", "12345678901234567", ""}, "canvas"), "D");
}

TEST(Roster, AnIdIsOnePersons) {
  EXPECT_EQ(
      error_of("id,login,name\n1,a,A\n2,b,B\n1,b,A\n"),
      "roster.csv, line 4: its id is line 2's and its login line 3's; all ids of a row are one person's");
  EXPECT_EQ(error_of("id,login,name\n1,a,A\n1,c,A\n"),
            "roster.csv, line 3: id 1 is line 2's, too, with another login; an id is one person's");
  EXPECT_EQ(error_of("id,name\n1,A\n1,B\n"),
            "roster.csv, line 3: id 1 is line 2's, too, with another name; an id is one person's");
  EXPECT_EQ(error_of("name,email\nA,x@u.de\nB,X@u.de\n"),
            "roster.csv, line 3: e-mail x@u.de is line 2's, too, with another name; an id is one person's");
  const Roster sections = roster_of("id,name,section\n1,A,x\n1,A,y\n1,A,\"x, y\"\n");
  ASSERT_EQ(sections.people().size(), 1u);
  EXPECT_EQ(sections.people()[0].section, "x, y");
  EXPECT_EQ(sections.said(), Cells{"roster.csv, line 4: is line 2's person again, who counts once"});
}

TEST(Roster, ANameThatTwoBearFindsNobody) {
  const Roster roster = roster_of("id,name\n1,\"Li, Wei\"\n2,Wei Li\n3,Ann Oh\n");
  EXPECT_EQ(found(roster, {"liwei", "", ""}, "canvas"), "nobody: 2 people on the roster bear its name");
  EXPECT_EQ(found(roster, {"liwei", "2", ""}, "canvas"), "Wei Li");
  EXPECT_EQ(found(roster, {"ohann", "9", ""}, "canvas"),
            "nobody: its name is Ann Oh's on the roster, whose id is 3 and not 9");
  EXPECT_EQ(found(roster, {"Ann Oh", "9", ""}, "moodle"),
            "Ann Oh");  // a participant's number is no id of this roster
  EXPECT_EQ(roster.find({"Ann Oh", "9", ""}, "moodle").told, "found by its name alone: Ann Oh");
  EXPECT_EQ(found(roster, {"", "", ""}, "canvas"), "nobody: its id is on no roster");
  EXPECT_EQ(found(roster, {.name = "Ann Oh", .id = "3", .email = "", .group = true}, "canvas"),
            "nobody: a group is nobody on the roster");
  EXPECT_EQ(found(roster, {.name = "", .id = "aB3dE", .email = "", .anonymous = true}, "canvas"),
            "nobody: its code is on no roster");
}

TEST(Roster, TwoIdsOfAHandInThatNameDifferentPeopleFindNobody) {
  const Roster roster = roster_of("SID,name,email\n1,A,a@u.de\n2,B,b@u.de\n");
  EXPECT_EQ(found(roster, {"A", "1", "b@u.de"}, "gradescope"), "nobody: its ids name 2 people on the roster");
  EXPECT_EQ(found(roster, {"A", "1", "a@u.de"}, "gradescope"), "A");
  EXPECT_EQ(found(roster, {"A", "", "c@u.de"}, "gradescope"),
            "nobody: its name is A's on the roster, with another e-mail");
}

TEST(Roster, IdsOfOtherKindsAreNotCompared) {
  const Roster roster = roster_of("Identifier,id,name\nParticipant 4711,1,A\nParticipant 1,4711,B\n");
  EXPECT_EQ(found(roster, {"", "4711", ""}, "moodle"), "A");
  EXPECT_EQ(found(roster, {"", "4711", ""}, "canvas"), "B");
  EXPECT_EQ(found(roster_of("Identifier,name\nParticipant 4711,A\n"), {"", "4711", ""}, "canvas"),
            "nobody: its id 4711 is on no roster");
}

TEST(Roster, AnIdWhoseHandInHasAnotherNameIsSaid) {
  const Roster roster = roster_of("id,name\n4713,\"Oh, Ann\"\n");
  EXPECT_EQ(roster.find({"ohann", "4713", ""}, "canvas").told, "");
  EXPECT_EQ(roster.find({"Ann Oh", "4713", ""}, "folders").told, "");
  EXPECT_EQ(roster.find({"team7", "4713", ""}, "canvas").told,
            "its id is Oh, Ann's on the roster, and its name is team7: perhaps a group's");
}

TEST(Roster, PeopleOfAnotherTableAreFoundByAnIdThatBothHave) {
  const Roster roster = roster_of("id,login,name\n1,a,A\n2,b,B\n"),
               other = roster_of("login,github_username\nb,x\nz,y\n");
  EXPECT_EQ(roster.find(other.people()[0]).person, 1u);
  EXPECT_EQ(roster.find(other.people()[1]).person, std::nullopt);
  EXPECT_EQ(roster.find(roster_of("id,login\n1,b\n").people()[0]).person, std::nullopt);
}

TEST(Roster, SaysWhatIsWrongWithATable) {
  EXPECT_EQ(error_of("id,name\n"),
            "roster.csv: nobody stands below the titles; a roster has a row for each person");
  EXPECT_TRUE(says(error_of("foo,bar\n1,2\n"), "roster.csv, line 1: no title is known"));
  EXPECT_EQ(error_of("id,name,ID\n1,A,2\n"), "roster.csv, line 1: two columns are called \"ID\"; rename one");
}

}  // namespace
}  // namespace grader::roster
