// STAFF ONLY. Tests that the groups of samples are read strictly.
#include "grader/samples/sample.h"

#include "grader/course/input.h"
#include "grader/samples/small_project.h"
#include "solver/test_refusal.h"

namespace grader::inline samples {
namespace {

using tests::says;

void expect_refused(const fs::path& project, const std::string& words) {
  EXPECT_TRUE(says(tests::refusal<BadInput>([&] { read_samples(project); }), words));
}

TEST(ReadSamples, ComputesPointsFromTheCategoriesThatFail) {
  const fs::path project = small_project("one\n");
  const auto samples = read_samples(project);
  ASSERT_EQ(samples.size(), 1u);
  EXPECT_EQ(samples[0].expected.at("A").status, "partly");
  EXPECT_EQ(samples[0].expected.at("A").points, 3.0);
  EXPECT_EQ(samples[0].expected.at("A").failed, std::vector<std::string>{"The first"});
  EXPECT_EQ(samples[0].expected.at("B").points, std::nullopt);
  EXPECT_EQ(samples[0].group, "bugs");
  EXPECT_FALSE(samples[0].showcase);
  add_sample(project, "more", "form zip\nfile plain a.cpp\nstatus A crashed\nfails A Two\n");
  EXPECT_EQ(read_samples(project).at(1).expected.at("A").status, "crashed");
  EXPECT_EQ(read_samples(project).at(1).expected.at("A").points, 2.0);
}

TEST(ReadSamples, TakesTheShowcasesPointsAsTheyStandThere) {
  const fs::path project = small_project("one\n");
  add_sample(project, "more", "form zip\nshowcase\nfile plain a.cpp\nfails A Two\npoints A 1\n");
  EXPECT_EQ(read_samples(project).at(1).expected.at("A").points, 1.0);
}

TEST(ReadSamples, ReadsAttacks) {
  const fs::path project = small_project("one\n");
  add_sample(project, "attacks", "form zip\nalso crashed\nno-pictures\n" + kAttack);
  const std::vector<Sample> samples = read_samples(project);
  ASSERT_TRUE(samples.at(1).attack.has_value());
  const Attack& attack = *samples[1].attack;
  EXPECT_EQ(attack.place, "start");
  EXPECT_EQ(attack.fence, "A wall.");
  EXPECT_EQ(attack.most_points_of.at("A"), 2);
  EXPECT_EQ(attack.most_points, std::nullopt);
  EXPECT_EQ(attack.most_cpu_seconds, 1.5);
  EXPECT_EQ(attack.also, std::vector<std::string>{"crashed"});
  EXPECT_TRUE(attack.no_pictures);
  EXPECT_FALSE(samples[1].in_class());
  EXPECT_FALSE(samples[0].attack.has_value());
  add_sample(project, "attacks", "form zip\nshowcase\nplace run\nfence A wall.\nmost all 7\nseconds 1\n");
  EXPECT_EQ(read_samples(project).at(1).attack->most_points, 7.0);
  EXPECT_TRUE(read_samples(project)[1].in_class());
}

TEST(ReadSamples, ReadsTheGroupsInTheOrderOfTheirNames) {
  const fs::path project = small_project("one\n");
  add_sample(project, "more", "form zip\n");
  const auto samples = read_samples(project);
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_EQ(samples[0].name, "bug");
  EXPECT_EQ(samples[1].name, "more");
}

TEST(ReadSamples, ExpectsWhatHasAFileToPassAndAllElseToBeMissing) {
  const fs::path project = small_project("one\n");
  EXPECT_EQ(read_samples(project)[0].expected.at("B").status, "missing");
  EXPECT_EQ(read_samples(project)[0].listed, std::vector<std::string>{"A"});
  add_sample(project, "more", "form zip\nfile plain a.cpp\n");
  EXPECT_EQ(read_samples(project)[1].expected.at("A").status, "passed");
  add_sample(project, "more", "form zip\nothers reference\n");
  EXPECT_EQ(read_samples(project)[1].expected.at("B").status, "passed");
  add_sample(project, "more", "form zip\nothers stub\n");
  EXPECT_EQ(read_samples(project)[1].expected.at("B").status, "not implemented");
  add_sample(project, "more", "form zip\nstatus all can't be read\n");
  EXPECT_EQ(read_samples(project)[1].listed, (std::vector<std::string>{"A", "B"}));
}

TEST(ReadSamples, TakesTheGroupsLinesWhereTheSampleHasNone) {
  const fs::path project = small_project("one\n");
  std::ofstream(project / "grader/samples/groups/more.samples")
      << "title More\n# A comment.\nform zip\nfile plain a.cpp\nfile plain b.cpp\nothers stub\n\n"
         "sample first\nshows It.\n\nsample second\nshows It.\nform folder\nzeros 3 a.bin\nothers none\n";
  const auto samples = read_samples(project);
  EXPECT_EQ(samples.at(1).form, SampleForm::zip);
  EXPECT_EQ(samples[1].title, "More");
  EXPECT_EQ(samples[1].files.size(), 2U);
  EXPECT_EQ(samples.at(2).form, SampleForm::folder);
  ASSERT_EQ(samples[2].files.size(), 1U);
  EXPECT_EQ(samples[2].files[0].zeros, 3U);
}

TEST(ReadSamples, ReadsOddTextsAndPaths) {
  const fs::path project = small_project("one\n");
  add_sample(project, "more", "form zip\ntext \"a \\\"\\n\" \"b\\n c\"\nlink /etc/passwd two words\n");
  const auto files = read_samples(project).at(1).files;
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].path, "b\n c");
  EXPECT_EQ(files[0].value, "a \"\n");
  EXPECT_EQ(files[1].path, "two words");
  EXPECT_EQ(files[1].value, "/etc/passwd");
}

TEST(ReadSamples, NamesWhatIsNotRight) {
  const fs::path project = small_project("one\n");
  for (const auto& [lines, words] : std::vector<std::pair<std::string, std::string>>{
           {"form rar\n", "more.samples:4: unknown form; write zip"},
           {"form zip\nform zip\n", ":5: \"form\" is there already, in line 4"},
           {"", ":2: sample \"more\" lacks a line \"form\""},
           {"form zip\nothers plain\n", ":5: write reference, stub or none"},
           {"form zip\nstatus C wrong\n", ":5: there is no exercise C"},
           {"form zip\nothers stub\nstatus A wrong\n", ":6: names A, which \"others\" fills in"},
           {"form zip\nshowcase\nfails A One\npoints A 6\n",
            ":7: \"6\" is not right; give a number from 0 to 5"},
           {"form zip\nshowcase\nfails A One\npoints A 5x\n", ":7: \"5x\" is not right"},
           {"form zip\nfails A One\npoints A 3\n", ":6: points are computed; name the categories that fail"},
           {"form zip\nshowcase last\n", ":5: write showcase, or showcase first"},
           {"form zip\nshowcase\nfails A One\n", ":6: a sample of the showcase says its points of A, too"},
           {"form zip\nfails A Three\n", ":5: A has no category \"Three\"; it has One, Two"},
           {"form zip\nfails A One One\n", ":5: names One twice"},
           {"form zip\nfails A One Two\n", ":5: no category is left; write \"status A wrong\""},
           {"form zip\nfails A\n", ":5: name the categories that fail"},
           {"form zip\nshown\n", ":5: unknown word \"shown\""},
           {"form zip\nplace nowhere\n", ":5: unknown place; write build, "},
           {"form zip\nmost C 0\n", ":5: there is no exercise C"},
           {"form zip\nplace run\n", ":2: an attack has place, fence, most and seconds"},
           {"form zip\noverwrite 1 0\n", ":5: write two digits"},
           {"form zip\nfile plain\n", ":5: file lacks the path"},
           {"form zip\ntext \"a b\n", ":5: \"a b is no JSON string"},
           {"form zip\ntext a b\n", ":5: write the text as a JSON string"},
           {"form zip\n+one\n", ":5: this line belongs to no edit"},
           {"form zip\nedit\n", ":5: the sample has no \"file\""},
           {"form zip\nedit a.cpp\n*part\n", ":6: the group has no part \"part\""}}) {
    add_sample(project, "more", lines);
    expect_refused(project, words);
  }
  add_sample(project, "bug", "form zip\n");
  expect_refused(project, ":2: the name \"bug\" is taken");
}

}  // namespace
}  // namespace grader::samples
