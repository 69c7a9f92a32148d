// STAFF ONLY. Tests with random downloads that each student has one submission with the newest file, and that
// each file of the input is accounted for.
#include "grader/intake/random_downloads.h"

#include <cstdlib>
#include <map>

namespace grader::inline intake {
namespace {

class RandomDownloads : public Submissions {};

TEST_F(RandomDownloads, LoseNobodyAndNoFile) {
  const char* asked = std::getenv("HAIR_RANDOM_DOWNLOADS");
  const unsigned count = asked ? static_cast<unsigned>(std::atoi(asked)) : 400;
  std::map<std::string, int> of_system;
  for (unsigned seed = 0; seed < count; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Download download = Generator(seed).make();
    ++of_system[download.system];
    fs::path argument;
    if (seed % 4 == 0) {
      argument = dir_ / std::to_string(seed);
      for (const auto& [path, text] : download.files) write(std::to_string(seed) + "/" + path, text);
    } else {
      ArchiveBuilder builder(seed % 4 == 1 ? Packing::tar_gz : Packing::zip);
      for (const auto& [path, text] : download.files) builder.file(path, text);
      argument = write("download.zip", builder.bytes());
    }
    const Intake intake = take({argument});
    ASSERT_EQ(intake.submissions.size(), download.students.size())
        << testing::PrintToString(names(intake.submissions));
    EXPECT_EQ(intake.accounted.size(), download.files.size());
    EXPECT_EQ(intake.notices.size(),
              static_cast<std::size_t>(std::ranges::count(download.students, "", &Student::newest)))
        << "a line for each hand-in without a file, and no other: " << testing::PrintToString(intake.notices);
    std::map<std::string, const Submission*> by_id;
    for (const Submission& one : intake.submissions) by_id[one.owner.id] = &one;
    for (const Student& student : download.students) {
      SCOPED_TRACE(student.id);
      ASSERT_TRUE(by_id.contains(student.id)) << testing::PrintToString(names(intake.submissions));
      const Submission& one = *by_id.at(student.id);
      EXPECT_EQ(one.system, download.system);
      if (student.newest.empty()) {
        EXPECT_TRUE(says(one.problem, "None of the exercise files"));
        EXPECT_EQ(student.has_files, one.problem.find("It holds") != std::string::npos) << one.problem;
      } else {
        ASSERT_TRUE(one.files.contains("conj_grad.cpp")) << one.problem;
        EXPECT_EQ(one.files.at("conj_grad.cpp").text, student.newest);
      }
    }
    for (const Accounted& file : intake.accounted)
      EXPECT_TRUE(file.as == Accounted::As::made || !file.whose.empty()) << file.path;
    fs::remove_all(argument);
    if (HasFailure()) break;
  }
  EXPECT_GE(of_system.size(), std::min<std::size_t>(7, count / 20)) << "all systems were tried";
}

}  // namespace
}  // namespace grader::intake
