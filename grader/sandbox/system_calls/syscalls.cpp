// STAFF ONLY. Lists system calls, and lets libseccomp make filters of the lists.
#include "grader/sandbox/system_calls/syscalls.h"

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

namespace grader::inline sandbox {
namespace {

// libseccomp skips names that this architecture lacks.
constexpr const char* kCompute[] = {
    "read", "write", "readv", "writev", "pread64", "lseek", "close", "fstat", "newfstatat", "stat", "lstat",
    "fcntl",
    // memory
    "mmap", "munmap", "mremap", "mprotect", "madvise", "brk", "mincore",
    // signals and threads
    "rt_sigprocmask", "rt_sigreturn", "sigaltstack", "futex", "sched_yield", "sched_getaffinity",
    "set_robust_list", "rseq", "set_tid_address", "arch_prctl", "exit", "exit_group", "restart_syscall",
    "membarrier", "getcpu",
    // time and identity
    "clock_gettime", "clock_getres", "gettimeofday", "time", "nanosleep", "clock_nanosleep", "getrandom",
    "getpid", "gettid", "getppid", "getuid", "geteuid", "getgid", "getegid", "getcwd", "uname", "sysinfo",
    "getrlimit", "getrusage", "times"};

constexpr const char* kToolchain[] = {
    "open", "openat", "creat", "access", "faccessat", "faccessat2", "readlink", "readlinkat", "statx",
    "statfs", "fstatfs", "getdents64", "unlink", "unlinkat", "rename", "renameat", "renameat2", "mkdir",
    "mkdirat", "rmdir", "ftruncate", "truncate", "chmod", "fchmod", "fchmodat", "umask", "chdir", "fchdir",
    "dup", "dup2", "dup3", "pipe", "pipe2", "poll", "ppoll", "select", "pselect6", "pwrite64", "fallocate",
    "fadvise64", "copy_file_range", "sendfile", "flock",
    // processes
    "fork", "vfork", "clone", "tgkill", "execve", "wait4", "waitid", "kill", "setpgid", "getpgrp", "getpgid",
    "getsid", "prlimit64", "setrlimit", "rt_sigaction", "rt_sigpending", "rt_sigtimedwait", "rt_sigsuspend",
    "pause", "alarm", "setitimer", "prctl", "getgroups", "getresuid", "getresgid", "getpriority", "ioctl",
    "close_range", "eventfd2"};

struct Denied {
  const char* what;
  std::initializer_list<const char*> names;
};

const std::initializer_list<Denied> kDenied = {
    {"to open a network connection",
     {"socket", "socketpair", "connect", "bind", "listen", "accept", "accept4", "sendto", "sendmsg",
      "recvfrom"}},
    // popen makes its pipe first.
    {"to start another process", {"fork", "vfork", "clone", "execve", "execveat", "pipe", "pipe2"}},
    {"to change or create a file",
     {"open",     "openat",    "openat2",  "creat",     "unlink",   "unlinkat", "rename",
      "renameat", "renameat2", "mkdir",    "mkdirat",   "rmdir",    "link",     "linkat",
      "symlink",  "symlinkat", "chmod",    "fchmod",    "fchmodat", "chown",    "fchown",
      "lchown",   "fchownat",  "truncate", "ftruncate", "mknod",    "mknodat",  "memfd_create"}},
    {"to look into or stop another process",
     {"ptrace", "process_vm_readv", "process_vm_writev", "kill", "tkill", "tgkill", "pidfd_open",
      "pidfd_getfd"}},
    {"to change the limits that it runs under",
     {"setrlimit", "prlimit64", "prctl", "seccomp", "rt_sigaction"}},
    {"to change the machine",
     {"mount",       "umount2",         "pivot_root",   "chroot",         "unshare", "setns",
      "bpf",         "perf_event_open", "userfaultfd",  "io_uring_setup", "keyctl",  "add_key",
      "request_key", "init_module",     "finit_module", "kexec_load",     "reboot",  "setuid",
      "setgid",      "setresuid",       "setresgid",    "setgroups",      "capset"}}};

// These are denied for some arguments only, or to workers only.
constexpr const char* kConditional[] = {"openat",       "open",   "clone", "prlimit64",
                                        "rt_sigaction", "tgkill", "pipe",  "pipe2"};

// Syscalls::worker stops these of them.
constexpr const char* kHeard[] = {"rt_sigprocmask", "exit", "exit_group"};

bool is_one_of(std::span<const char* const> names, const char* name) {
  return std::ranges::any_of(names, [&](const char* one) { return std::strcmp(name, one) == 0; });
}

// The C library starts a thread with these flags. Others may do more: with CLONE_VFORK the starter waits in a
// state that looks like work.
constexpr std::uint64_t kThread = CLONE_VM | CLONE_FS | CLONE_FILES | CLONE_SIGHAND | CLONE_THREAD |
                                  CLONE_SYSVSEM | CLONE_SETTLS | CLONE_PARENT_SETTID | CLONE_CHILD_CLEARTID;

using Filter = std::unique_ptr<void, decltype(&seccomp_release)>;

void add(const Filter& filter, std::uint32_t action, const char* name,
         std::initializer_list<scmp_arg_cmp> conditions = {}) {
  const int number = seccomp_syscall_resolve_name(name);
  if (number == __NR_SCMP_ERROR || number < 0) return;  // this architecture lacks it
  const int error = seccomp_rule_add_array(filter.get(), action, number,
                                           static_cast<unsigned>(conditions.size()), conditions.begin());
  if (error != 0)
    throw std::runtime_error(std::string("seccomp: no rule for ") + name + ": " + std::strerror(-error));
}

scmp_arg_cmp bits_are(unsigned argument, std::uint64_t mask, std::uint64_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

void add_compute_rules(const Filter& filter) {
  // The loader needs to read files. Nothing may be written.
  const int flags_of_openat = 2, flags_of_open = 1;
  for (auto [name, flags] : {std::pair{"openat", flags_of_openat}, std::pair{"open", flags_of_open}}) {
    add(filter, SCMP_ACT_ALLOW, name, {bits_are(flags, O_ACCMODE | O_CREAT | O_TRUNC, O_RDONLY)});
    for (int bit : {O_WRONLY, O_RDWR, O_CREAT, O_TRUNC})
      add(filter, SCMP_ACT_TRAP, name, {bits_are(flags, bit, bit)});
  }
  add(filter, SCMP_ACT_ALLOW, "clone", {{0, SCMP_CMP_EQ, kThread, 0}});
  add(filter, SCMP_ACT_TRAP, "clone", {{0, SCMP_CMP_NE, kThread, 0}});
  add(filter, SCMP_ACT_ALLOW, "prlimit64", {{2, SCMP_CMP_EQ, 0, 0}});  // reading limits is harmless
  add(filter, SCMP_ACT_TRAP, "prlimit64", {{2, SCMP_CMP_NE, 0, 0}});
  add(filter, SCMP_ACT_ALLOW, "rt_sigaction", {{0, SCMP_CMP_NE, SIGSYS, 0}});
  add(filter, SCMP_ACT_TRAP, "rt_sigaction", {{0, SCMP_CMP_EQ, SIGSYS, 0}});
  add(filter, SCMP_ACT_ALLOW, "tgkill", {{2, SCMP_CMP_EQ, SIGABRT, 0}});  // abort needs it
  add(filter, SCMP_ACT_TRAP, "tgkill", {{2, SCMP_CMP_NE, SIGABRT, 0}});
  add(filter, SCMP_ACT_ALLOW, "ioctl", {{1, SCMP_CMP_EQ, TCGETS, 0}});  // printf calls isatty
  for (const Denied& denied : kDenied)
    for (const char* name : denied.names)
      if (!is_one_of(kConditional, name)) add(filter, SCMP_ACT_TRAP, name);
}

void add_worker_rules(const Filter& filter) {
  for (const char* name : {"pipe", "pipe2"}) add(filter, SCMP_ACT_TRAP, name);
  add(filter, SCMP_ACT_ALLOW, "rt_sigprocmask", {{0, SCMP_CMP_EQ, SIG_UNBLOCK, 0}});
  add(filter, SCMP_ACT_TRAP, "rt_sigprocmask", {{0, SCMP_CMP_NE, SIG_UNBLOCK, 0}});
  constexpr std::uint64_t kAbove127 = 0x80;
  for (const char* name : {"exit", "exit_group"}) {
    add(filter, SCMP_ACT_ALLOW, name, {bits_are(0, kAbove127, 0)});
    add(filter, SCMP_ACT_TRAP, name, {bits_are(0, kAbove127, kAbove127)});
  }
}

Filter make_filter(Syscalls kept) {
  Filter filter(seccomp_init(SCMP_ACT_ERRNO(EPERM)), seccomp_release);
  if (!filter) throw std::runtime_error("seccomp: no memory for a filter");
  // A call with another architecture's number (int 0x80, x32) ends the process, not the calling thread alone.
  seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
  for (const char* name : kCompute)
    if (kept != Syscalls::worker || !is_one_of(kHeard, name)) add(filter, SCMP_ACT_ALLOW, name);
  add(filter, SCMP_ACT_ERRNO(ENOSYS), "clone3");
  if (kept == Syscalls::toolchain) {
    for (const char* name : kToolchain) add(filter, SCMP_ACT_ALLOW, name);
  } else {
    add_compute_rules(filter);
    if (kept == Syscalls::worker) add_worker_rules(filter);
  }
  return filter;
}

void (*tell_denied)(int) = nullptr;
void (*tell_leaves)(int) = nullptr;

using Mask = std::uint64_t;  // has the kernel's size

#if defined(__x86_64__)
long argument(const mcontext_t& registers, int i) {
  constexpr int kPlaces[] = {REG_RDI, REG_RSI, REG_RDX};
  return static_cast<long>(registers.gregs[kPlaces[i]]);
}
void set_result(mcontext_t& registers, long result) {
  registers.gregs[REG_RAX] = result;
}
#elif defined(__aarch64__)
long argument(const mcontext_t& registers, int i) {
  return static_cast<long>(registers.regs[i]);
}
void set_result(mcontext_t& registers, long result) {
  registers.regs[0] = static_cast<unsigned long long>(result);
}
#else
#error "the registers that hold a system call's arguments and its result are not known here"
#endif

// Does rt_sigprocmask(how, set, old): the mask after the handler's return is the requested one, without
// SIGSYS.
long change_mask(ucontext_t& context) {
  Mask mask = 0, set = 0;
  std::memcpy(&mask, &context.uc_sigmask, sizeof mask);
  const Mask before = mask;
  const auto address = [&](int i) {
    return reinterpret_cast<void*>(argument(context.uc_mcontext, i));  // NOLINT(performance-no-int-to-ptr)
  };
  if (address(1) != nullptr) {
    std::memcpy(&set, address(1), sizeof set);
    switch (argument(context.uc_mcontext, 0)) {
      case SIG_BLOCK:
        mask |= set;
        break;
      case SIG_UNBLOCK:
        mask &= ~set;
        break;
      case SIG_SETMASK:
        mask = set;
        break;
      default:
        return -EINVAL;
    }
    mask &= ~(Mask{1} << (SIGSYS - 1));
    std::memcpy(&context.uc_sigmask, &mask, sizeof mask);
  }
  if (address(2) != nullptr) std::memcpy(address(2), &before, sizeof before);
  return 0;
}

void on_stopped(int /*signal*/, siginfo_t* info, void* data) {
  auto& context = *static_cast<ucontext_t*>(data);
  long result = -EPERM;
  switch (info->si_syscall) {
    case SYS_rt_sigprocmask:
      result = change_mask(context);
      break;
    case SYS_exit:
    case SYS_exit_group:
      tell_leaves(static_cast<int>(argument(context.uc_mcontext, 0) & 0xff));
      _exit(1);
    default:
      tell_denied(info->si_syscall);
  }
  set_result(context.uc_mcontext, result);
}

}  // namespace

void restrict_syscalls(Syscalls kept) {
  const Filter filter = make_filter(kept);
  const int error = seccomp_load(filter.get());
  if (error != 0)
    throw std::runtime_error(std::string("seccomp: can't load the filter: ") + std::strerror(-error));
}

int syscall_filter_descriptor(Syscalls kept) {
  const Filter filter = make_filter(kept);
  const int file = memfd_create("syscall filter", MFD_CLOEXEC);
  if (file < 0) throw std::runtime_error(std::string("memfd_create: ") + std::strerror(errno));
  const int error = seccomp_export_bpf(filter.get(), file);
  if (error != 0 || lseek(file, 0, SEEK_SET) != 0) {
    close(file);
    throw std::runtime_error(std::string("seccomp: can't write the filter: ") + std::strerror(-error));
  }
  return file;
}

std::vector<sock_filter> syscall_filter(Syscalls kept) {
  const int file = syscall_filter_descriptor(kept);
  std::vector<sock_filter> filter(static_cast<std::size_t>(lseek(file, 0, SEEK_END)) / sizeof(sock_filter));
  const std::size_t bytes = filter.size() * sizeof(sock_filter);
  const bool whole = pread(file, filter.data(), bytes, 0) == static_cast<ssize_t>(bytes);
  close(file);
  if (!whole) throw std::runtime_error("seccomp: can't read the filter");
  return filter;
}

const char* denied_syscall(int number) {
  for (const Denied& denied : kDenied)
    for (const char* name : denied.names)
      if (seccomp_syscall_resolve_name(name) == number) return denied.what;
  return "something that is not allowed";
}

void hear_of_stopped_calls(void (*denied)(int number), void (*leaves)(int code)) {
  tell_denied = denied;
  tell_leaves = leaves;
  struct sigaction action = {};
  action.sa_sigaction = on_stopped;
  action.sa_flags = SA_SIGINFO | SA_NODEFER;
  sigaction(SIGSYS, &action, nullptr);
}

}  // namespace grader::sandbox
