// STAFF ONLY. Tests that the secret is the same on another machine, and that none is lost.
#include "grader/grading/secret.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "grader/course/input.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline grading {
namespace {

namespace fs = std::filesystem;

class Secret : public testing::Test {
 protected:
  void at(const std::string& machine) const {
    setenv("XDG_CONFIG_HOME", (folder_.path() / machine).c_str(), 1);
  }
  ~Secret() override { unsetenv("XDG_CONFIG_HOME"); }

  const hair::TemporaryFolder folder_{"secret"};
};

TEST_F(Secret, TheSameInputsAreDrawnOnAnotherMachine) {
  at("old");
  const std::string secret = read_secret({});
  const fs::path copy = folder_.path() / "copy";
  const std::string exported = export_secret(copy);
  EXPECT_EQ(fs::status(copy).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  at("new");
  EXPECT_EQ(import_secret(copy), exported);
  EXPECT_EQ(read_secret({}), secret);
  EXPECT_EQ(fs::status(default_secret_file()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(import_secret(copy), exported);  // has nothing to do the second time
  EXPECT_EQ(std::distance(fs::directory_iterator(default_secret_file().parent_path()), {}), 1);
}

TEST_F(Secret, NoneIsReplacedAndNoneIsMadeToBeExported) {
  at("first");
  EXPECT_THROW(export_secret(folder_.path() / "copy"), BadInput);
  EXPECT_FALSE(fs::exists(default_secret_file()));
  const std::string first = read_secret({});
  export_secret(folder_.path() / "copy");
  EXPECT_THROW(export_secret(folder_.path() / "copy"), BadInput);
  EXPECT_THROW(export_secret(folder_.path() / "missing" / "copy"), BadInput);
  at("second");
  const std::string second = read_secret({});
  EXPECT_NE(fingerprint(first), fingerprint(second));
  EXPECT_THROW(import_secret(folder_.path() / "copy"), BadInput);
  EXPECT_EQ(read_secret({}), second);
  write_file(folder_.path() / "short", "fifteen letters");
  at("third");
  EXPECT_THROW(import_secret(folder_.path() / "short"), BadInput);
  EXPECT_FALSE(fs::exists(default_secret_file()));
}

}  // namespace
}  // namespace grader::grading
