// STAFF ONLY. Tests that the same bytes get the same grade: twenty times, alone and with twenty programs that
// compete for the processors, with and without cached objects.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "grader/tests/run_program.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using tests::says;

constexpr int kTimes = 20, kPrograms = 20;
// In each round of five gradings the first compiles, and the first two run with the other programs.
constexpr int kRound = 5, kBesideOthers = 2;
constexpr const char* kFile = "stretch_springs.cpp";

// Runs programs that compete for the processors, while it lives.
class Load {
 public:
  Load() {
    for (int i = 0; i < kPrograms; ++i)
      programs_.emplace_back([](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
        }
      });
  }

 private:
  std::vector<std::jthread> programs_;
};

TEST(UnderLoad, GivesTheSameBytesTwentyTimes) {
  const hair::TemporaryFolder temporary("under-load");
  const fs::path& folder = temporary.path();
  const fs::path students = folder / "class", cache = folder / "cache";
  const std::string right = hair::bytes_of(fs::path(HAIR_PROJECT) / "reference/H1" / kFile);
  const auto hand_in = [&](const std::string& name, const std::string& text) {
    fs::create_directories(students / name);
    std::ofstream(students / name / kFile) << text;
  };
  hand_in("right", right);
  // This code depends on the second of its compilation, and its warning is shown.
  hand_in("clock",
          "#include <stdexcept>\n"
          "static bool odd() { int unused; return __TIME__[7] % 2 == 1; }\n"
          "struct Sometimes { Sometimes() { if (odd()) throw std::runtime_error(__TIMESTAMP__); } } "
          "sometimes;\n" +
              right);
  hand_in("naps", "#include <unistd.h>\nstruct Nap { Nap() { usleep(200000); } } nap;\n" + right);
  hand_in("crashes", "#include <cstdlib>\nstruct Crash { Crash() { abort(); } } crash;\n" + right);

  std::ofstream(folder / "secret") << "a secret for this test";

  std::map<std::string, std::string> first;
  for (int time = 0; time < kTimes; ++time) {
    if (time % kRound == 0) fs::remove_all(cache);
    std::optional<Load> load;
    if (time % kRound < kBesideOthers) load.emplace();
    const fs::path out = folder / std::to_string(time);
    const ProgramRun run =
        run_hairgrade({"grade", students.string(), "--out", out.string(), "--exercise", "H1", "--secret",
                       (folder / "secret").string(), "--cache", cache.string()});
    ASSERT_EQ(run.code, 0) << run.errors;
    std::map<std::string, std::string> all = files_in(out);
    EXPECT_EQ(all.erase("timing.json") + all.erase("costs.html"), 2U);
    if (time == 0) {
      first = all;
      const std::string grades = all.at("grades.csv");
      EXPECT_TRUE(says(grades, "right"));
    }
    EXPECT_EQ(all.size(), first.size());
    for (const auto& [name, bytes] : first)
      EXPECT_TRUE(all.count(name) > 0 && all.at(name) == bytes) << name << ", time " << time;
    fs::remove_all(out);
  }
}

}  // namespace
}  // namespace grader
