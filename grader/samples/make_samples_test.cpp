// STAFF ONLY. Tests that samples are packed as their groups say, and equally each time.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <utility>

#include "grader/samples/sample.h"
#include "grader/samples/small_project.h"
#include "hair/io/files/read_file.h"

namespace grader::inline samples {
namespace {

struct Outcome {
  int code;
  std::string output;
};

Outcome make_samples(const fs::path& project, const fs::path& out,
                     const fs::path& showcase = scratch("project") / "showcase") {
  const fs::path log = scratch("log");
  const std::string command = std::string("'") + HAIR_MAKE_SAMPLES + "' '" + project.string() + "' '" +
                              out.string() + "' '" + showcase.string() + "' '" + out.string() + "-first' '" +
                              out.string() + "-attacks' >'" + log.string() + "' 2>&1";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, hair::bytes_of(log)};
}

TEST(MakeSamples, GivesTheSameBytesWhateverTheTimeZoneAndLocale) {
  const fs::path project = small_project("one\n"), out = project / "class", again = project / "again";
  ASSERT_EQ(make_samples(HAIR_PROJECT, out).code, 0);
  setenv("TZ", "America/New_York", 1);
  setenv("LC_ALL", "C", 1);
  ASSERT_EQ(make_samples(HAIR_PROJECT, again).code, 0);
  unsetenv("TZ");
  unsetenv("LC_ALL");
  for (const Sample& sample : read_samples(HAIR_PROJECT)) {
    if (sample.form == SampleForm::folder) continue;
    EXPECT_TRUE(hair::bytes_of(out / sample.file_name()) == hair::bytes_of(again / sample.file_name()))
        << sample.name;
  }
  fs::remove_all(project);
}

TEST(MakeSamples, Edits) {
  const fs::path project = small_project("one\n");
  const Outcome run = make_samples(project, project / "class");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_EQ(hair::bytes_of(project / "class" / "bug" / "a.cpp"), "two\n");
}

TEST(MakeSamples, CopiesWhatIsMarkedToTheShowcase) {
  const fs::path project = small_project("one\n"), out = project / "class", showcase = project / "showcase";
  add_sample(project, "shown", "form folder\nfile plain src/a.cpp\nshowcase\n");
  add_sample(project, "shown-first", "form folder\nfile plain a.cpp\nshowcase first\n", "others");
  const Outcome run = make_samples(project, out, showcase);
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_EQ(hair::bytes_of(showcase / "shown" / "src" / "a.cpp"), "one\n");
  EXPECT_FALSE(fs::exists(showcase / "bug"));
  EXPECT_TRUE(fs::exists(showcase / "shown-first"));
  EXPECT_TRUE(fs::exists(project / "class-first/shown-first/a.cpp"));
  EXPECT_FALSE(fs::exists(project / "class-first/shown"));
  EXPECT_TRUE(fs::exists(out / "bug"));
}

TEST(MakeSamples, PacksAttacksByPlaceAndApartFromTheClass) {
  const fs::path project = small_project("one\n"), out = project / "class",
                 attacks = project / "class-attacks";
  add_sample(project, "attacks", "form folder\nfile plain a.cpp\nstatus A wrong\n" + kAttack);
  add_sample(project, "honest", "form folder\nfile plain a.cpp\nbeside-attacks\n", "right");
  const Outcome run = make_samples(project, out);
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_FALSE(fs::exists(out / "attacks"));
  EXPECT_TRUE(fs::exists(attacks / "start" / "attacks"));
  EXPECT_FALSE(fs::exists(attacks / "run" / "attacks"));
  for (const char* place : kPlaces) EXPECT_TRUE(fs::exists(attacks / place / "honest")) << place;
  EXPECT_TRUE(fs::exists(out / "honest"));
}

TEST(MakeSamples, OverwritesBytesFromBothEnds) {
  const fs::path project = small_project("one\n"), out = project / "class";
  const std::string sample = "form zip\nfile plain a.cpp\n";
  add_sample(project, "forged", sample + "overwrite 0 00ff\noverwrite -2 fe\n");
  Outcome run = make_samples(project, out);
  EXPECT_EQ(run.code, 0) << run.output;
  const std::string bytes = hair::bytes_of(out / "forged.zip");
  EXPECT_EQ(bytes.substr(0, 2), std::string("\0\xff", 2));
  EXPECT_EQ(bytes.substr(bytes.size() - 2, 1), "\xfe");
  add_sample(project, "forged", sample + "overwrite 100000 00\n");
  run = make_samples(project, out);
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.output.find("nothing to overwrite at 100000"), std::string::npos) << run.output;
}

TEST(MakeSamples, RefusesAnEditWhoseLinesAreNotThereOnce) {
  for (const auto& [source, words] :
       {std::pair("three\n", "has no line \"one\""), std::pair("one\none\n", "2 times, in lines 1, 2")}) {
    const fs::path project = small_project(source);
    const Outcome run = make_samples(project, project / "class");
    EXPECT_EQ(run.code, 2);
    EXPECT_NE(run.output.find("bugs.samples:8: sample \"bug\": a.cpp "), std::string::npos) << run.output;
    EXPECT_NE(run.output.find(words), std::string::npos) << run.output;
    EXPECT_FALSE(fs::exists(project / "class"));
  }
}

TEST(MakeSamples, RefusesAnEditOfAFileThatIsNotThere) {
  const fs::path project = small_project("one\n");
  add_sample(project, "more", "form zip\nfile plain a.cpp\nedit b.cpp\n-stub\n");
  const Outcome run = make_samples(project, project / "class");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.output.find("more.samples:6: sample \"more\": it has no b.cpp"), std::string::npos)
      << run.output;
}

TEST(MakeSamples, NamesASolutionThatIsNotThere) {
  const fs::path project = small_project("one\n");
  fs::remove(project / "reference/A/right/plain.cpp");
  const Outcome run = make_samples(project, project / "class");
  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.output.find("sample \"bug\": a.cpp: "), std::string::npos) << run.output;
}

TEST(MakeSamples, FillsInTheOtherExercises) {
  const fs::path project = small_project("one\n"), out = project / "class";
  for (const auto& [others, bytes] : {std::pair("stub", "stub\n"), std::pair("reference", "reference\n")}) {
    add_sample(project, "more", "form folder\nfile plain src/a.cpp\nothers " + std::string(others) + "\n");
    const Outcome run = make_samples(project, out);
    EXPECT_EQ(run.code, 0) << run.output;
    EXPECT_EQ(hair::bytes_of(out / "more" / "b.cpp"), bytes);
    EXPECT_EQ(hair::bytes_of(out / "more" / "src" / "a.cpp"), "one\n");
  }
}

TEST(MakeSamples, PutsPartsIntoEdits) {
  const fs::path project = small_project("one\n");
  std::ofstream(project / "grader/samples/groups/more.samples")
      << "title More\npart both\n+three\n+four\n\nsample more\nshows It.\nform folder\nfile plain "
         "a.cpp\nedit\n=one\n*both\n+five\n";
  ASSERT_EQ(make_samples(project, project / "class").code, 0);
  EXPECT_EQ(hair::bytes_of(project / "class/more/a.cpp"), "one\nthree\nfour\nfive\n");
}

}  // namespace
}  // namespace grader::samples
