#include "hair/io/files/read_file.h"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <filesystem>
#include <string>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/io/files/temporary_folder.h"
#include "hair/io/files/write_file.h"
#include "solver/test_refusal.h"

namespace hair {
namespace {

namespace fs = std::filesystem;

std::string refusal(const fs::path& file, std::size_t most = 100) {
  return tests::refusal<BadInput>([&] { read_file(file, most, "a scene"); });
}

TEST(ReadFile, GivesWhatIsThereUpToTheLimit) {
  const TemporaryFolder folder("hair-read-file");
  const fs::path file = folder.path() / "file";
  write_file(file, std::string(100, 'x'));
  EXPECT_EQ(read_file(file, 100, "a scene"), std::string(100, 'x'));
  EXPECT_EQ(refusal(file, 99),
            file.string() + ": can't be read (it has more than 99 bytes); give the path of a scene");
  EXPECT_THROW(write_file(file / "in a file", ""), BadInput);
}

// A test that hangs fails by its time limit.
TEST(ReadFile, WaitsForNoPipeAndReadsNoDevice) {
  const TemporaryFolder folder("hair-read-file");
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const std::string why = ": can't be read (it is no regular file); give the path of a scene";
  EXPECT_EQ(refusal(pipe), pipe.string() + why);
  EXPECT_EQ(refusal("/dev/zero"), "/dev/zero" + why);
}

TEST(ReadFile, SaysWhatIsNotThere) {
  EXPECT_NE(refusal("/").find("directory"), std::string::npos);
  EXPECT_NE(refusal("/none").find("No such file"), std::string::npos);
}

TEST(Printable, EveryByteBecomesPlainAsciiAndDifferentNamesNeverLookTheSame) {
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
  for (const char c : printable(all, 256)) {
    EXPECT_TRUE(c >= 0x20 && c < 0x7f) << static_cast<int>(c);
  }
  EXPECT_EQ(printable("alice/conj_grad.cpp"), "alice/conj_grad.cpp");
  EXPECT_EQ(printable(std::string("\x1b[2J\0\n", 6)), "\\x1b[2J\\x00\\x0a");
  EXPECT_NE(printable("\x1b"), printable("\\x1b"));
  EXPECT_EQ(printable("abcdef", 3), "abc...");
}

}  // namespace
}  // namespace hair
