// STAFF ONLY. Tests that a program sets what it inherits to the same values, whoever starts it, and that it
// names both numbers where a hard limit is below the need.
#include "grader/sandbox/inherited.h"

#include <gtest/gtest.h>
#include <linux/capability.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "hair/io/files/read_file.h"
#include "hair/io/files/start_program.h"
#include "hair/io/files/temporary_folder.h"
#include "solver/test_refusal.h"

namespace grader::inline sandbox {
namespace {

using std::string;
using tests::says;

class Inherited : public testing::Test {
 protected:
  // Returns the output of the program when a shell starts it after this script.
  string after(const string& script, const std::vector<string>& arguments = {},
               std::vector<string> words = {}) const {
    const string file = folder_.path() / "written";
    for (const string& word : {string("/usr/bin/bash"), string("-c"), script + "\nexec \"$0\" \"$@\"",
                               string(HAIR_INHERITOR), file})
      words.push_back(word);
    words.insert(words.end(), arguments.begin(), arguments.end());
    EXPECT_EQ(hair::exit_code_of(hair::start_program({.words = words, .environment = {"TMPDIR=/tmp"}})), 0)
        << script;
    return hair::bytes_of(file);
  }

  hair::TemporaryFolder folder_{"inherited"};
};

TEST_F(Inherited, IsTheSameWhoeverStartsIt) {
  const string usual = after("");
  EXPECT_TRUE(says(usual, "a thread's stack: 8388608\n"));
  EXPECT_TRUE(says(usual, "personality: 0\n"));
  EXPECT_FALSE(says(usual, "PATH"));
  for (const char* script : {
           "ulimit -S -v 8000000 -d 500000 -s 512 -m 1000",
           "ulimit -S -s unlimited -c unlimited",
           // Only the soft limit on the stack asks for another start here.
           "ulimit -S -s 512; exec env -i ${HOME:+HOME=\"$HOME\"} TMPDIR=/tmp \"$0\" \"$@\"",
           "ulimit -S -t 1000 -f 1000 -n 20 -u 200 -l 0 -i 5 -q 0 -x 7",
           "umask 777",
           "trap '' CHLD PIPE ALRM USR1 XCPU XFSZ SYS TERM INT QUIT",
           "exec 0<&- 1>&- 2>&-",
           "exec 0<&-",
           "export LD_PRELOAD=libm.so.6 LD_LIBRARY_PATH=/nowhere LD_BIND_NOW=1",
           "export OMP_NUM_THREADS=7 MALLOC_PERTURB_=3 GTEST_FILTER=-* LC_ALL=C.UTF-8 "
           "LIBGL_ALWAYS_SOFTWARE=1",
       })
    EXPECT_EQ(after(script), usual) << script;
  // A person wishes so, as with nohup.
  EXPECT_TRUE(says(after("trap '' HUP"), "ignored: 1\n"));

  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, &before);
  EXPECT_EQ(after(""), usual) << "signals are blocked";
  sigprocmask(SIG_SETMASK, &before, nullptr);
}

TEST_F(Inherited, KeepsAFolderForTemporaryFilesIfASandboxCanUseIt) {
  const auto folder_after = [&](const string& script) {
    const string state = after(script);
    const std::size_t at = state.find("TMPDIR=");
    return at == string::npos ? "" : state.substr(at + 7, state.find('\n', at) - at - 7);
  };
  const string folder = folder_.path();
  const string inner = folder + "/inner", shut = "mkdir -p " + inner + "; chmod 755 " + inner + "; chmod ";
  EXPECT_EQ(folder_after(shut + "755 " + folder + "; export TMPDIR=" + inner), inner);
  EXPECT_EQ(folder_after("export TMPDIR=/nowhere"), "");
  EXPECT_EQ(folder_after("export TMPDIR=relative"), "");
  EXPECT_EQ(folder_after("export TMPDIR=/etc/hostname"), "");
  if (geteuid() == 0) {
    EXPECT_EQ(folder_after(shut + "700 " + folder + "; export TMPDIR=" + inner), "")
        << "root is nobody there";
  }
}

// Outside of most containers root raises hard limits, too; this root may not.
TEST_F(Inherited, SaysWhichHardLimitIsBelowTheNeed) {
  struct Case {
    const char* limit;
    const char* said;
  };
  const Case cases[] = {
      {"-v 4000000", "the address space is 4000000 kB, and grading needs 4194304 kB"},
      {"-d 500000", "a process's data is 500000 kB, and grading needs 4194304 kB"},
      {"-s 4096", "the stack is 4096 kB, and grading needs 8192 kB"},
      {"-f 100000", "a file's size is 100000 kB, and grading needs 524288 kB"},
      {"-t 100", "CPU time, in seconds, is 100, and grading needs 150"},
      {"-n 100", "open files is 100, and grading needs 320"},
      {"-u 100", "a user's processes is 100, and grading needs 144"},
  };
  std::vector<string> bound;
  if (geteuid() == 0)
    bound = {"/usr/bin/setpriv", "--bounding-set=-sys_resource", "--inh-caps=-sys_resource"};
  EXPECT_EQ(after("", {"needs"}, bound), "enough");
  for (const Case& one : cases) {
    const string said = after("ulimit " + string(one.limit), {"needs"}, bound);
    EXPECT_TRUE(said.starts_with("the hard limit on " + string(one.said))) << said;
    EXPECT_TRUE(says(said, string("ulimit -H") + one.limit[1]));
    if (geteuid() == 0 && prctl(PR_CAPBSET_READ, CAP_SYS_RESOURCE) == 1) {
      EXPECT_EQ(after("ulimit " + string(one.limit), {"needs"}), "enough") << one.limit;
    }
  }
}

}  // namespace
}  // namespace grader::sandbox
