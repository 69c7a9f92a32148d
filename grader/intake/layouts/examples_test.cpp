// STAFF ONLY. Tests each system's names, as its own source or its users give them.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "grader/course/input.h"
#include "grader/intake/layouts/division.h"
#include "grader/intake/layouts/gradescope.h"

namespace grader::inline intake {
namespace {

using Lines = std::vector<std::string>;

// Returns a line for each hand-in, "NAME|ID|TIME|MARKS: FILES", and for each file aside, "? NAME", "= NAME"
// if the system made it, "- NAME" if it is older.
Lines told(const Lines& paths, const char* said = nullptr, const char* container = "download") {
  std::vector<Entry> list;
  for (const std::string& path : paths) list.push_back(entry_at(path));
  const Division division =
      divide(list, container, said ? system_called(said) : nullptr).value_or(Division{});
  if (!division.system) return {"unknown"};
  Lines lines{std::string(division.system->name)};
  for (const FoundHandIn& one : division.hand_ins) {
    std::string line = one.owner.name + "|" + one.owner.id + "|" + one.handed_in + "|" +
                       (one.late ? "late" : "") + (one.owner.anonymous ? "anonymous" : "") +
                       (one.owner.group ? "group" : "") + ":";
    for (const std::size_t i : one.entries) line += " " + std::string(name_of(list[i]));
    lines.push_back(line);
  }
  for (const Division::Aside& aside : division.aside) {
    const char* mark = aside.as == Accounted::As::left_over ? "? "
                       : aside.as == Accounted::As::made    ? "= "
                                                            : "- ";
    lines.push_back(mark + list[aside.entry].shown);
  }
  return lines;
}

TEST(Layouts, OfCanvas) {
  EXPECT_EQ(told({"müllerlüdenscheidtjörg_4711_90001_main.cpp", "obrienseán_LATE_4712_90017_main-1.cpp",
                  "team7_4713_90020_lab 2.tar.gz", "LATE_anon_aB3dE_90021_main.cpp",
                  "müllerlüdenscheidtjörg_4711_text.html"}),
            (Lines{"canvas", "|aB3dE||lateanonymous: main.cpp", "müllerlüdenscheidtjörg|4711||: main.cpp",
                   "obrienseán|4712||late: main.cpp", "team7|4713||: lab 2.tar.gz",
                   "= müllerlüdenscheidtjörg_4711_text.html"}));
  // The highest number of a name counts.
  EXPECT_EQ(told({"roe_99_5_a.cpp", "roe_99_6_a-1.cpp", "roe_99_7_a-2.cpp", "roe_99_8_b.cpp"}),
            (Lines{"canvas", "roe|99||: a.cpp b.cpp", "- roe_99_5_a.cpp", "- roe_99_6_a-1.cpp"}));
  // A student who handed in only a link must not get lost.
  EXPECT_EQ(told({"roe_99_link.html"}), (Lines{"canvas", "roe|99||:", "= roe_99_link.html"}));
}

// A student chooses a file's own name. It must not change the owner.
TEST(Layouts, OfCanvasAreNoWordsOfStudents) {
  EXPECT_EQ(told({"4711_90001_4712_90002_a.cpp", "4712_90003_b.cpp"}),
            (Lines{"canvas", "|4711||: 4712_90002_a.cpp", "|4712||: b.cpp"}));
  EXPECT_EQ(told({"Mallory_1_assignsubmission_file_Bob_2_assignsubmission_file_a.cpp"}),
            (Lines{"moodle", "Mallory|1||: Bob_2_assignsubmission_file_a.cpp"}));
  EXPECT_EQ(told({"HW1_mal_attempt_2025-03-04-10-15-22_HW1_bob_attempt_2025-03-04-10-15-22_a.cpp"}),
            (Lines{"blackboard", "|mal|2025-03-04 10:15:22|: HW1_bob_attempt_2025-03-04-10-15-22_a.cpp"}));
  EXPECT_EQ(told({"1-9 - Mal - May 18, 2025 1224 PM - 2-9 - Bob - May 18, 2025 1224 PM - a.cpp"}),
            (Lines{"brightspace", "Mal|1|2025-05-18 12:24:00|: 2-9 - Bob - May 18, 2025 1224 PM - a.cpp"}));
  EXPECT_EQ(told({"mal@u.de_1_bob@u.de_2_a.cpp"}), (Lines{"autolab", "|mal@u.de||: bob@u.de_2_a.cpp"}));
  // A group may be called "Lab 3_12": then two names seem to share one file's number.
  EXPECT_EQ(told({"lab3_12_4713_90020_a.cpp", "lab3_12_4713_90021_b.cpp"}),
            (Lines{"canvas", "lab3_12|4713||group: a.cpp b.cpp"}));
}

TEST(Layouts, OfMoodle) {
  EXPECT_EQ(
      told({"Jörg Müller-Lüdenscheidt_4711_assignsubmission_file/src/main.cpp",
            "Seán OBrien_4712_assignsubmission_onlinetext/onlinetext.html",
            "Participant_4713_assignsubmission_file/main.cpp", "Team 7_55_assignsubmission_file/lab.zip"}),
      (Lines{"moodle", "Jörg Müller-Lüdenscheidt|4711||: main.cpp", "Participant|4713||anonymous: main.cpp",
             "Seán OBrien|4712||:", "Team 7|55||: lab.zip",
             "= Seán OBrien_4712_assignsubmission_onlinetext/onlinetext.html"}));
  EXPECT_EQ(told({"Ann Lee_4711_assignsubmission_file_/a.cpp",
                  "Ann Lee_4711_assignsubmission_onlinetext_/onlinetext.html"}),
            (Lines{"moodle", "Ann Lee|4711||: a.cpp",
                   "= Ann Lee_4711_assignsubmission_onlinetext_/onlinetext.html"}));
  EXPECT_EQ(told({"Ann Lee_4711_assignsubmission_file_a.cpp", "Bo Ek_4712_assignsubmission_file_a.cpp"}),
            (Lines{"moodle", "Ann Lee|4711||: a.cpp", "Bo Ek|4712||: a.cpp"}));
  EXPECT_EQ(told({"Teilnehmer_1_assignsubmission_file/a.cpp", "Teilnehmer_2_assignsubmission_file/a.cpp"}),
            (Lines{"moodle", "Teilnehmer|1||anonymous: a.cpp", "Teilnehmer|2||anonymous: a.cpp"}));
  EXPECT_EQ(told({"Team 7_55_assignsubmission_file/a.cpp", "Default group_assignsubmission_file/a.cpp"}),
            (Lines{"moodle", "Default group|||group: a.cpp", "Team 7|55||group: a.cpp"}));
}

TEST(Layouts, OfBrightspace) {
  EXPECT_EQ(told({"5917-716031 - First Last - May 18, 2025 1224 PM/a.cpp",
                  "5918-716031 - Jo - Poe - Jan 2, 2025 105 AM/a.cpp",
                  "5918-716031 - Jo - Poe - Jan 3, 2025 105 AM/b.cpp", "index.html"}),
            (Lines{"brightspace", "First Last|5917|2025-05-18 12:24:00|: a.cpp",
                   "Jo - Poe|5918|2025-01-03 01:05:00|: b.cpp",
                   "- 5918-716031 - Jo - Poe - Jan 2, 2025 105 AM/a.cpp", "= index.html"}));
  EXPECT_EQ(told({"index.html", "100-200 - Ann Lee - Oct 3, 2026 1130 AM - a.cpp",
                  "101-200 - Bo Ek - Oct 3, 2026 1131 AM - a.cpp"}),
            (Lines{"brightspace", "Ann Lee|100|2026-10-03 11:30:00|: a.cpp",
                   "Bo Ek|101|2026-10-03 11:31:00|: a.cpp", "= index.html"}));
  EXPECT_EQ(
      told({"9-100 - Ann Lee - Oct 3, 2026 1130 AM - a.cpp", "9-101 - Bo Ek - Oct 3, 2026 1131 AM - a.cpp"}),
      (Lines{"brightspace", "Ann Lee|100|2026-10-03 11:30:00|: a.cpp",
             "Bo Ek|101|2026-10-03 11:31:00|: a.cpp"}));
}

TEST(Layouts, OfBlackboard) {
  EXPECT_EQ(
      told({"Lab 3_so12_attempt_2025-03-04-10-15-22_main.cpp", "Lab 3_so12_attempt_2025-03-04-10-15-22.txt",
            "Lab 3_so12_attempt_2025-03-01-09-00-00_old.cpp", "Lab 3_so12_attempt_2025-03-01-09-00-00.txt",
            "Lab 3_jm_07_attempt_2025-03-01-09-00-00.txt"}),
      (Lines{"blackboard", "|jm_07|2025-03-01 09:00:00|:", "|so12|2025-03-04 10:15:22|: main.cpp",
             "= Lab 3_jm_07_attempt_2025-03-01-09-00-00.txt", "= Lab 3_so12_attempt_2025-03-01-09-00-00.txt",
             "- Lab 3_so12_attempt_2025-03-01-09-00-00_old.cpp",
             "= Lab 3_so12_attempt_2025-03-04-10-15-22.txt"}));
}

TEST(Layouts, OfAutolab) {
  EXPECT_EQ(told({"joerg@u.de_3_lab.tar", "joerg@u.de_10_lab.tar", "3_so@u.ie_my_lab.c",
                  "annotated_so@u.ie_1_lab.tar"}),
            (Lines{"autolab", "|joerg@u.de||: lab.tar", "|so@u.ie||: my_lab.c",
                   "= annotated_so@u.ie_1_lab.tar", "- joerg@u.de_3_lab.tar"}));
  EXPECT_EQ(told({"joerg@u.de_3_lab.tar", "joerg@u.de_4_conj_grad.cpp"}),
            (Lines{"autolab", "|joerg@u.de||: conj_grad.cpp", "- joerg@u.de_3_lab.tar"}))
      << "whatever the version's file is called";
}

TEST(Layouts, OfClassroom) {
  const Lines folders{"lab3-jmueller/a.cpp", "lab3-team-7/a.cpp", "grades.csv"};
  const Lines expected{"classroom", "|jmueller||: a.cpp", "|team-7||: a.cpp", "= grades.csv"};
  EXPECT_EQ(told(folders, nullptr, "lab3-submissions"), expected);
  EXPECT_EQ(told(folders, "classroom"), expected);
  EXPECT_EQ(told(folders), Lines{"unknown"}) << "any folders can be called so";
  EXPECT_EQ(told({"lab3-submissions/lab3-jmueller/a.cpp"}), (Lines{"classroom", "|jmueller||: a.cpp"}));
}

TEST(Layouts, OfGradescope) {
  EXPECT_EQ(
      told({"assignment_9100_export/submission_metadata.yml",
            "assignment_9100_export/submission_31415926/src/main.cpp"}),
      (Lines{"gradescope", "|31415926||: main.cpp", "= assignment_9100_export/submission_metadata.yml"}));
  const auto rows = read_gradescope_metadata(
      "---\nsubmission_31415926:\n  :submitters:\n  - :name: Jörg Müller\n    :sid: '00471'\n  "
      "  :email: jm@u.de\n"
      "  :created_at: 2025-03-04 10:15:22.123456000 Z\n  :score: 7.5\n  :history:\n  - :created_at: "
      "2025-03-01 10:15:22 Z\n"
      "    :score: 1\nsubmission_2:\n  :submitters:\n  - :name: Jo\n    :sid: '7'\n    :email: jo@u.de\n  - "
      ":name: Al\n    :sid:\n"
      "    :email: al@u.de\n  :created_at: 2025-03-04 10:15:22 Z\n",
      "m.yml");
  EXPECT_EQ(rows.at("submission_31415926").owner.id, "00471") << "a text stays one";
  EXPECT_EQ(rows.at("submission_31415926").owner.email, "jm@u.de");
  EXPECT_EQ(rows.at("submission_31415926").handed_in, "2025-03-04 10:15:22.123456000 Z");
  const Owner& pair = rows.at("submission_2").owner;
  EXPECT_TRUE(pair.group);
  ASSERT_EQ(pair.members.size(), 2U);
  EXPECT_EQ(pair.id, "al@u.de_7") << "whatever number a later hand-in has";
  EXPECT_THROW(read_gradescope_metadata("a: [", "m.yml"), std::exception);
  EXPECT_THROW(read_gradescope_metadata("a: [" + std::string(10'000'000, ',') + "]", "m.yml"), BadInput)
      << "it would take gigabytes";
  EXPECT_THROW(read_gradescope_metadata("<html>Sign in</html>", "m.yml"), std::exception);
}

TEST(Layouts, ForeignNamesAreLeftOver) {
  EXPECT_EQ(told({"c/roe_1_2_a.cpp", "c/poe_2_3_a.cpp", "c/a.cpp", "README"}),
            (Lines{"canvas", "poe|2||: a.cpp", "roe|1||: a.cpp", "? c/a.cpp", "? README"}));
  EXPECT_EQ(told({"alice.zip", "bob.zip", "notes_1_2_x.txt"}), Lines{"unknown"}) << "most are no system's";
  EXPECT_EQ(told({"alice/a.cpp", "mallory/Ann_1_assignsubmission_file/a.cpp",
                  "mallory/Bo_2_assignsubmission_file/a.cpp"}),
            Lines{"unknown"})
      << "nothing below a student's folder decides";
}

}  // namespace
}  // namespace grader::intake
