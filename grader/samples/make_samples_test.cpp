// STAFF ONLY. Tests that samples are packed as their groups say, and equally each time.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <utility>

#include "grader/intake/archives/archive.h"
#include "grader/samples/sample.h"
#include "grader/samples/small_project.h"
#include "hair/io/files/read_file.h"
#include "solver/test_refusal.h"

namespace grader::inline samples {
namespace {

using tests::says;

// Returns the output of make_samples, which must end with this code.
std::string make_samples(const fs::path& project, const fs::path& out, int code = 0) {
  const fs::path log = scratch("log"), showcase = scratch("project") / "showcase";
  const std::string command = std::string("'") + HAIR_MAKE_SAMPLES + "' '" + project.string() + "' '" +
                              out.string() + "' '" + showcase.string() + "' '" + out.string() + "-first' '" +
                              out.string() + "-attacks' >'" + log.string() + "' 2>&1";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WIFEXITED(status) ? WEXITSTATUS(status) : -1, code) << hair::bytes_of(log);
  return hair::bytes_of(log);
}

TEST(MakeSamples, GivesTheSameBytesWhateverTheTimeZoneAndLocale) {
  const fs::path project = small_project("one\n"), out = project / "class", again = project / "again";
  make_samples(HAIR_PROJECT, out);
  setenv("TZ", "America/New_York", 1);
  setenv("LC_ALL", "C", 1);
  make_samples(HAIR_PROJECT, again);
  unsetenv("TZ");
  unsetenv("LC_ALL");
  for (const Sample& sample : read_samples(HAIR_PROJECT)) {
    if (sample.form == SampleForm::folder) continue;
    EXPECT_TRUE(hair::bytes_of(out / sample.file_name()) == hair::bytes_of(again / sample.file_name()))
        << sample.name;
  }
  fs::remove_all(project);
}

// Zeros are more than the writer packs at a time.
TEST(MakeSamples, PacksEachKindOfFileInEachForm) {
  const fs::path project = small_project("one\n"), out = project / "class";
  const std::string zeros = "200000000";
  for (const auto& [form, ending] : {std::pair{"folder", ""}, {"zip", ".zip"}, {"tar.gz", ".tar.gz"}}) {
    const bool is_folder = form == std::string("folder");
    add_sample(project, "each",
               std::string("form ") + form + "\nwindows\nfile plain a.cpp\nzeros " +
                   (is_folder ? "3" : zeros) + " b.bin\nlink ../x c\ntext \"t\\n\" d/t.txt\n");
    make_samples(project, out);
    const fs::path packed = out / (std::string("each") + ending);
    if (is_folder) {
      EXPECT_EQ(hair::bytes_of(packed / "a.cpp"), "\xef\xbb\xbfone\r\n");
      EXPECT_EQ(hair::bytes_of(packed / "b.bin"), std::string(3, '\0'));
      EXPECT_EQ(fs::read_symlink(packed / "c"), "../x");
      EXPECT_EQ(hair::bytes_of(packed / "d/t.txt"), "t\n");
      continue;
    }
    EXPECT_LT(fs::file_size(packed), 400'000u);
    const auto archive = open_here(packed, "each", {.unpacked_bytes = 300'000'000, .entries = 10});
    const std::vector<Entry> list = archive->list();
    ASSERT_EQ(list.size(), 4u);
    EXPECT_EQ(std::to_string(list[1].bytes), zeros);
    EXPECT_EQ(list[2].kind, Entry::Kind::symbolic_link);
    std::string texts;
    archive->visit({0, 3}, [&](std::size_t, const Container::Read& read) { texts += read(100); });
    EXPECT_EQ(texts, "\xef\xbb\xbfone\r\nt\n");
  }
}

TEST(MakeSamples, CopiesWhatIsMarkedToTheShowcase) {
  const fs::path project = small_project("one\n"), out = project / "class", showcase = project / "showcase";
  add_sample(project, "shown", "form folder\nfile plain src/a.cpp\nshowcase\n");
  add_sample(project, "shown-first", "form folder\nfile plain a.cpp\nshowcase first\n", "others");
  make_samples(project, out);
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
  make_samples(project, out);
  EXPECT_FALSE(fs::exists(out / "attacks"));
  EXPECT_TRUE(fs::exists(attacks / "start" / "attacks"));
  EXPECT_FALSE(fs::exists(attacks / "run" / "attacks"));
  for (const char* place : kPlaces) EXPECT_TRUE(fs::exists(attacks / place / "honest")) << place;
  EXPECT_TRUE(fs::exists(out / "honest"));
}

TEST(MakeSamples, CutsAndOverwritesBytesFromBothEnds) {
  const fs::path project = small_project("one\n"), out = project / "class";
  const std::string sample = "form zip\nfile plain a.cpp\n";
  add_sample(project, "forged", sample + "overwrite 0 00ff\noverwrite -2 fe\n");
  make_samples(project, out);
  const std::string bytes = hair::bytes_of(out / "forged.zip");
  EXPECT_EQ(bytes.substr(0, 2), std::string("\0\xff", 2));
  EXPECT_EQ(bytes.substr(bytes.size() - 2, 1), "\xfe");
  add_sample(project, "forged", sample + "overwrite 100000 00\n");
  EXPECT_TRUE(says(make_samples(project, out, 2), "nothing to overwrite at 100000"));
  add_sample(project, "cut", sample + "cut 17\n");
  make_samples(project, out);
  EXPECT_EQ(fs::file_size(out / "cut.zip"), 17u);
}

TEST(MakeSamples, RefusesASampleThatCanNotBeMade) {
  const struct {
    const char *source, *more, *words;  // "": the solution is missing
  } rows[] = {
      {"three\n", nullptr, "bugs.samples:8: sample \"bug\": a.cpp has no line \"one\""},
      {"one\n", "form zip\nfile plain a.cpp\nedit b.cpp\n-stub\n",
       "more.samples:6: sample \"more\": it has no b.cpp"},
      {"", nullptr, "sample \"bug\": a.cpp: "},
  };
  for (const auto& [source, more, words] : rows) {
    const fs::path project = small_project(source);
    if (*source == '\0') fs::remove(project / "reference/A/right/plain.cpp");
    if (more != nullptr) add_sample(project, "more", more);
    EXPECT_TRUE(says(make_samples(project, project / "class", 2), words));
    EXPECT_FALSE(fs::exists(project / "class"));
  }
}

TEST(MakeSamples, FillsInTheOtherExercises) {
  const fs::path project = small_project("one\n"), out = project / "class";
  for (const auto& [others, bytes] : {std::pair("stub", "stub\n"), std::pair("reference", "reference\n")}) {
    add_sample(project, "more", "form folder\nfile plain src/a.cpp\nothers " + std::string(others) + "\n");
    make_samples(project, out);
    EXPECT_EQ(hair::bytes_of(out / "more" / "b.cpp"), bytes);
    EXPECT_EQ(hair::bytes_of(out / "more" / "src" / "a.cpp"), "one\n");
  }
}

TEST(MakeSamples, PutsPartsIntoEdits) {
  const fs::path project = small_project("one\n");
  std::ofstream(project / "grader/samples/groups/more.samples")
      << "title More\npart both\n+three\n+four\n\nsample more\nshows It.\nform folder\nfile plain "
         "a.cpp\nedit\n=one\n*both\n+five\n";
  make_samples(project, project / "class");
  EXPECT_EQ(hair::bytes_of(project / "class/more/a.cpp"), "one\nthree\nfour\nfive\n");
}

}  // namespace
}  // namespace grader::samples
