// STAFF ONLY. Tests hand-ins as large as real ones: a build folder of 320 MB and 25,000 files in .git. Their
// exercise files are taken, and memory stays within the need of lists and one block.
#include <sys/resource.h>

#include <fstream>
#include <iomanip>
#include <iostream>

#include "grader/intake/submissions_fixture.h"

namespace grader::inline intake {
namespace {

constexpr int kObjects = 160, kInGit = 25'000;
constexpr std::size_t kObjectBytes = std::size_t{2} << 20;

// Bounds the growth of the test's peak memory: the lists have several copies of 25,000 paths of about 300
// bytes, and an archive of zeros has less than 10 MB. A reader that keeps the build folder needs 320 MB.
constexpr double kMostMegabytes = 100;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kMemoryIsOurs = false;  // the sanitiser keeps freed memory for a while
#else
constexpr bool kMemoryIsOurs = true;
#endif

double megabytes_of(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size())) / 1024;
  return 0;
}

double cpu_seconds() {
  double seconds = 0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage{};
    getrusage(who, &usage);
    for (const timeval& time : {usage.ru_utime, usage.ru_stime})
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return seconds;
}

// Passes the path and size of each file of such a hand-in.
template <class Take>
void each_file(Take take) {
  for (int i = 0; i < kInGit; ++i)
    take(".git/objects/" + std::to_string(i % 256) + "/" + std::to_string(i), std::size_t{200});
  for (int i = 0; i < kObjects; ++i)
    take("build/CMakeFiles/part.dir/o" + std::to_string(i) + ".o", kObjectBytes);
}

std::string packed(Packing packing) {
  ArchiveBuilder builder(packing);
  each_file([&](const std::string& path, std::size_t bytes) { builder.zeros("hair/" + path, bytes); });
  builder.file("hair/build/normal_equations.cpp", "in the build");
  return builder.file("hair/student/conj_grad.cpp", "fine").bytes();
}

class RealSizes : public Submissions {
 protected:
  void expect_taken(const std::string& what, const fs::path& argument, std::size_t people = 1) {
    std::ofstream("/proc/self/clear_refs") << "5\n";  // forgets the peak so far
    const double memory = megabytes_of("VmRSS:"), before = cpu_seconds();
    const Intake intake = take({argument});
    const double seconds = cpu_seconds() - before, peak = megabytes_of("VmHWM:") - memory;
    rusage readers{};
    getrusage(RUSAGE_CHILDREN, &readers);
    ASSERT_EQ(intake.submissions.size(), people);
    for (const Submission& one : intake.submissions) {
      EXPECT_EQ(one.problem, "");
      ASSERT_EQ(one.files.size(), 2U);
      EXPECT_EQ(one.files.at("conj_grad.cpp").text, "fine");
      EXPECT_EQ(one.files.at("normal_equations.cpp").text, "in the build");
    }
    EXPECT_EQ(intake.notices, Names{});
    if (kMemoryIsOurs) {
      EXPECT_LT(peak, kMostMegabytes);
    }
    std::cout << "| " << what << " | " << std::fixed << std::setprecision(2) << seconds << " | "
              << std::setprecision(0) << peak << " | " << static_cast<double>(readers.ru_maxrss) / 1024
              << " |\n";
  }
  static void SetUpTestSuite() {
    std::cout << "| a hand-in of 320 MB, 25,162 files | CPU seconds | peak MB beyond what was there | peak "
                 "MB of readers |\n"
                 "|---|--:|--:|--:|\n";
  }
};

TEST_F(RealSizes, OfArchivesAreRead) {
  for (const auto& [name, packing] :
       {std::pair{"alice.zip", Packing::zip}, std::pair{"bob.tar.gz", Packing::tar_gz}}) {
    const std::string bytes = packed(packing);
    expect_taken(name, write(name, bytes));
    const fs::path in_class = write("class/" + std::string(name), bytes);
    expect_taken(
        "a class with " + std::string(name),
        write("class.zip",
              ArchiveBuilder(Packing::zip).file(in_class.filename(), bytes).file("carol.zip", bytes).bytes()),
        2);
  }
}

TEST_F(RealSizes, OfFoldersAreRead) {
  const fs::path folder = dir_ / "class" / "alice";
  each_file([&](const std::string& path, std::size_t bytes) {
    const fs::path file = folder / path;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << "x";
    fs::resize_file(file, bytes);
  });
  write("class/alice/build/normal_equations.cpp", "in the build");
  write("class/alice/student/conj_grad.cpp", "fine");
  expect_taken("a folder", folder);
  fs::create_directories(dir_ / "class" / "bob" / "student");
  fs::copy(folder / "build", dir_ / "class" / "bob" / "build", fs::copy_options::recursive);
  fs::copy(folder / "student", dir_ / "class" / "bob" / "student", fs::copy_options::recursive);
  expect_taken("a class of folders", dir_ / "class", 2);
}

}  // namespace
}  // namespace grader::intake
