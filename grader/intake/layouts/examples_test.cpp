// STAFF ONLY. Tests each system's names, as its own source or its users give them, and which folders and
// archives are one submission and which are a class.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "grader/course/input.h"
#include "grader/intake/layouts/division.h"
#include "grader/intake/layouts/folders.h"
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

const FileNames files{"conj_grad.cpp", "normal_equations.cpp"};

// Returns the submissions in a container with these paths (folders end with '/'), and its strays with "? "
// before them; "one" if it is a submission itself, "nothing" if it is neither.
std::vector<std::string> members(const std::vector<std::string>& paths, bool on_disk = false) {
  std::vector<Entry> entries;
  for (const std::string& path : paths) {
    entries.push_back(entry_at(path));
    if (path.back() == '/') entries.back().kind = Entry::Kind::folder;
  }
  const Layout layout = layout_of(entries, files, on_disk);
  if (!layout.found) return {"nothing"};
  if (!layout.is_class) return {"one"};
  std::vector<std::string> names;
  for (const Member& member : layout.members) names.push_back(member.path);
  for (const std::string& stray : layout.strays) names.push_back("? " + stray);
  return names;
}

using Names = std::vector<std::string>;

TEST(Layout, IsOneSubmissionOrAClassWithStrays) {
  const Names one{"one"}, nothing{"nothing"};
  const struct {
    const char* what;
    Names paths, expected;
    bool on_disk = false;
  } rows[] = {
      {"archives", {"bob.tar.gz", "alice.zip"}, {"alice.zip", "bob.tar.gz"}},
      {"archives", {"class/bob.tgz", "class/alice.zip", "class/"}, {"class/alice.zip", "class/bob.tgz"}},
      {"folders, also those that hold nothing",
       {"alice/conj_grad.cpp", "bob/src/conj_grad.cpp", "carol/", "dave/main.cpp", "README.txt"},
       {"alice", "bob", "carol", "dave", "? README.txt"}},
      {"folders and archives",
       {"alice/conj_grad.cpp", "bob.zip", "carol/handin.zip"},
       {"alice", "bob.zip", "carol"}},
      {"folders around everything",
       {"README", "a/b/alice/conj_grad.cpp", "a/b/bob/handin.zip", "a/b/carol/"},
       {"a/b/alice", "a/b/bob", "a/b/carol", "? README"}},
      {"an exercise file at the root", {"conj_grad.cpp"}, one},
      {"an exercise file at the root", {"x/conj_grad.cpp", "x/old/conj_grad.cpp", "x/notes/"}, one},
      {"an exercise file at the root", {"conj_grad.cpp", "handin.zip"}, one},
      {"an exercise file at the root", {"conj_grad.cpp", "handin.zip"}, one, true},
      {"a build is no person", {"hw/student/conj_grad.cpp", "hw/build/handin.zip"}, one},
      {"a build is no person",
       {"student/conj_grad.cpp", "cmake-build-debug/conj_grad.cpp", "build-1/handin.zip"},
       one},
      {"a build is no person", {"alice/conj_grad.cpp", "buildsmith/conj_grad.cpp"}, {"alice", "buildsmith"}},
      {"files beside a class",
       {"alice.zip", "bob.zip", "conj_grad.cpp"},
       {"alice.zip", "bob.zip", "? conj_grad.cpp"}},
      {"files beside a class",
       {"alice/conj_grad.cpp", "bob/conj_grad.cpp", "CMakeLists.txt"},
       {"alice", "bob", "? CMakeLists.txt"}},
      {"files beside a class",
       {"c/alice.zip", "c/bob.zip", "c/CMakeLists.txt", "CMakeLists.txt"},
       {"c/alice.zip", "c/bob.zip", "? CMakeLists.txt", "? c/CMakeLists.txt"}},
      {"one student's old copies look like it, too",
       {"conj_grad.cpp", "old/conj_grad.cpp", "older/conj_grad.cpp"},
       {"old", "older", "? conj_grad.cpp"}},
      {"outside of the root",
       {"c/d/alice.zip", "c/d/bob.zip", "c/carol/main.cpp", "c/carol/x/y.cpp", "notes.txt"},
       {"c/d/alice.zip", "c/d/bob.zip", "? c/carol", "? notes.txt"}},
      {"documents in a class",
       {"alice.zip", "bob.zip", "carol.pdf", "dave.DOCX", "README.txt"},
       {"alice.zip", "bob.zip", "carol.pdf", "dave.DOCX", "? README.txt"}},
      {"documents in a class", {"alice.zip", "carol.pdf"}, {"alice.zip", "carol.pdf"}, true},
      {"a document of one", {"handin.zip", "report.pdf"}, one},
      {"a document of one", {"conj_grad.cpp", "report.pdf"}, one, true},
      {"a project", {"CMakeLists.txt", "student/conj_grad.cpp", "build/handin.tar.gz", "solver/x.h"}, one},
      {"a project", {"p/CMakeLists.txt", "p/student/conj_grad.cpp", "p/old/conj_grad.cpp"}, one},
      {"a project",
       {"p/CMakeLists.txt", "p/student/1/conj_grad.cpp", "p/student/2/normal_equations.cpp"},
       one},
      {"a project", {"CMakeLists.txt", "hair/", "a.zip", "b.zip"}, one},
      {"a project", {"student/conj_grad.cpp", "solver/x.h", "build/a.o"}, one},
      {"a project",
       {"conj_grad.cpp", "CMakeLists.txt", "particles/x.h", "old/conj_grad.cpp", "v2/conj_grad.cpp"},
       one},
      {"no folder of the handout",
       {"CMakeLists.txt", "src/conj_grad.cpp", "lib/conj_grad.cpp", "hairy/x"},
       {"hairy", "lib", "src", "? CMakeLists.txt"}},
      {"a file is no folder",
       {"CMakeLists.txt", "solver", "a.zip", "b.zip"},
       {"a.zip", "b.zip", "? CMakeLists.txt", "? solver"}},
      {"one student's project beside others' archives",
       {"x/CMakeLists.txt", "x/solver/y.h", "a.zip", "b.zip"},
       {"a.zip", "b.zip", "x"}},
      {"projects of a class",
       {"alice/CMakeLists.txt", "alice/student/conj_grad.cpp", "bob/CMakeLists.txt",
        "bob/student/conj_grad.cpp"},
       {"alice", "bob"}},
      {"an archive alone in an archive", {"handin.tar.gz"}, one},
      {"an archive alone in an archive", {"x/handin.tar.gz", "x/notes/"}, one},
      {"an archive alone on disk", {"alice.zip"}, {"alice.zip"}, true},
      {"an archive alone on disk", {"alice/handin.zip"}, one, true},
      {"hidden", {".git/conj_grad.cpp", "a/.cache/x.zip", "__MACOSX/alice/conj_grad.cpp"}, nothing},
      {"hidden",
       {"x/student/conj_grad.cpp", "__MACOSX/x/student/conj_grad.cpp", "x/.old/conj_grad.cpp"},
       one},
      {"hidden",
       {"alice.zip", "bob.zip", "._alice.zip", ".hidden/", ".DS_Store", "Thumbs.db", "desktop.ini"},
       {"alice.zip", "bob.zip"}},
      {"nothing", {"main.cpp", "notes/"}, nothing},
  };
  for (const auto& [what, paths, expected, on_disk] : rows)
    EXPECT_EQ(members(paths, on_disk), expected) << what << ": " << testing::PrintToString(paths);
}

TEST(EntryPath, IsCleanedAndWhatLeadsOutsideIsNoted) {
  EXPECT_EQ(entry_at("./a//b/conj_grad.cpp").path, "a/b/conj_grad.cpp");
  EXPECT_FALSE(entry_at("./a//b/conj_grad.cpp").leads_outside);
  EXPECT_EQ(entry_at("a\\b\\conj_grad.cpp").path, "a/b/conj_grad.cpp");
  for (const char* path : {"a/../x", "a\\..\\x", "a/../../../x"}) {
    EXPECT_TRUE(entry_at(path).leads_outside) << path;
    EXPECT_EQ(name_of(entry_at(path)), "x") << path;
  }
  EXPECT_FALSE(entry_at("a/..x").leads_outside);
}

TEST(EntryPath, LosesItsRoot) {
  for (const char* path :
       {"/bob/x", "\\bob\\x", "C:\\bob\\x", "C:\\Users\\bob\\x", "/home/bob/x", "../../bob/x"}) {
    EXPECT_TRUE(entry_at(path).lost_root) << path;
    EXPECT_FALSE(entry_at(path).leads_outside) << path;
    EXPECT_EQ(entry_at(path).path, "bob/x") << path;
  }
  EXPECT_EQ(entry_at("Users/bob/x").path, "Users/bob/x");
}

}  // namespace
}  // namespace grader::intake
