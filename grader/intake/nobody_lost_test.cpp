// STAFF ONLY. Tests that intake loses nobody: strays, clashes, wrong types and Canvas's single files.
#include <set>

#include "grader/intake/submissions_fixture.h"

namespace grader::inline intake {
namespace {

TEST_F(Submissions, BareFilesBesideAClassAreReportedAndTheClassStaysOne) {
  for (const char* stray : {"conj_grad.cpp", "CMakeLists.txt", "grades.csv", "README.txt", "build.ninja"}) {
    SCOPED_TRACE(stray);
    const hair::TemporaryFolder folder("strays");
    dir_ = folder.path();
    write("class/alice.zip", zip("conj_grad.cpp", "a"));
    write("class/bob.zip", zip("conj_grad.cpp", "b"));
    write(std::string("class/") + stray, "stray");
    const Intake on_disk = take({dir_ / "class"});
    EXPECT_EQ(told(on_disk.submissions), (Names{"alice: conj=a", "bob: conj=b"}));
    EXPECT_EQ(on_disk.notices.size(), 1u);
    EXPECT_TRUE(has_notice(on_disk, {std::string("class/") + stray + ": ", "belongs to nobody"}));

    const std::string bytes = ArchiveBuilder(Packing::zip)
                                  .file("c/alice/conj_grad.cpp", "a")
                                  .file("c/bob.zip", zip("conj_grad.cpp", "b"))
                                  .file(std::string("c/") + stray, "stray")
                                  .bytes();
    const Intake packed = take({write("class.zip", bytes)});
    EXPECT_EQ(told(packed.submissions), (Names{"alice: conj=a", "bob: conj=b"}));
    EXPECT_TRUE(has_notice(packed, {std::string("class.zip/c/") + stray}));
  }
}

TEST_F(Submissions, ArchivesThatStayShutAreReported) {
  write("class/alice/conj_grad.cpp", "mine");
  write("class/alice/build/handin.zip", zip("conj_grad.cpp"));  // the handout's own build writes it
  write("class/alice/old/handin.zip", zip("conj_grad.cpp"));
  write("class/bob.zip", zip("conj_grad.cpp"));
  const Intake intake = take({dir_ / "class"});
  EXPECT_EQ(told(intake.submissions).at(0), "alice: conj=mine");
  EXPECT_EQ(intake.notices.size(), 1u);
  EXPECT_TRUE(has_notice(intake, {"class/alice: ", "alice/old/handin.zip was not opened"}));

  const Intake nested = take({write(
      "dave.zip",
      ArchiveBuilder(Packing::zip).file("conj_grad.cpp").file("old.zip", zip("conj_grad.cpp")).bytes())});
  EXPECT_EQ(names(nested.submissions), Names{"dave"});
  EXPECT_TRUE(has_notice(nested, {"dave.zip: old.zip was not opened"}));
}

TEST_F(Submissions, ArchivesThatLieTooDeepAreReported) {
  std::string bytes = zip("conj_grad.cpp");
  for (int i = 0; i < 10; ++i) bytes = zip("x.zip", bytes);
  const Intake intake = take({write("alice.zip", bytes)});
  EXPECT_TRUE(says(intake.submissions.at(0).problem, "None of the exercise files"));
  EXPECT_TRUE(has_notice(intake, {"alice.zip: x.zip/x.zip/x.zip/x.zip was not opened"}));
}

TEST_F(Submissions, NamesThatDifferStayApart) {
  for (const char* name : {"x 1", "x_1", "O'Brien", "O_Brien", "Jörg", "Jorg", "王伟", "李娜", "z"})
    write(std::string("class/") + name + "/conj_grad.cpp", name);
  const Intake intake = take({dir_ / "class"});
  ASSERT_EQ(intake.submissions.size(), 9u);
  std::set<std::string> all;
  for (const Submission& one : intake.submissions) {
    EXPECT_EQ(one.files.at("conj_grad.cpp").text, one.owner.name);
    all.insert(one.name);
  }
  EXPECT_EQ(all.size(), 9u);
  EXPECT_EQ(intake.notices, Names{});
}

TEST_F(Submissions, ClashesAreMarkedAndTheRestIsRead) {
  write("class/y.zip", zip("conj_grad.cpp"));
  write("class/y.tar.gz", ArchiveBuilder(Packing::tar_gz).file("conj_grad.cpp").bytes());
  write("class/z.zip", zip("conj_grad.cpp", "fine"));
  const Intake intake = take({dir_ / "class"});
  ASSERT_EQ(intake.submissions.size(), 3u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Submission& one = intake.submissions[i];
    EXPECT_TRUE(one.name.starts_with("y-")) << one.name;
    EXPECT_TRUE(one.files.empty());
    EXPECT_FALSE(one.unreadable);
    EXPECT_TRUE(says(one.problem, "are both the submission \"y\""));
    for (const char* path : {"class/y.zip", "class/y.tar.gz"}) EXPECT_TRUE(says(one.problem, path));
    EXPECT_EQ(one.problem.find(dir_.string()), std::string::npos) << "students see it: " << one.problem;
    EXPECT_TRUE(has_notice(intake, {"rename one of them", "\"" + one.name + "\""}));
  }
  EXPECT_NE(intake.submissions[0].name, intake.submissions[1].name);
  EXPECT_EQ(intake.notices.size(), 2u);
  EXPECT_EQ(told(intake.submissions)[2], "z: conj=fine");
}

TEST_F(Submissions, ClashingNamesAreTheSameInAnyOrder) {
  const fs::path first = write("a/alice.zip", zip("conj_grad.cpp", "1")),
                 second = write("b/alice.zip", zip("conj_grad.cpp", "2"));
  const Intake one = take({first, second}), other = take({second, first});
  EXPECT_EQ(names(one.submissions), names(other.submissions));
  EXPECT_EQ(one.notices, other.notices);
  ASSERT_EQ(one.submissions.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(one.submissions[i].problem, other.submissions[i].problem);
    EXPECT_TRUE(says(one.submissions[i].problem, "a/alice.zip"));
    EXPECT_TRUE(says(one.submissions[i].problem, "b/alice.zip"));
  }
  EXPECT_EQ(names(take({first, second, write("b/bob.zip", zip("conj_grad.cpp"))}).submissions).back(), "bob");
}

TEST_F(Submissions, WhatIsGivenTwiceIsReadOnce) {
  write("class/alice.zip", zip("conj_grad.cpp", "1"));
  write("class/bob.zip", zip("conj_grad.cpp", "2"));
  const Intake intake = take({dir_ / "class", dir_ / "class/alice.zip"}, {}, true);
  EXPECT_EQ(told(intake.submissions), (Names{"alice: conj=1", "bob: conj=2"}));
  EXPECT_TRUE(has_notice(intake, {"class/alice.zip: was given twice"}));
}

TEST_F(Submissions, WrongTypesAreNamedAndUnreadable) {
  const std::string fine = zip("conj_grad.cpp", "fine"),
                    packed =
                        ArchiveBuilder(Packing::tar_gz).file("conj_grad.cpp", std::string(5000, 'x')).bytes(),
                    locked =
                        ArchiveBuilder(Packing::zip, "zip:encryption=aes256").file("conj_grad.cpp").bytes();
  const struct {
    std::string file, bytes, problem;
  } rows[] = {{"alice.rar", "Rar!\x1a\x07", "alice.rar is a RAR archive. Hand in a .zip"},
              {"bob.7z", "7z\xbc\xaf\x27\x1c", "bob.7z is a 7z archive"},
              {"carol.tar.xz",
               "\xfd"
               "7zXZ",
               "carol.tar.xz is packed with xz"},
              {"dave.pdf", "%PDF-1.4", "dave.pdf is no archive. Hand in a .zip"},
              {"erin.docx", zip("word/document.xml"), "erin.docx is no archive"},
              {"frank.zip", "<html>Please log in</html>", "frank.zip is neither a zip nor a tar.gz"},
              {"grace.zip", fine.substr(0, 60), "grace.zip can't be read"},
              {"heidi.zip", locked, "is encrypted. Pack it again without a password"},
              {"ivan.zip", zip("main.cpp"), "None of the exercise files"},
              {"judy.zip", fine, ""},
              {"kim.tar.gz", packed.substr(0, packed.size() / 2),
               "kim.tar.gz can't be read: it is damaged or cut short"}};
  for (const auto& row : rows) write("class/" + row.file, row.bytes);
  const Intake intake = take({dir_ / "class"});
  ASSERT_EQ(intake.submissions.size(), std::size(rows));
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    const Submission& one = intake.submissions[i];
    const std::string& file = rows[i].file;
    EXPECT_EQ(told({one})[0], file.substr(0, file.find('.')) + (file == "judy.zip" ? ": conj=fine" : ": !"));
    EXPECT_TRUE(says(one.problem, rows[i].problem));
    EXPECT_EQ(one.unreadable, file != "judy.zip" && file != "ivan.zip") << file << " could be read";
  }
  ASSERT_EQ(intake.notices.size(), 10U) << "a person must look at each";
  EXPECT_TRUE(has_notice(intake, {"class/alice.rar: was not graded: alice.rar is a RAR archive"}));
  EXPECT_TRUE(has_notice(
      intake, {"class/ivan.zip: was not graded: no exercise file is in it; it holds", "main.cpp"}));
  for (const char* alone : {"dave.pdf", "frank.zip", "grace.zip", "bob.7z", "kim.tar.gz"})
    EXPECT_TRUE(says(bad_input({dir_ / "class" / alone}), "nothing was graded")) << "it may be a whole class";
}

TEST_F(Submissions, FilesOfCanvasBelongToTheirStudents) {
  write("class/doejane_12347_678901_conj_grad.cpp", "jane 1");
  write("class/doejane_12347_678902_normal_equations.cpp", "jane 2");
  write("class/roe_LATE_99_5_conj_grad.cpp", "late");
  write("class/roe_99_6_conj_grad-1.cpp", "older");
  write("class/roe_99_7_conj_grad-2.cpp", "newest");
  write("class/poe_7_8_main.cpp", "a wrong name");
  write("class/moe_8_9_report.pdf", "%PDF");
  write("class/conj_grad.cpp", "nobody's");
  const Intake intake = take({dir_ / "class"});
  ASSERT_EQ(told(intake.submissions), (Names{"doejane_12347: conj=jane 1 normal=jane 2", "moe_8: !",
                                             "poe_7: !", "roe_99: conj=newest"}));
  EXPECT_TRUE(says(intake.submissions[1].problem, "None of the exercise files"));
  EXPECT_TRUE(says(intake.submissions[1].problem, "It holds report.pdf."));
  EXPECT_TRUE(says(intake.submissions[2].problem, "It holds main.cpp."));
  EXPECT_TRUE(has_notice(intake, {"poe_7_8_main.cpp: ", "no exercise file is in it; it holds main.cpp"}));
  EXPECT_TRUE(intake.submissions[3].marked_late);
  EXPECT_EQ(intake.submissions[3].owner.id, "99");
  EXPECT_EQ(intake.submissions[3].system, "canvas");
  EXPECT_EQ(std::ranges::count(intake.accounted, Accounted::As::older, &Accounted::as), 2);
  EXPECT_EQ(
      intake.submissions[3].files.at("conj_grad.cpp").choice,
      "roe_99_7_conj_grad-2.cpp was taken for conj_grad.cpp, and not roe_99_6_conj_grad-1.cpp and 1 more.");
  EXPECT_EQ(intake.notices.size(), 3U);
  EXPECT_TRUE(has_notice(intake, {"class/conj_grad.cpp: ", "belongs to nobody"}));
}

TEST_F(Submissions, OneStudentsArchivesAndFilesOfCanvasAreOneHandIn) {
  const std::string bytes = ArchiveBuilder(Packing::zip)
                                .file("doe_1_2_conj_grad.cpp", "a")
                                .file("doe_1_9_handin.zip", zip("normal_equations.cpp", "d"))
                                .file("roe_2_3_s1.zip", zip("conj_grad.cpp", "b"))
                                .file("roe_2_4_s2.zip", zip("normal_equations.cpp", "e"))
                                .file("poe_3_4_handin.zip", zip("conj_grad.cpp", "c"))
                                .file("poe_3_5_again.zip", zip("conj_grad.cpp", "also"))
                                .bytes();
  const Intake intake = take({write("submissions.zip", bytes)});
  ASSERT_EQ(told(intake.submissions),
            (Names{"doe_1: conj=a normal=d", "poe_3: conj=!", "roe_2: conj=b normal=e"}));
  EXPECT_TRUE(says(
      intake.submissions[1].files.at("conj_grad.cpp").problem,
      "more than one conj_grad.cpp: poe_3_4_handin.zip/conj_grad.cpp and poe_3_5_again.zip/conj_grad.cpp"));
  EXPECT_EQ(intake.notices.size(), 1U);
  EXPECT_TRUE(has_notice(intake, {"poe_3_4_handin.zip/conj_grad.cpp and poe_3_5_again.zip/conj_grad.cpp"}));
}

TEST_F(Submissions, ALaterHandInHasTheSameName) {
  for (const char* file :
       {"mullersofia_12347_678900_handin.zip", "mullersofia_LATE_12347_679555_handin-1.zip"}) {
    const hair::TemporaryFolder folder("later");
    dir_ = folder.path();
    write("in/adams_1_2_conj_grad.cpp", "a");
    const fs::path alone = write(std::string("in/") + file, zip("conj_grad.cpp"));
    EXPECT_EQ(names(read({dir_ / "in"})), (Names{"adams_1", "mullersofia_12347"}));
    EXPECT_EQ(names(read({alone})), Names{"mullersofia_12347"}) << "also where the file is the argument";
  }
}

TEST_F(Submissions, NearNamesAreNamed) {
  write("in/a_1_2_conj_grad (1).cpp", "a");
  write("in/b_3_4_ConjGrad.cpp", "b");
  write("in/c_5_6_CONJ_GRAD.CPP", "c");
  write("in/d_7_8_conj_grad.txt", "d");
  write("in/f_8_8_conj_grad (1).cpp", "older");
  write("in/f_8_9_conj_grad.cpp", "f");
  write("in/g_9_1_normal_equations.cpp", "g");
  write("in/g_9_2_conj_grad_final.cpp", "g");
  const Intake intake = take({dir_ / "in"});
  ASSERT_EQ(told(intake.submissions),
            (Names{"a_1: conj=a", "b_3: !", "c_5: conj=c", "d_7: !", "f_8: conj=f", "g_9: conj=! normal=g"}));
  EXPECT_TRUE(has_remark(intake, {"conj_grad (1).cpp was taken for conj_grad.cpp"}));
  EXPECT_TRUE(says(intake.submissions[1].problem, "ConjGrad.cpp looks like conj_grad.cpp."));
  EXPECT_TRUE(says(intake.submissions[3].problem, "conj_grad.txt looks like conj_grad.cpp."));
  EXPECT_TRUE(has_remark(
      intake, {"f_8_9_conj_grad.cpp was taken for conj_grad.cpp, and not f_8_8_conj_grad (1).cpp"}));
  EXPECT_TRUE(says(
      intake.submissions[5].files.at("conj_grad.cpp").problem,
      "conj_grad.cpp is missing, and conj_grad_final.cpp looks like it. Give it the name conj_grad.cpp"));
  EXPECT_EQ(intake.notices.size(), 3U);
}

TEST_F(Submissions, NothingRecognisedIsBadInput) {
  EXPECT_TRUE(says(bad_input({write("class.zip", zip("main.cpp"))}), "no learning system's names"));
  EXPECT_EQ(read_submissions({write("x/a.zip", zip("main.cpp")), write("x/b.zip", zip("conj_grad.cpp"))},
                             two_exercises(), opener())
                .submissions.size(),
            2U)
      << "among several arguments it is one student's";
  const fs::path canvas = write("canvas.zip", zip("doe_1_2_conj_grad.cpp"));
  EXPECT_TRUE(says(bad_input({canvas}, {.from = "moodle"}),
                   "holds no name that Moodle gives, as Jane Doe_4711_assignsubmission_file/"));
}

}  // namespace
}  // namespace grader::intake
