#include "hair/io/files/read_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/write_file.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

std::string refusal(const fs::path& file, std::size_t most = 100) {
  return tests::refusal<BadInput>([&] { read_file(file, most, "a scene"); });
}

class ReadFile : public testing::Test {
 protected:
  void SetUp() override { fs::create_directory(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  const fs::path folder_ = fs::temp_directory_path() / ("hair-read-file-" + std::to_string(getpid()));
};

TEST_F(ReadFile, GivesWhatIsThereUpToTheLimit) {
  const fs::path file = folder_ / "file";
  write_file(file, std::string(100, 'x'));
  EXPECT_EQ(read_file(file, 100, "a scene"), std::string(100, 'x'));
  EXPECT_EQ(refusal(file, 99),
            file.string() + ": can't be read (it has more than 99 bytes); give the path of a scene");
}

// A test that hangs fails by its time limit.
TEST_F(ReadFile, WaitsForNoPipeAndReadsNoDevice) {
  const fs::path pipe = folder_ / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string why = ": can't be read (it is no regular file); give the path of a scene";
  EXPECT_EQ(refusal(pipe), pipe.string() + why);
  EXPECT_EQ(refusal("/dev/zero"), "/dev/zero" + why);
}

TEST_F(ReadFile, SaysWhatIsNotThere) {
  EXPECT_NE(refusal(folder_).find("directory"), std::string::npos);
  EXPECT_NE(refusal(folder_ / "none").find("No such file"), std::string::npos);
}

}  // namespace
}  // namespace hair
