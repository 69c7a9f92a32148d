// STAFF ONLY. Tests that times of hand-ins are found as people on a roster are, and that missing or
// unreadable ones are reported.
#include "grader/roster/times.h"
#include "grader/course/input.h"
#include "solver/test_refusal.h"

#include <gtest/gtest.h>

namespace grader::inline roster {
namespace {

using tests::says;

Times times(const std::string& text) {
  return Times(parse_csv(text, "times.csv"));
}

bool says(const Times& times, const std::string& what) {
  for (const std::string& line : times.said())
    if (line.find(what) != std::string::npos) return true;
  return false;
}

std::string refusal_of(const std::string& text) {
  return tests::refusal<BadInput>([&] { times(text); });
}

TEST(Times, AreFoundByIdOrByANameThatOnePersonBears) {
  Times list = times(
      "id,name,time\n4711,Jane Doe,2025-03-04 10:15\n4712,Sam Lee,2025-03-05T01:00:00Z\n4713,Sam "
      "Lee,2025-03-04 "
      "09:00\n4714,Ann Poe,\n");
  EXPECT_EQ(list.find("a", {.name = "Doe Jane", .id = "4711"}, "canvas", nullptr), "2025-03-04 10:15");
  EXPECT_EQ(list.find("b", {.id = "4712"}, "folders", nullptr), "2025-03-05T01:00:00Z");
  EXPECT_EQ(list.find("c", {.name = "Sam Lee"}, "folders", nullptr), "");
  EXPECT_TRUE(says(list, "c: in times.csv: 2 people on the roster bear its name"));
  EXPECT_EQ(list.find("d", {.id = "4714"}, "folders", nullptr), "-");
  EXPECT_EQ(list.find("e", {.id = "4715"}, "folders", nullptr), "");
  EXPECT_TRUE(says(list, "line 4: Sam Lee has a time, and no hand-in here"));
  EXPECT_FALSE(says(list, "Ann Poe"));
}

TEST(Times, OfMoodlesWorksheetAreRead) {
  Times list = times(
      "Identifier,Full name,Status,\"Last modified (submission)\"\n"
      "Participant 4711,Jane Doe,x,\"Tuesday, 4 March 2025, 10:15 AM\"\n"
      "Participant 4712,Sam Lee,x,\"wtorek, 4 marca 2025, 10:15\"\nParticipant 4713,Ann Poe,x,-\n");
  EXPECT_EQ(list.find("a", {.name = "Jane Doe", .id = "4711"}, "moodle", nullptr),
            "Tuesday, 4 March 2025, 10:15 AM");
  for (const char* hand_in : {"b", "b, handed in again"})
    EXPECT_EQ(list.find(hand_in, {.name = "Sam Lee", .id = "4712"}, "moodle", nullptr), "");
  EXPECT_EQ(list.find("c", {.name = "Ann Poe", .id = "4713"}, "moodle", nullptr), "-");
  ASSERT_EQ(list.said().size(), 1U) << "a cell is said once";
  EXPECT_TRUE(says(list, "times.csv, line 3: \"wtorek, 4 marca 2025, 10:15\" is no time that is read"));
}

// Writes a worksheet's row: the cells behind the grade, in any language.
std::string worksheet(const std::string& titles, const std::string& word, const std::string& yes,
                      const std::string& first, const std::string& second) {
  const auto row = [&](const char* number, const char* name, const std::string& time) {
    return word + " " + number + "," + name + ",x,,\"10,00\"," + yes + ",\"" + time + "\",-,\n";
  };
  return titles + "\n" + row("4711", "Jane Doe", first) + row("4712", "Sam Lee", second) +
         row("4713", "Ann Poe", "-");
}

TEST(Times, OfAWorksheetInAnotherLanguageStandBehindWhetherItsGradeCanChange) {
  const char* german =
      "ID,Vollständiger Name,Status,Bewertung,Bestwertung,Bewertung kann geändert werden,Zuletzt geändert "
      "(Abgabe),Zuletzt geändert (Bewertung),Feedback als Kommentar";
  Times list = times(worksheet(german, "Teilnehmer/in", "Ja", "Dienstag, 4. März 2025, 10:15", "gestern"));
  EXPECT_EQ(list.find("a", {.name = "Jane Doe", .id = "4711"}, "moodle", nullptr),
            "Dienstag, 4. März 2025, 10:15");
  EXPECT_EQ(list.find("b", {.name = "Sam Lee", .id = "4712"}, "moodle", nullptr), "");
  EXPECT_EQ(list.find("c", {.name = "Ann Poe", .id = "4713"}, "moodle", nullptr), "-");
  ASSERT_EQ(list.said().size(), 2U);
  EXPECT_TRUE(says(list, "times.csv: times are taken from the column \"Zuletzt geändert (Abgabe)\", by its"));
  EXPECT_TRUE(says(list, "times.csv, line 3: \"gestern\" is no time that is read"));
  // If no time is read, nobody would have one.
  EXPECT_EQ(refusal_of(worksheet("ID,Imię,Status,Ocena,Maks,Można zmienić,Zmieniono,Oceniono,Komentarz",
                                 "Uczestnik", "Tak", "wtorek, 4 marca 2025, 10:15", "-")),
            "times.csv, line 2: \"wtorek, 4 marca 2025, 10:15\" is no time that is read; write one such as "
            "2025-03-04 10:15, or export the table in English");
}

TEST(Times, OfAGroupAreTheLatestOfItsMembersAndARosterLinksIds) {
  Times list = times("email,time\na@u.de,2025-03-04 10:15:00 -0800\nb@u.de,2025-03-04 11:00:00 Z\nc@u.de,\n");
  const Owner a{.email = "a@u.de"}, b{.email = "b@u.de"}, c{.email = "c@u.de"};
  EXPECT_EQ(list.find("pair", {.group = true, .members = {c, b}}, "gradescope", nullptr),
            "2025-03-04 11:00:00 Z");
  EXPECT_EQ(list.find("one", {.group = true, .members = {c}}, "gradescope", nullptr), "-");
  EXPECT_EQ(list.find("team", {.group = true, .members = {a, b}}, "gradescope", nullptr),
            "2025-03-04 10:15:00 -0800");
  const Roster roster(parse_csv("id,email\n4711,b@u.de\n", "roster.csv"));
  EXPECT_EQ(list.find("x", {.id = "4711"}, "canvas", &roster), "2025-03-04 11:00:00 Z");
  EXPECT_EQ(list.find("y", {.id = "4711"}, "canvas", nullptr), "");
}

TEST(Times, NeedAColumn) {
  EXPECT_TRUE(says(refusal_of("id,when\n4711,2025-03-04 10:15\n"), "times.csv, line 1: no column has times"));
  EXPECT_TRUE(says(refusal_of("time\n2025-03-04 10:15\n"), "no title is known"));
}

}  // namespace
}  // namespace grader::roster
