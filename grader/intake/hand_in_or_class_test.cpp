// STAFF ONLY. Tests that one student's archive gets nobody else a submission, even if it looks like a class.
#include "grader/intake/submission.h"
#include "grader/intake/submissions_fixture.h"

namespace grader::inline intake {
namespace {

std::string folders(const Names& paths) {
  ArchiveBuilder builder(Packing::zip);
  for (const std::string& path : paths) builder.file(path, "of " + path);
  return builder.bytes();
}

TEST_F(Submissions, OfSeveralArgumentsEachIsAHandIn) {
  const fs::path alice = write("alice.zip", zip("conj_grad.cpp", "a")),
                 bob = write("bob.zip", zip("conj_grad.cpp", "b"));
  const fs::path mallory =
      write("mallory.zip",
            folders({"alice/conj_grad.cpp", "bob/conj_grad.cpp", "mallory/conj_grad.cpp", "notes.txt"}));
  const Intake intake = take({alice, bob, mallory});
  ASSERT_EQ(told(intake.submissions), (Names{"alice: conj=a", "bob: conj=b", "mallory: !"}));
  EXPECT_EQ(intake.submissions[0].origin, "hand-in " + alice.string());
  EXPECT_TRUE(says(intake.submissions[2].problem, "of several people"));
  EXPECT_EQ(intake.notices.size(), 1U);
  EXPECT_TRUE(has_notice(intake, {"mallory.zip: ", "(alice, bob, mallory)", "one of several", "--class"}));
  EXPECT_EQ(intake.taken_for, Names{});
}

TEST_F(Submissions, OfSeveralArgumentsEachMayBeAClassIfSomebodySaysSo) {
  const fs::path first = write("1.zip", folders({"alice/conj_grad.cpp", "bob/conj_grad.cpp"}));
  const fs::path second = write("2.zip", folders({"carol/conj_grad.cpp", "dave/conj_grad.cpp"}));
  const Intake intake = take({first, second}, {}, true);
  EXPECT_EQ(names(intake.submissions), (Names{"alice", "bob", "carol", "dave"}));
  EXPECT_EQ(intake.submissions[3].origin, "class " + second.string());
  EXPECT_EQ(intake.notices, Names{});
  EXPECT_EQ(intake.taken_for, (Names{first.string() + ": taken for a class: alice, bob",
                                     second.string() + ": taken for a class: carol, dave"}));
}

TEST_F(Submissions, ADownloadIsAClassIfItIsAloneAndNotCalledAsAHandInOrIfTheCallerSaysSo) {
  const std::vector<Names> downloads = {{"doe_12_34_conj_grad.cpp", "roe_13_35_conj_grad.cpp"},
                                        {"Jane Doe_4711_assignsubmission_file_/conj_grad.cpp",
                                         "Jo Poe_4712_assignsubmission_file/conj_grad.cpp"},
                                        {"5917-716031 - Jane Doe - May 18, 2025 1224 PM/conj_grad.cpp",
                                         "5918-716031 - Jo Poe - May 18, 2025 1225 PM/conj_grad.cpp"}};
  for (const Names& paths : downloads) {
    SCOPED_TRACE(paths[0]);
    const fs::path alice = write("x/alice.zip", zip("conj_grad.cpp")),
                   first = write("x/1.zip", folders(paths));
    const Intake refused = take({first, alice});
    EXPECT_EQ(names(refused.submissions), (Names{"1", "alice"}));
    EXPECT_TRUE(has_notice(refused, {"1.zip: ", "is one of several arguments", "--class"}));
    const Intake said = take({first, alice}, {}, true);
    EXPECT_EQ(said.submissions.size(), 3U);
    EXPECT_EQ(said.notices, Names{});
    EXPECT_EQ(
        std::ranges::count_if(said.submissions,
                              [](const Submission& one) { return one.origin.starts_with(kLearningSystem); }),
        2);
    EXPECT_TRUE(says(bad_input({first, write("x/2.zip", folders(paths))}), "--class")) << "two sections";
    EXPECT_EQ(take({first}).submissions.size(), 2U);
    for (const char* name : {"foe_9_8_x.zip", "Jo Poe_4712_assignsubmission_file.zip",
                             "5918-716031 - Jo Poe - May 18, 2025 1225 PM.zip", "b@u.de_2_lab.zip"})
      EXPECT_TRUE(says(bad_input({write(name, folders(paths))}), "is called as a learning system calls"))
          << name;
  }
}

TEST_F(Submissions, ALoneArgumentIsAClassUnlessItIsCalledAsOneInIt) {
  const std::string bytes = folders({"alice/conj_grad.cpp", "bob/conj_grad.cpp", "mallory/conj_grad.cpp"});
  const fs::path everybody = write("class.zip", bytes), mallory = write("mallory.zip", bytes);
  EXPECT_EQ(take({everybody}).taken_for,
            Names{everybody.string() + ": taken for a class: alice, bob, mallory"});
  EXPECT_TRUE(says(bad_input({mallory}), "is called as one of them"));
  EXPECT_TRUE(says(bad_input({mallory}), "--class"));
  EXPECT_EQ(names(take({mallory}, {}, true).submissions), (Names{"alice", "bob", "mallory"}));
  EXPECT_EQ(names(take({everybody, everybody}).submissions), (Names{"alice", "bob", "mallory"}))
      << "the same one twice";
}

// A class has one archive a section. A student who can put one archive among others must not act for a class.
TEST_F(Submissions, AFolderOfDownloadsIsAClassIfAllOfItsArchivesAreDownloads) {
  const std::string a = folders({"ann_1_11_conj_grad.cpp", "bo_2_12_conj_grad.cpp"}),
                    b = folders({"cy_3_13_conj_grad.cpp", "di_4_14_conj_grad.cpp"}),
                    moodle = folders({"Ed Ek_5_assignsubmission_file/conj_grad.cpp"});
  const Names all{"ann_1", "bo_2", "cy_3", "di_4"};
  struct Case {
    std::vector<std::pair<std::string, std::string>> files;
    Names names;
    bool said = false;  // is --class
  };
  const std::vector<Case> cases = {
      {{{"A.zip", a}, {"B.zip", b}}, all},
      {{{"x/A.zip", a}, {"x/B.zip", b}, {"x/README.txt", ""}}, all},
      {{{"A/ann_1_11_conj_grad.cpp", ""},
        {"A/bo_2_12_conj_grad.cpp", ""},
        {"B/cy_3_13_conj_grad.cpp", ""},
        {"B/di_4_14_conj_grad.cpp", ""}},
       all},
      {{{"A.zip", a}, {"mal.zip", zip("conj_grad.cpp")}}, {"A", "mal"}},
      {{{"A.zip", a}, {"mal.rar", "Rar!"}}, {"A", "mal"}},
      {{{"A.zip", a}, {"bob/conj_grad.cpp", ""}}, {"A", "bob"}},
      {{{"A.zip", a}, {"B.zip", moodle}}, {"A", "B"}},
      {{{"A.zip", a}, {"cy.zip", b}}, {"A", "cy"}},
      {{{"A.zip", a}, {"3.zip", b}}, {"3", "A"}},
      {{{"A.zip", a}, {"mal_9_99_B.zip", b}}, {"A", "mal_9_99_B"}},
      {{{"A.zip", a}}, {"ann_1", "bo_2"}, true},
  };
  for (const Case& one : cases)
    for (const bool packed : {false, true}) {
      SCOPED_TRACE(one.files.back().first + (packed ? ", packed" : ""));
      const hair::TemporaryFolder folder("sections");
      dir_ = folder.path();
      ArchiveBuilder builder(Packing::zip);
      for (const auto& [path, bytes] : one.files) {
        builder.file(path, bytes);
        if (!packed) write("all/" + path, bytes);
      }
      const Intake intake = take({packed ? write("all.zip", builder.bytes()) : dir_ / "all"}, {}, one.said);
      EXPECT_EQ(names(intake.submissions), one.names);
      const bool told = one.names.back() != "di_4" && !one.said;
      EXPECT_EQ(std::ranges::count_if(
                    intake.notices,
                    [](const auto& line) { return line.find("was not graded: ") != line.npos; }) > 0,
                told);
    }
  // The only archive of a folder may be one student's.
  const Intake lone = take({write("late/mal.zip", a).parent_path()});
  EXPECT_EQ(names(lone.submissions), Names{"mal"});
  EXPECT_TRUE(has_notice(lone, {"mal.zip: was not graded"}));
}

TEST_F(Submissions, SomebodyInTwoSectionsHasOneHandInAndALine) {
  for (const bool same : {true, false}) {
    const hair::TemporaryFolder folder("sections");
    dir_ = folder.path();
    ArchiveBuilder a(Packing::zip), b(Packing::zip);
    a.file("ann_1_11_conj_grad.cpp", "1").file("bo_2_12_conj_grad.cpp", "2");
    b.file("ann_1_15_conj_grad.cpp", same ? "1" : "3").file("cy_3_13_conj_grad.cpp", "4");
    write("all/A.zip", a.bytes());
    write("all/B.zip", b.bytes());
    const Intake intake = take({dir_ / "all"});
    EXPECT_EQ(told(intake.submissions),
              (Names{same ? "ann_1: conj=1" : "ann_1: conj=!", "bo_2: conj=2", "cy_3: conj=4"}));
    EXPECT_TRUE(has_remark(intake, {"B.zip/ann_1_15_conj_grad.cpp is by a person who is also in A.zip/"}));
    EXPECT_EQ(intake.notices.size(), same ? 0U : 1U);
    if (same) continue;
    for (const char* path : {"A.zip/ann_1_11_conj_grad.cpp", "B.zip/ann_1_15_conj_grad.cpp"})
      EXPECT_TRUE(has_notice(intake, {"more than one conj_grad.cpp", path}));
  }
}

TEST_F(Submissions, ALoneHandInIsTakenForOne) {
  const fs::path alice = write("alice.zip", zip("conj_grad.cpp"));
  EXPECT_EQ(take({alice}).taken_for, Names{alice.string() + ": taken for a hand-in of one student, alice"});
}

// A person chose the argument's name; a student may have chosen the name in a class.
TEST_F(Submissions, AnArgumentStandsBesideItsNameInAClass) {
  const fs::path alice = write("alice_1_2_x.zip", zip("conj_grad.cpp", "a"));
  const fs::path other =
      write("a.zip", folders({"alice_1_2_x.zip", "mallory_3_4_x.zip"}));  // its path comes first
  const Intake intake = take({other, alice}, {}, true);
  ASSERT_EQ(intake.submissions.size(), 3U);
  EXPECT_EQ(told(intake.submissions)[0], "alice_1: conj=a");
  EXPECT_TRUE(intake.submissions[1].name.starts_with("alice_1-"));
  EXPECT_TRUE(says(intake.submissions[1].problem, "are both the submission"));
}

TEST_F(Submissions, FoldersWithOneArchiveAmongSeveralArgumentsAreTheirStudents) {
  write("alice/handin.zip", zip("conj_grad.cpp", "a"));
  write("bob/handin.zip", zip("conj_grad.cpp", "b"));
  const Intake intake = take({dir_ / "alice", dir_ / "bob"});
  EXPECT_EQ(told(intake.submissions), (Names{"alice: conj=a", "bob: conj=b"}));
}

TEST_F(Submissions, AFolderThatIsSaidToBeOneHandInIsNeverAClass) {
  const auto only_one = [&](const fs::path& folder) {
    const Intake intake = read_hand_in(folder, "4711", two_exercises(), opener());
    EXPECT_EQ(names(intake.submissions), Names{"4711"});
    return intake.submissions.at(0);
  };
  write("x/alice/conj_grad.cpp", "a");
  EXPECT_EQ(only_one(write("x/bob/normal_equations.cpp", "b").parent_path().parent_path()).files.size(), 2U);
  // Canvas's file names do not identify a student, and an archive inside is opened.
  EXPECT_TRUE(says(only_one(write("y/doe_12_34_conj_grad.cpp", "a").parent_path()).problem,
                   "None of the exercise files"));
  EXPECT_EQ(
      only_one(write("z/alice.zip", zip("conj_grad.cpp", "a")).parent_path()).files.at("conj_grad.cpp").text,
      "a");
  EXPECT_TRUE(
      says(only_one(write("nothing/notes.txt", "").parent_path()).problem, "None of the exercise files"));
}

}  // namespace
}  // namespace grader::intake
