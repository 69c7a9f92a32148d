// STAFF ONLY. Leaves out each layer once: then the attempt that it stops succeeds, and is reported.
#include "grader/sandbox/fences.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string>
#include <string_view>

#include "grader/sandbox/isolation_for_tests.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/processes/launch.h"
#include "grader/sandbox/processes/staging_folder.h"
#include "grader/sandbox/processes/supervisor.h"
#include "grader/sandbox/system_mounts.h"

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;

// Removes words of bwrap's command.
void leave_out_words(Launch& launch, std::string_view first, int count = 1) {
  const auto at =
      std::ranges::find_if(launch.argv, [&](const char* word) { return word != nullptr && word == first; });
  ASSERT_NE(at, launch.argv.end()) << first;
  launch.argv.erase(at, at + count);
}

void add_words(Launch& launch, std::initializer_list<const char*> words) {
  const auto end = std::ranges::find_if(launch.argv, [](const char* word) {
    return word != nullptr && std::string_view(word) == "--remount-ro";
  });
  std::vector<char*> added;
  for (const char* word : words) added.push_back(const_cast<char*>(word));
  launch.argv.insert(end, added.begin(), added.end());
}

// Moves the probe to its place outside.
void leave_out_root(Launch& launch, RunLimits& /*limits*/) {
  static std::string probe = HAIR_PROBE;
  launch.root = nullptr;
  launch.argv.front() = probe.data();
}

struct LeftOut {
  const char* name;
  Isolation kind;
  SandboxedProcess::LeaveOut leave_out;
  std::string named;
};

const LeftOut kFences[] = {
    {"Nothing", Isolation::namespaces, [](Launch&, RunLimits&) {}, ""},
    {"User", Isolation::namespaces, [](Launch& launch, RunLimits&) { launch.identity = {}; },
     "student code can do all that root may: it is root\n"},
    // A grader that is not root has the same user as its sandboxes.
    {"Processes", Isolation::namespaces,
     [](Launch& launch, RunLimits&) {
       launch.identity = {};
       leave_out_words(launch, "--unshare-pid");
     },
     "student code can signal the staff's processes\n"},
    {"NoNamespacesInside", Isolation::namespaces,
     [](Launch& launch, RunLimits&) { leave_out_words(launch, "--disable-userns"); },
     "student code can make namespaces\n"},
    {"Etc", Isolation::namespaces,
     [](Launch& launch, RunLimits&) {
       add_words(launch, {"--ro-bind", "/etc", "/etc"});
     },
     "student code can read the system's files\n"},
    {"Proc", Isolation::namespaces,
     [](Launch& launch, RunLimits&) {
       add_words(launch, {"--proc", "/proc"});
     },
     "student code can read /proc\n"},
    {"ReadOnly", Isolation::namespaces,
     [](Launch& launch, RunLimits&) { leave_out_words(launch, "--remount-ro", 2); },
     "student code can write to /\n"},
    {"Filter", Isolation::namespaces,
     [](Launch& launch, RunLimits&) {
       if (launch.filter_file >= 0) leave_out_words(launch, "--seccomp", 2);
     },
     "student code can reach the network\n"},
    {"Network", Isolation::namespaces,
     [](Launch& launch, RunLimits&) { leave_out_words(launch, "--unshare-net"); },
     "student code can reach servers of this machine\n"},
    {"Nothing", Isolation::container, [](Launch&, RunLimits&) {}, ""},
    {"User", Isolation::container, [](Launch& launch, RunLimits&) { launch.identity = {}; },
     "student code can signal the staff's processes\n"},
    {"Root", Isolation::container, leave_out_root, "student code can read the system's files\n"},
    {"Filter", Isolation::container, [](Launch& launch, RunLimits&) { launch.filter.clear(); },
     "student code can reach the network\n"},
    {"Memory", Isolation::container,
     [](Launch& launch, RunLimits& limits) {
       launch.joins.clear();
       limits.resident_bytes = 0;
     },
     "student code can take more memory than it may"}};

class Fences : public testing::TestWithParam<LeftOut> {
 protected:
  void SetUp() override {
    if (const std::string why = why_not(GetParam().kind); !why.empty()) GTEST_SKIP() << why;
  }
  Fences() {
    fs::copy_file(HAIR_PROBE, folder_.path() / "probe");
    fs::permissions(folder_.path() / "probe", fs::perms(0755));
    sandbox_.isolation = GetParam().kind;
    sandbox_.roots = folder_.path() / "roots";
    sandbox_.mounts = runtime_library_mounts();
    sandbox_.mounts.push_back({folder_.path() / "probe", "/probe"});
  }

  StagingFolder folder_;
  Sandbox sandbox_;
};

INSTANTIATE_TEST_SUITE_P(Each, Fences, testing::ValuesIn(kFences), [](const auto& fence) {
  return std::string(to_string(fence.param.kind)) + fence.param.name;
});

TEST_P(Fences, AreNamedWhereTheyAreMissing) {
  EXPECT_EQ(open_fence(sandbox_, GetParam().leave_out), GetParam().named);
}

}  // namespace
}  // namespace grader::sandbox
