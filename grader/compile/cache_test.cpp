// STAFF ONLY. Tests that the cache has a bound, and gives back what was kept.
#include "grader/compile/cache.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <set>

#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline compile {
namespace {

namespace fs = std::filesystem;

class Cache : public testing::Test {
 protected:
  // Adds a file that was used `age` seconds ago.
  void add(const std::string& name, std::size_t bytes, int age) const {
    std::ofstream(dir_ / name) << std::string(bytes, 'x');
    fs::last_write_time(dir_ / name, fs::file_time_type::clock::now() - std::chrono::seconds(age));
  }
  std::set<std::string> names() const {
    std::set<std::string> all;
    for (const auto& entry : fs::directory_iterator(dir_)) all.insert(entry.path().filename().string());
    return all;
  }

  hair::TemporaryFolder temporary_{"cache"};
  const fs::path dir_ = temporary_.path();
};

TEST_F(Cache, LosesWhatWasUsedTheLongestTimeAgo) {
  add("old", 100, 300);
  add("used", 100, 400);
  add("new", 100, 1);
  fs::create_directory(dir_ / "pictures");
  mark_as_used(dir_ / "used");
  shrink_cache(dir_, 300);
  EXPECT_EQ(names(), (std::set<std::string>{"new", "old", "pictures", "used"}));
  shrink_cache(dir_, 299);
  EXPECT_EQ(names(), (std::set<std::string>{"new", "pictures", "used"}));
  shrink_cache(dir_, 0);
  EXPECT_EQ(names(), std::set<std::string>{"pictures"});
}

TEST_F(Cache, GivesBackWhatWasKept) {
  for (const KeptObject& kept : {KeptObject{"object\n\0x", "a log\n12\n"}, {"", ""}, {"7\n", ""}}) {
    std::ofstream(dir_ / "kept", std::ios::binary) << text_of(kept);
    const std::optional<KeptObject> found = read_kept(dir_ / "kept");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->object, kept.object);
    EXPECT_EQ(found->log, kept.log);
    EXPECT_EQ(found->cpu_seconds, kept.cpu_seconds);
  }
  for (const char* damaged :
       {"", "\n", "9 1\nlog", "x\n", "123456789012345678901 1\n", "3", "3 ", "3 1", "3\nlog"}) {
    std::ofstream(dir_ / "kept", std::ios::binary) << damaged;
    EXPECT_FALSE(read_kept(dir_ / "kept")) << damaged;
  }
  EXPECT_FALSE(read_kept(dir_ / "nobody"));
}

}  // namespace
}  // namespace grader::compile
