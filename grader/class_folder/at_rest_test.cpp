// STAFF ONLY. Tests that another user can open the places that are reported as open, and no others.
#include "grader/class_folder/at_rest.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "grader/course/input.h"
#include "hair/io/files/temporary_folder.h"

namespace grader::inline class_folder {
namespace {

namespace fs = std::filesystem;

class AtRest : public testing::Test {
 protected:
  AtRest() {
    fs::create_directories(folder_.path() / "course" / "reference");
    write_file(file(), "an answer");
    set(folder_.path(), 0755);
  }

  static void set(const fs::path& path, unsigned mode) {
    fs::permissions(path, static_cast<fs::perms>(mode));
  }

  // Reads as a user that has no account here; only root can do this.
  bool another_user_reads(const fs::path& path) const {
    const pid_t asking = fork();
    if (asking == 0) {
      if (setresgid(64999, 64999, 64999) != 0 || setresuid(64999, 64999, 64999) != 0) _exit(2);
      _exit(access(path.c_str(), R_OK) == 0 ? 0 : 1);
    }
    int status = 0;
    waitpid(asking, &status, 0);
    EXPECT_NE(WEXITSTATUS(status), 2);
    return WEXITSTATUS(status) == 0;
  }

  fs::path course() const { return folder_.path() / "course"; }
  fs::path file() const { return course() / "reference" / "answer.cpp"; }

  std::string told(const std::string& name, const fs::path& place, const fs::path& top) const {
    return readable_by_others({{name, place, top}});
  }

  const hair::TemporaryFolder folder_{"at-rest"};
};

TEST_F(AtRest, WhatIsToldIsWhatAnotherUserReads) {
  int told_open = 0;
  for (const unsigned top : {0700U, 0710U, 0711U, 0755U, 0744U})
    for (const unsigned below : {0700U, 0750U, 0711U, 0755U})
      for (const unsigned leaf : {0600U, 0640U, 0644U}) {
        SCOPED_TRACE(testing::Message() << std::oct << top << " " << below << " " << leaf);
        set(course(), top), set(course() / "reference", below), set(file(), leaf);
        const bool open = !told("the answer", file(), course()).empty();
        if (geteuid() == 0) {
          EXPECT_EQ(open, another_user_reads(file()));
        }
        told_open += open ? 1 : 0;
      }
  EXPECT_EQ(told_open, 2 * 2);  // two ways for each folder to let others in, one for the file
}

TEST_F(AtRest, TheCommandShutsOthersOut) {
  const std::vector<StaffPlace> places = {{"the reference", course() / "reference", course()},
                                          {"the answer", file(), course()},
                                          {"a missing place", course() / "missing", course()}};
  EXPECT_EQ(readable_by_others(places),
            "others on this machine can read the reference, the answer; this keeps them out: chmod go= " +
                course().string());
  const std::string line = readable_by_others(places);
  ASSERT_EQ(std::system(line.substr(line.find("chmod")).c_str()), 0);
  EXPECT_EQ(readable_by_others(places), "");
}

TEST_F(AtRest, OddNamesAreQuotedAndLinksAreFollowed) {
  const fs::path odd = folder_.path() / "it's $(odd)";
  fs::create_directory(odd);
  fs::create_directory_symlink(odd, course() / "link");
  const std::string line = told("a place", course() / "link", odd);
  ASSERT_EQ(std::system(line.substr(line.find("chmod")).c_str()), 0);
  EXPECT_EQ(told("a place", odd, odd), "");
  EXPECT_EQ(told("a place", course() / "link", odd), "");
}

}  // namespace
}  // namespace grader::class_folder
