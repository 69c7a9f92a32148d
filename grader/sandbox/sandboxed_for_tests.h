// STAFF ONLY. A shell in a sandbox, for tests of either kind.
#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "grader/sandbox/isolation_for_tests.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/sandboxed_process.h"
#include "grader/sandbox/system_mounts.h"

namespace grader::inline sandbox {

class Sandboxed {
 protected:
  explicit Sandboxed(Isolation kind) {
    static const StagingFolder all;  // keeps root folders for all tests
    static int number = 0;
    folder_ = all.path() / std::to_string(number++);
    std::filesystem::create_directory(folder_);
    share_with_sandbox(folder_, false);
    std::filesystem::create_directory(folder_ / "empty");
    chmod((folder_ / "empty").c_str(), 0755);
    sandbox_.isolation = kind;
    sandbox_.roots = all.path() / "roots";
    static const std::map<Isolation, std::vector<Mount>> toolchains = {
        {Isolation::namespaces, toolchain_mounts(Isolation::namespaces)},
        {Isolation::container, toolchain_mounts(Isolation::container)}};
    sandbox_.mounts = toolchains.at(kind);
    for (const Mount& mount : header_mounts(kind, folder_ / "empty")) sandbox_.mounts.push_back(mount);
    if (kind == Isolation::container) {
      static const std::vector<Mount> programs = program_mounts(
          {"/usr/bin/bash", "/usr/bin/cat", "/usr/bin/head", "/usr/bin/id", "/usr/bin/ls", "/usr/bin/seq",
           "/usr/bin/setsid", "/usr/bin/sleep", "/usr/bin/tr", "/usr/bin/true", "/usr/bin/unshare"});
      sandbox_.mounts.insert(sandbox_.mounts.end(), programs.begin(), programs.end());
    }
    sandbox_.tmp_bytes = 1 << 20;
    sandbox_.syscalls = Syscalls::toolchain;
    sandbox_.limits.wall_seconds = 200;
    sandbox_.limits.cpu_seconds = 5;
    sandbox_.limits.memory_bytes = std::size_t{256} << 20;
  }

  struct Said {
    Ending ending;
    std::string output;
  };
  Said shell(const std::string& script) {
    Pipe output = make_pipe();
    SandboxedProcess process(sandbox_, with_inner_limits(sandbox_.limits, {"/usr/bin/bash", "-c", script}),
                             -1, -1, output.write_end.get());
    output.write_end.close();
    std::string text = read_all(output.read_end, 1 << 16, sandbox_.limits.wall_seconds);
    return {process.wait(sandbox_.limits.wall_seconds), text};
  }

  std::filesystem::path folder_;
  Sandbox sandbox_;
};

class SandboxTest : public Sandboxed, public testing::TestWithParam<Isolation> {
 protected:
  SandboxTest() : Sandboxed(GetParam()) {}
  void SetUp() override {
    if (const std::string why = why_not(GetParam()); !why.empty()) GTEST_SKIP() << why;
  }
};

class ContainerTest : public Sandboxed, public testing::Test {
 protected:
  ContainerTest() : Sandboxed(Isolation::container) {}
};

// Mounts the program that tries what a sandbox must stop (probe.cpp) as /probe.
inline Mount mount_of_probe(const std::filesystem::path& folder) {
  std::filesystem::copy_file(HAIR_PROBE, folder / "probe");
  std::filesystem::permissions(folder / "probe", std::filesystem::perms(0755));
  return {folder / "probe", "/probe"};
}

inline Sandbox sandbox_of_probe(Isolation kind, const StagingFolder& folder) {
  Sandbox sandbox;
  sandbox.isolation = kind;
  sandbox.roots = folder.path() / "roots";
  sandbox.mounts = runtime_library_mounts();
  sandbox.mounts.push_back(mount_of_probe(folder.path()));
  return sandbox;
}

// Lists all processes below one, without itself, parents first.
inline std::vector<pid_t> descendants(pid_t process) {
  std::vector<pid_t> all;
  const std::string number = std::to_string(process);
  std::ifstream children("/proc/" + number + "/task/" + number + "/children");
  for (pid_t child = 0; children >> child;) {
    all.push_back(child);
    const std::vector<pid_t> below = descendants(child);
    all.insert(all.end(), below.begin(), below.end());
  }
  return all;
}

}  // namespace grader::sandbox
