// STAFF ONLY. Tests system calls one by one: each call that an attack uses works without the filter, or fails
// for a reason of its own; the filter stops it. A call that leaves the list fails a test here.
#include "grader/sandbox/system_calls/syscalls.h"

#include <errno.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/sched.h>
#include <sched.h>
#include <seccomp.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <termios.h>
#include <ucontext.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <functional>
#include <optional>
#include <ostream>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace grader::inline sandbox {
namespace {

using std::string;

// Describes the result of a call, in a process of its own.
struct Tried {
  int signal = 0;        // ended the process, if not 0
  bool trapped = false;  // it raised SIGSYS
  int error = 0;         // is errno; 0: the call worked

  bool operator==(const Tried&) const = default;
};

std::ostream& operator<<(std::ostream& out, const Tried& tried) {
  if (tried.signal != 0) return out << "ended by signal " << tried.signal;
  if (tried.trapped) return out << "trapped";
  return out << (tried.error == 0 ? "went through" : strerrorname_np(tried.error));
}

constexpr Tried kTrapped{0, true, 0}, kEnded{SIGSYS, false, 0};
constexpr Tried failed(int error) {
  return {0, false, error};
}

volatile sig_atomic_t trapped = 0;
constexpr int kHeardOfATrap = 127;  // no errno is so large, and a worker's filter allows it

void on_trap(int /*signal*/, siginfo_t* /*info*/, void* /*context*/) {
  trapped = 1;
}

// Makes the call in a child, with the filter or without. The child reports by its exit code.
Tried attempt(const std::function<long()>& call, std::optional<Syscalls> filter) {
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("fork");
  if (child == 0) {
    alarm(200);
    struct sigaction action = {};
    action.sa_sigaction = on_trap;
    action.sa_flags = SA_SIGINFO;
    sigaction(SIGSYS, &action, nullptr);
    if (filter) restrict_syscalls(*filter);
    errno = 0;
    const long result = call();
    const int error = result == -1 ? errno : 0;
    _exit(trapped != 0 ? kHeardOfATrap : error);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) return {WTERMSIG(status), false, 0};
  const bool was_trapped = WEXITSTATUS(status) == kHeardOfATrap;
  return {0, was_trapped, was_trapped ? 0 : WEXITSTATUS(status)};
}

// A call has arguments that do nothing, or that the kernel refuses: it changes nothing on the machine even
// without a filter.
struct Call {
  string name;
  std::array<long, 6> arguments = {};

  int number() const { return seccomp_syscall_resolve_name(name.c_str()); }
  long operator()() const {
    const auto& a = arguments;
    return syscall(number(), a[0], a[1], a[2], a[3], a[4], a[5]);
  }
};

// A process that the call started ends at once, and its starter waits for it.
long start(const std::function<long()>& call) {
  const long child = call();
  if (child == 0) _exit(0);
  if (child > 0) waitpid(static_cast<pid_t>(child), nullptr, 0);
  return child;
}

const auto kNowhere = reinterpret_cast<long>("/nowhere/at/all");
constexpr long kBad = -1;  // is a closed descriptor, or unknown flags

// Adds calls with the same arguments.
void add(std::vector<Call>& all, std::initializer_list<const char*> names,
         const std::array<long, 6>& arguments) {
  for (const char* name : names) all.push_back({name, arguments});
}

// These raise SIGSYS under Syscalls::compute, whatever their arguments.
const std::vector<Call>& trapping() {
  static const std::vector<Call> calls = [] {
    std::vector<Call> all = {{"memfd_create", {reinterpret_cast<long>("x"), 0}},
                             {"symlinkat", {kNowhere, kBad, kNowhere}},
                             {"pidfd_open", {0, kBad}},
                             {"prctl", {PR_GET_DUMPABLE}},
                             {"umount2", {kNowhere, kBad}},
                             {"request_key", {0, 0, 0, kBad}},
                             {"kexec_load", {0, 1 << 20, 0, kBad}}};
    add(all, {"socket", "socketpair"}, {AF_UNIX, SOCK_STREAM});
    add(all, {"connect",  "bind",   "listen",      "accept",    "accept4", "sendto",    "sendmsg",
              "recvfrom", "fchmod", "fchown",      "ftruncate", "ptrace",  "setrlimit", "seccomp",
              "setns",    "bpf",    "userfaultfd", "keyctl",    "setuid",  "setgid",    "setgroups"},
        {kBad});
    add(all,
        {"execve", "creat", "unlink", "mkdir", "rmdir", "chmod", "chown", "lchown", "truncate", "mknod",
         "chroot"},
        {kNowhere});
    add(all, {"execveat", "openat2", "unlinkat", "mkdirat", "fchmodat", "fchownat", "mknodat"},
        {kBad, kNowhere});
    add(all, {"rename", "link", "symlink", "pivot_root"}, {kNowhere, kNowhere});
    add(all, {"renameat", "renameat2", "linkat"}, {kBad, kNowhere, kBad, kNowhere});
    add(all, {"process_vm_readv", "process_vm_writev"}, {getppid(), 0, 0, 0, 0, kBad});
    add(all, {"perf_event_open", "add_key"}, {0, 0, 0, 0, kBad});
    add(all, {"pidfd_getfd", "finit_module"}, {kBad, 0, kBad});
    add(all, {"setresuid", "setresgid"}, {kBad, kBad, kBad});
    // To reboot takes a magic number.
    add(all, {"kill", "tkill", "mount", "unshare", "io_uring_setup", "init_module", "reboot", "capset"}, {});
    return all;
  }();
  return calls;
}

void expect_trapped(const string& name, const std::function<long()>& call) {
  SCOPED_TRACE(name);
  EXPECT_EQ(attempt(call, Syscalls::compute), kTrapped);
  const Tried free = attempt(call, {});
  EXPECT_FALSE(free.trapped) << "something else stops it: this test shows nothing";
  EXPECT_EQ(free.signal, 0);
}

TEST(ComputeFilter, TrapsEachCallThatHonestCodeNeverMakes) {
  for (const Call& call : trapping())
    if (call.number() >= 0) expect_trapped(call.name, call);  // this architecture has it
}

// These are denied for some arguments, as listed here.
std::vector<std::pair<string, std::function<long()>>> conditional() {
  constexpr long kThread = CLONE_VM | CLONE_FS | CLONE_FILES | CLONE_SIGHAND | CLONE_THREAD | CLONE_SYSVSEM |
                           CLONE_SETTLS | CLONE_PARENT_SETTID | CLONE_CHILD_CLEARTID;
  const auto raw = [](long number, auto... arguments) {
    return [=] { return syscall(number, arguments...); };
  };
  return {
      {"fork", [] { return start([] { return syscall(SYS_fork); }); }},
      {"vfork",
       [] {
         const pid_t child = vfork();  // NOLINT: this call is under test
         if (child == 0) _exit(0);
         if (child > 0) waitpid(child, nullptr, 0);
         return static_cast<long>(child);
       }},
      {"clone, a process", [] { return start([] { return syscall(SYS_clone, SIGCHLD, 0, 0, 0, 0); }); }},
      // The kernel refuses threads without CLONE_SIGHAND.
      {"clone, CLONE_VFORK", raw(SYS_clone, (kThread | CLONE_VFORK) & ~CLONE_SIGHAND, 0, 0, 0, 0)},
      {"clone, CLONE_UNTRACED", raw(SYS_clone, (kThread | CLONE_UNTRACED) & ~CLONE_SIGHAND, 0, 0, 0, 0)},
      {"clone, a namespace", raw(SYS_clone, CLONE_NEWUSER | CLONE_FS, 0, 0, 0, 0)},
      {"openat, to write", raw(SYS_openat, AT_FDCWD, "/nowhere/at/all", O_WRONLY)},
      {"openat, to read and write", raw(SYS_openat, AT_FDCWD, "/nowhere/at/all", O_RDWR)},
      {"openat, to create", raw(SYS_openat, AT_FDCWD, "/nowhere/at/all", O_RDONLY | O_CREAT, 0600)},
      {"openat, to cut", raw(SYS_openat, AT_FDCWD, "/nowhere/at/all", O_RDONLY | O_TRUNC)},
      {"prlimit64, to set", raw(SYS_prlimit64, 0, RLIM_NLIMITS + 1, "12345678901234567890", 0)},
      {"rt_sigaction, SIGSYS", raw(SYS_rt_sigaction, SIGSYS, 0, 0, 8)},
      {"tgkill, another signal than SIGABRT", raw(SYS_tgkill, 0, 0, SIGSTOP)},
#ifdef SYS_open
      {"open, to write", raw(SYS_open, "/nowhere/at/all", O_WRONLY)},
      {"open, to create", raw(SYS_open, "/nowhere/at/all", O_RDONLY | O_CREAT, 0600)},
#endif
  };
}

TEST(ComputeFilter, TrapsArgumentsThatHonestCodeNeverGives) {
  for (const auto& [name, call] : conditional()) expect_trapped(name, call);
}

// A worker's filter stops these, too: popen makes a pipe first, and signals and some exit codes hide an
// attempt.
TEST(WorkerFilter, TrapsWhatHidesOtherCalls) {
  std::uint64_t mask = 0;
  const auto set = reinterpret_cast<long>(&mask);
  for (const Call& call :
       {Call{"pipe", {kNowhere}}, Call{"pipe2", {kNowhere, kBad}},
        Call{"rt_sigprocmask", {SIG_BLOCK, set, 0, 8}}, Call{"rt_sigprocmask", {SIG_SETMASK, set, 0, 8}}}) {
    SCOPED_TRACE(call.name);
    EXPECT_EQ(attempt(call, Syscalls::worker), kTrapped);
    EXPECT_FALSE(attempt(call, Syscalls::compute).trapped);
    EXPECT_FALSE(attempt(call, {}).trapped);
  }
  for (const Call& call : trapping()) {
    if (call.number() >= 0) {
      EXPECT_EQ(attempt(call, Syscalls::worker), kTrapped) << call.name;
    }
  }
  const Call unblocks{"rt_sigprocmask", {SIG_UNBLOCK, 0, 0, 8}};
  EXPECT_EQ(attempt(unblocks, Syscalls::worker), failed(0));
}

// Calls on no list fail with EPERM under the filter, and not without it: a few for each kind of resource.
TEST(ComputeFilter, RefusesWhatNobodyHasListed) {
  std::array<int, 2> two{};
  std::array<char, 512> room{};
  const auto ends = reinterpret_cast<long>(two.data()), bytes = reinterpret_cast<long>(room.data());
  const auto top = reinterpret_cast<long>("/");
  std::vector<Call> calls = {{"dup", {1}},
                             {"pipe", {ends}},
                             {"select", {-1, 0, 0, 0, 0}},
                             {"timerfd_create", {CLOCK_MONOTONIC, 0}},
                             {"ioctl", {1, FIONREAD, bytes}},
                             {"access", {top, 0}},
                             {"statx", {AT_FDCWD, top, 0, 0, bytes}},
                             {"readlink", {kNowhere, bytes, 8}},
                             {"getdents64", {kBad, bytes, 8}},
                             {"chdir", {top}},
                             {"pwrite64", {kBad, bytes, 1, 0}},
                             {"alarm", {20}},
                             {"personality", {0xffffffff}},
                             {"wait4", {kBad, 0, WNOHANG, 0}},
                             {"semget", {0, -1, 0}},
                             {"mq_open", {kNowhere, 0, 0, 0}}};
  add(calls, {"io_uring_enter", "setpriority", "setpgid", "shmat"}, {kBad});
  add(calls, {"poll", "eventfd2", "setitimer", "sched_setaffinity", "shmget", "mlock"}, {});
  int tried = 0;
  for (const Call& call : calls) {
    SCOPED_TRACE(call.name);
    if (call.number() < 0) continue;
    EXPECT_EQ(attempt(call, Syscalls::compute), failed(EPERM));
    const Tried free = attempt(call, {});
    EXPECT_NE(free, failed(EPERM)) << "something else stops it: this test shows nothing";
    EXPECT_EQ(free.signal, 0);
    ++tried;
  }
  EXPECT_GE(tried, 20);
}

// The C library then falls back to clone, whose flags the filter sees.
TEST(ComputeFilter, KnowsNoClone3) {
  const Call call{"clone3", {0, 0}};
  for (const Syscalls kept : {Syscalls::compute, Syscalls::toolchain})
    EXPECT_EQ(attempt(call, kept), failed(ENOSYS));
  const Tried free = attempt(call, {});
  if (free == failed(ENOSYS)) GTEST_SKIP() << "the filter of a container around us knows none, either";
  EXPECT_EQ(free, failed(EINVAL));
}

#if defined(__x86_64__)
// The kernel's other interfaces have other numbers: the same number would be another call.
TEST(ComputeFilter, EndsAProcessThatKnocksOnAnotherDoor) {
  const auto door_of_32_bits = [] {
    long result = 20;  // is getpid
    asm volatile("int $0x80" : "+a"(result) : : "memory");
    return result < 0 ? 0L : result;
  };
  const auto door_of_x32 = [] { return syscall(0x40000000 + SYS_getpid); };
  // A kernel without this interface ends the process itself.
  const Tried of_32_bits = attempt(door_of_32_bits, {});
  const bool there = of_32_bits.signal != SIGSEGV;
  for (const Syscalls kept : {Syscalls::compute, Syscalls::toolchain}) {
    EXPECT_EQ(attempt(door_of_32_bits, kept), there ? kEnded : of_32_bits);
    EXPECT_EQ(attempt(door_of_x32, kept), kEnded);
  }
  EXPECT_NE(attempt(door_of_x32, {}).signal, SIGSYS);
  EXPECT_NE(of_32_bits.signal, SIGSYS);
}
#endif

// The filter must let honest code run.
TEST(ComputeFilter, LetsHonestCodeRun) {
  const auto honest = []() -> long {
    int sum = 0;
    std::thread([&] { sum = 1; }).join();
    std::vector<double> room(1 << 22, 1);
    const int file = open("/dev/null", O_RDONLY);
    if (file < 0 || close(file) != 0) return -1;
    rlimit limit{};
    if (getrlimit(RLIMIT_CPU, &limit) != 0) return -1;
    signal(SIGFPE, SIG_IGN);
    usleep(1);
    isatty(1);
    errno = EINVAL;
    return sum == 1 && room.back() == 1 ? 0 : -1;
  };
  EXPECT_EQ(attempt(honest, Syscalls::compute), failed(0));
  const auto aborts = []() -> long { std::abort(); };
  EXPECT_EQ(attempt(aborts, Syscalls::compute).signal, SIGABRT);
}

// Compilers start processes and write files. They need nothing else of the machine.
TEST(ToolchainFilter, RefusesWhatACompilerNeverNeeds) {
  const std::set<string> kept = {"execve",    "unlink",   "unlinkat", "rename", "renameat",  "renameat2",
                                 "mkdir",     "mkdirat",  "rmdir",    "chmod",  "fchmod",    "fchmodat",
                                 "ftruncate", "truncate", "creat",    "kill",   "setrlimit", "prctl"};
  int tried = 0;
  for (const Call& call : trapping()) {
    SCOPED_TRACE(call.name);
    if (call.number() < 0) continue;
    const Tried sandboxed = attempt(call, Syscalls::toolchain), free = attempt(call, {});
    if (kept.count(call.name)) {
      EXPECT_EQ(sandboxed, free);
      continue;
    }
    EXPECT_EQ(sandboxed, failed(EPERM));
    ++tried;
  }
  EXPECT_GE(tried, 45);
}

}  // namespace
}  // namespace grader::sandbox
