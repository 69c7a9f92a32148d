// STAFF ONLY. Sets what a process inherits, and tests that hard limits leave enough.
#include "grader/sandbox/inherited.h"

#include <signal.h>
#include <sys/personality.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "grader/sandbox/sandbox.h"
#include "hair/io/files/finish_output.h"

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;

constexpr rlim_t kStack = 8 << 20;
constexpr int kMostJobs = 256;

// A hairgrade has three pipes and a few open files for each submission in work.
constexpr rlim_t descriptors(int jobs) {
  return 256 + 16 * static_cast<rlim_t>(jobs);
}

struct SoftLimit {
  __rlimit_resource resource;
  rlim_t value;
};
constexpr SoftLimit kSoftLimits[] = {{RLIMIT_AS, RLIM_INFINITY},
                                     {RLIMIT_DATA, RLIM_INFINITY},
                                     {RLIMIT_RSS, RLIM_INFINITY},
                                     {RLIMIT_STACK, kStack},
                                     {RLIMIT_CPU, RLIM_INFINITY},
                                     {RLIMIT_RTTIME, RLIM_INFINITY},
                                     {RLIMIT_FSIZE, RLIM_INFINITY},
                                     {RLIMIT_NPROC, RLIM_INFINITY},
                                     {RLIMIT_SIGPENDING, RLIM_INFINITY},
                                     {RLIMIT_MEMLOCK, RLIM_INFINITY},
                                     {RLIMIT_LOCKS, RLIM_INFINITY},
                                     {RLIMIT_MSGQUEUE, RLIM_INFINITY},
                                     {RLIMIT_CORE, 0},
                                     {RLIMIT_NOFILE, descriptors(kMostJobs)}};

// Raises soft limits as far as the hard ones. True if a process that starts now gets another stack.
bool set_limits() {
  bool other_stack = false;
  for (const auto& [resource, wanted] : kSoftLimits) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0) continue;
    const rlim_t before = limit.rlim_cur;
    const rlimit raised{wanted, std::max(wanted, limit.rlim_max)};
    if (setrlimit(resource, &raised) != 0) {
      limit.rlim_cur = std::min(wanted, limit.rlim_max);
      setrlimit(resource, &limit);
    }
    getrlimit(resource, &limit);
    other_stack |= resource == RLIMIT_STACK && limit.rlim_cur != before;
  }
  return other_stack;
}

// True if sandboxes see this folder's files and programs may run there.
bool serves_for_temporary_files(const fs::path& folder) {
  struct statvfs system = {};
  if (!folder.is_absolute() || access(folder.c_str(), W_OK | X_OK) != 0 ||
      statvfs(folder.c_str(), &system) != 0 || (system.f_flag & ST_NOEXEC) != 0)
    return false;
  // Root has another user in a sandbox.
  std::error_code error;
  for (fs::path part = folder; geteuid() == 0; part = part.parent_path()) {
    if ((fs::status(part, error).permissions() & fs::perms::others_exec) == fs::perms::none) return false;
    if (part == part.parent_path()) break;
  }
  return fs::is_directory(folder, error);
}

bool is_kept(std::string_view variable) {
  constexpr std::string_view kKept[] = {"HOME",         "XDG_CACHE_HOME", "XDG_CONFIG_HOME",
                                        "ASAN_OPTIONS", "LSAN_OPTIONS",   "UBSAN_OPTIONS"};
  const std::string_view name = variable.substr(0, variable.find('='));
  if (name == "TMPDIR") return serves_for_temporary_files(variable.substr(name.size() + 1));
  return std::ranges::find(kKept, name) != std::end(kKept);
}

std::vector<char*> kept_environment() {
  std::vector<char*> kept;
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (is_kept(*variable)) kept.push_back(*variable);
  return kept;
}

void set_signals() {
  for (int number = 1; number < NSIG; ++number)
    if (number != SIGHUP && is_ignored(number)) signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

// Returns true if a process that starts now gets another personality. Where the question is denied, the
// personality can't be changed either.
bool set_personality() {
  constexpr unsigned long kAsk = 0xffffffff;
  return personality(kAsk) > 0 && personality(PER_LINUX) >= 0;
}

// hairsuite needs this with OpenGL; a compiler has 2 GiB in its sandbox.
constexpr rlim_t kAddresses = rlim_t{4} << 30;
// A precompiled header is the largest file.
constexpr rlim_t kFile = rlim_t{512} << 20;

struct HardLimit {
  __rlimit_resource resource;
  const char* what;
  char option;  // names it in the shell's ulimit
  rlim_t unit;
  rlim_t needed;
};

}  // namespace

bool is_ignored(int signal) {
  struct sigaction action = {};
  return sigaction(signal, nullptr, &action) == 0 && (action.sa_flags & SA_SIGINFO) == 0 &&
         action.sa_handler == SIG_IGN;
}

void set_what_is_inherited(char* argv[]) {
  hair::begin_output();
  set_signals();
  umask(umask(0) & 077);
  const bool other_stack = set_limits(), other_personality = set_personality();
  std::vector<char*> environment = kept_environment();
  environment.push_back(nullptr);
  const bool other_environment = environ[environment.size() - 1] != nullptr;
  if (!other_stack && !other_personality && !other_environment) return;
  execve("/proc/self/exe", argv, environment.data());
  std::cerr << argv[0] << ": /proc/self/exe can't be started: " << std::strerror(errno) << "\n";
  _exit(1);
}

void require_hard_limits(const Needs& needs) {
  const auto processes = static_cast<rlim_t>(needs.jobs * (Limits().processes + 4));
  const HardLimit limits[] = {
      {RLIMIT_AS, "the address space", 'v', 1024, kAddresses},
      {RLIMIT_DATA, "a process's data", 'd', 1024, kAddresses},
      {RLIMIT_STACK, "the stack", 's', 1024, kStack},
      {RLIMIT_FSIZE, "a file's size", 'f', 1024, kFile},
      {RLIMIT_CPU, "CPU time, in seconds,", 't', 1, static_cast<rlim_t>(needs.cpu_seconds)},
      {RLIMIT_NOFILE, "open files", 'n', 1, descriptors(needs.jobs)},
      {RLIMIT_NPROC, "a user's processes", 'u', 1, processes}};
  for (const HardLimit& limit : limits) {
    rlimit now{};
    if (getrlimit(limit.resource, &now) != 0 || now.rlim_max >= limit.needed) continue;
    const std::string unit = limit.unit == 1 ? "" : " kB";
    throw std::runtime_error("the hard limit on " + std::string(limit.what) + " is " +
                             std::to_string(now.rlim_max / limit.unit) + unit + ", and grading needs " +
                             std::to_string(limit.needed / limit.unit) + unit + "; start it where ulimit -H" +
                             limit.option + " says so, or unlimited");
  }
}

}  // namespace grader::sandbox
