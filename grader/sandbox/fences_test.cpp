// STAFF ONLY. Leaves out each layer once: then the attempt that it stops succeeds, and is reported.
#include "grader/sandbox/fences.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "grader/sandbox/processes/supervisor.h"
#include "grader/sandbox/sandboxed_for_tests.h"

namespace grader::inline sandbox {
namespace {

using LeaveOut = SandboxedProcess::LeaveOut;

// Removes words of bwrap's command.
LeaveOut without(std::string_view first, int count = 1) {
  return [=](Launch& launch, RunLimits&) {
    const auto at =
        std::ranges::find_if(launch.argv, [&](const char* word) { return word != nullptr && word == first; });
    ASSERT_NE(at, launch.argv.end()) << first;
    launch.argv.erase(at, at + count);
  };
}

LeaveOut with(const std::vector<const char*>& words) {
  return [=](Launch& launch, RunLimits&) {
    const auto end = std::ranges::find_if(launch.argv, [](const char* word) {
      return word != nullptr && std::string_view(word) == "--remount-ro";
    });
    std::vector<char*> added;
    for (const char* word : words) added.push_back(const_cast<char*>(word));
    launch.argv.insert(end, added.begin(), added.end());
  };
}

void identity(Launch& launch, RunLimits& /*limits*/) {
  launch.identity = {};
}

// A grader that is not root has the same user as its sandboxes.
void identity_and_processes(Launch& launch, RunLimits& limits) {
  identity(launch, limits);
  without("--unshare-pid")(launch, limits);
}

void filter(Launch& launch, RunLimits& limits) {
  launch.filter.clear();
  if (launch.filter_file >= 0) without("--seccomp", 2)(launch, limits);
}

// Moves the probe to its place outside.
void root(Launch& launch, RunLimits& /*limits*/) {
  static std::string probe = HAIR_PROBE;
  launch.root = nullptr;
  launch.argv.front() = probe.data();
}

void memory(Launch& launch, RunLimits& limits) {
  launch.joins.clear();
  limits.resident_bytes = 0;
}

struct LeftOut {
  const char* name;
  Isolation kind;
  LeaveOut leave_out;
  std::string named;
};

using enum Isolation;
const LeftOut kFences[] = {
    {"Nothing", namespaces, {}, ""},
    {"User", namespaces, identity, "student code can do all that root may: it is root\n"},
    {"Processes", namespaces, identity_and_processes, "student code can signal the staff's processes\n"},
    {"NoNamespacesInside", namespaces, without("--disable-userns"), "student code can make namespaces\n"},
    {"Etc", namespaces, with({"--ro-bind", "/etc", "/etc"}), "student code can read the system's files\n"},
    {"Proc", namespaces, with({"--proc", "/proc"}), "student code can read /proc\n"},
    {"ReadOnly", namespaces, without("--remount-ro", 2), "student code can write to /\n"},
    {"Filter", namespaces, filter, "student code can reach the network\n"},
    {"Network", namespaces, without("--unshare-net"), "student code can reach servers of this machine\n"},
    {"Nothing", container, {}, ""},
    {"User", container, identity, "student code can signal the staff's processes\n"},
    {"Root", container, root, "student code can read the system's files\n"},
    {"Filter", container, filter, "student code can reach the network\n"},
    {"Memory", container, memory, "student code can take more memory than it may"}};

class Fences : public testing::TestWithParam<LeftOut> {
 protected:
  void SetUp() override {
    if (const std::string why = why_not(GetParam().kind); !why.empty()) GTEST_SKIP() << why;
  }

  StagingFolder folder_;
  Sandbox sandbox_ = sandbox_of_probe(GetParam().kind, folder_);
};

INSTANTIATE_TEST_SUITE_P(Each, Fences, testing::ValuesIn(kFences), [](const auto& fence) {
  return std::string(to_string(fence.param.kind)) + fence.param.name;
});

TEST_P(Fences, AreNamedWhereTheyAreMissing) {
  EXPECT_EQ(open_fence(sandbox_, GetParam().leave_out), GetParam().named);
}

}  // namespace
}  // namespace grader::sandbox
