#include "hair/live/program_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "hair/io/files/temporary_folder.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

TEST(ProgramFile, IsNewOnceWhenItWasBuiltAnewAndNoLongerChanges) {
  const TemporaryFolder folder("hair-live");
  const fs::path path = folder.path() / "program";
  const auto build = [&](int seconds) {
    std::ofstream(path) << seconds;
    fs::permissions(path, fs::perms::owner_all);
    fs::last_write_time(path, fs::file_time_type() + std::chrono::seconds(seconds));
  };
  const auto looks_new = [](ProgramFile& file) {
    int times = 0;
    for (int i = 0; i < 20; ++i) times += file.is_new() ? 1 : 0;
    return times;
  };
  build(1);
  ProgramFile file(path);
  EXPECT_EQ(looks_new(file), 0);
  build(2);
  EXPECT_FALSE(file.is_new()) << "it may be half written";
  build(3);
  EXPECT_FALSE(file.is_new()) << "it changed again";
  EXPECT_EQ(looks_new(file), 1);
  fs::remove(path);
  EXPECT_EQ(looks_new(file), 0) << "the linker has taken it away";
  build(4);
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(looks_new(file), 0) << "it can't be started yet";
  fs::permissions(path, fs::perms::owner_all);
  EXPECT_EQ(looks_new(file), 1);
}

}  // namespace
}  // namespace hair
