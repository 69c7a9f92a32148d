// STAFF ONLY. Starts, counts and ends a run. It runs in a process that is forked from one with threads:
// until its end it makes system calls only, and allocates nothing.
#include "grader/sandbox/processes/supervisor.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <linux/seccomp.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <system_error>

namespace grader::inline sandbox {
namespace {

constexpr int kNotReady = 126, kNotFound = 127;  // shells use these exit codes

// Lets the kernel end this process before ours when memory runs out. Any user may do this.
void volunteer() {
  const int file = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (file >= 0) (void)!write(file, "1000", 4);
}

}  // namespace

void Launch::exec() const {
  for (int group : joins)
    if (write(group, "0", 1) != 1) _exit(kNotReady);
  int sources[] = {output, output, requests, replies, info, filter_file};
  const int targets[] = {1, 2, kRequests, kReplies, kInfo, kFilter};
  for (int& source : sources)
    if (source >= 0 && (source = fcntl(source, F_DUPFD_CLOEXEC, 32)) < 0)
      _exit(kNotReady);  // moves it above the targets' numbers
  if (syscall(SYS_close_range, 3, ~0U, 4U /* CLOSE_RANGE_CLOEXEC */) != 0) _exit(kNotReady);
  for (int i = 0; i < 6; ++i)
    if (sources[i] >= 0 && dup2(sources[i], targets[i]) < 0) _exit(kNotReady);
  const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (dup2(nothing, 0) < 0) _exit(kNotReady);
  if (output < 0 && (dup2(nothing, 1) < 0 || dup2(nothing, 2) < 0)) _exit(kNotReady);
  if (own_session) {
    setsid();
    volunteer();
  }
  if (root != nullptr && chroot(root) != 0) _exit(kNotReady);
  if (!become(identity)) _exit(kNotReady);
  if (folder != nullptr && chdir(folder) != 0) _exit(kNotReady);
  if (!filter.empty()) {
    const sock_fprog program{static_cast<unsigned short>(filter.size()),
                             const_cast<sock_filter*>(filter.data())};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
        syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, 0, &program) != 0)
      _exit(kNotReady);
  }
  execve(argv[0], argv.data(), environment.data());
  for (const char* text : {static_cast<const char*>(argv[0]), " can't be started\n"})
    (void)!write(STDERR_FILENO, text, std::strlen(text));
  _exit(kNotFound);
}

namespace {

struct Taken {
  double cpu_seconds = 0;
  std::size_t resident_bytes = 0;
};

using Text = std::array<char, 1024>;

// Reads the beginning of a file in /proc/PROCESS; empty if there is none.
const char* read_of(pid_t process, const char* name, Text& text) {
  std::snprintf(text.data(), text.size(), "/proc/%d/%s", process, name);
  const int file = open(text.data(), O_RDONLY | O_CLOEXEC);
  const ssize_t size = file < 0 ? 0 : read(file, text.data(), text.size() - 1);
  if (file >= 0) close(file);
  text[static_cast<std::size_t>(size < 0 ? 0 : size)] = '\0';
  return text.data();
}

const char* after_last(const char* text, char letter) {
  const char* found = nullptr;
  for (; *text != '\0'; ++text)
    if (*text == letter) found = text + 1;
  return found;
}

// Visits the children of a process's first thread.
template <class Do>
void for_each_child(pid_t process, const Do& act) {
  std::array<char, 32> name;
  std::snprintf(name.data(), name.size(), "task/%d/children", process);
  Text text;
  char* rest = nullptr;
  for (const char* child = read_of(process, name.data(), text);; child = rest) {
    const long number = std::strtol(child, &rest, 10);
    if (rest == child) break;
    act(static_cast<pid_t>(number));
  }
}

// Adds the CPU time and memory of a process and all below it, also of those that have ended.
void add_taken(pid_t process, int deepest, Taken& sum) {
  Text text;
  // The line is "PROCESS (NAME) STATE ...", and a name may hold parentheses.
  const char* fields = after_last(read_of(process, "stat", text), ')');
  if (fields == nullptr) return;
  constexpr int kCpu = 14, kCpuEnd = 18, kResident = 24;  // are numbers of fields, see proc(5)
  static const double kTick = 1.0 / static_cast<double>(sysconf(_SC_CLK_TCK));
  static const auto kPage = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  for (int field = 3; *fields != '\0'; ++field) {
    while (*fields == ' ') ++fields;
    const long value = std::strtol(fields, nullptr, 10);
    if (field >= kCpu && field < kCpuEnd) sum.cpu_seconds += kTick * static_cast<double>(value);
    if (field == kResident && value > 0) sum.resident_bytes += kPage * static_cast<std::size_t>(value);
    while (*fields != ' ' && *fields != '\0') ++fields;
  }
  if (deepest > 0) for_each_child(process, [&](pid_t child) { add_taken(child, deepest - 1, sum); });
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Ends all processes of a user from a child with the same effective user. Its real user is another, so that
// they can't end it.
void end_all_of(uid_t user) {
  const pid_t ender = fork();
  if (ender == 0) {
    const uid_t another = user ^ 1U;
    if (setresuid(another, user, another) == 0) kill(-1, SIGKILL);
    _exit(0);
  }
  while (ender > 0 && waitpid(ender, nullptr, 0) < 0 && errno == EINTR) {
  }
}

// Ends all children, also those that this process has adopted.
void end_children() {
  for_each_child(getpid(), [](pid_t child) { kill(child, SIGKILL); });
}

// Ends all that is left of a run, and waits for it.
void take_leave_of_all(uid_t user) {
  do user != 0 ? end_all_of(user) : end_children();
  while (waitpid(-1, nullptr, 0) > 0 || errno == EINTR);
}

struct Watch {
  int control, report;
  RunLimits limits;

  [[noreturn]] void over(const Launch& launch) const {
    setsid();  // a terminal's signals are for the grader
    prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0);
    const pid_t run = fork();
    if (run == 0) launch.exec();
    (void)!write(report, &run, sizeof run);
    if (run < 0) _exit(1);
    keep_only_ours();
    RunReport found = wait_for(run);
    take_leave_of_all(limits.user);
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    // A killed namespace may lose the times of its last processes: the times seen before count.
    found.cpu_seconds = std::max(found.cpu_seconds, seconds_of(used.ru_utime) + seconds_of(used.ru_stime));
    (void)!write(kReport, &found, sizeof found);
    _exit(0);
  }

 private:
  enum : int { kControl = 3, kReport = 4 };

  // Pipes of this and other runs would stay open while this process held them.
  void keep_only_ours() const {
    const int one = fcntl(control, F_DUPFD_CLOEXEC, 16), other = fcntl(report, F_DUPFD_CLOEXEC, 16);
    dup2(one, kControl);
    dup2(other, kReport);
    syscall(SYS_close_range, kReport + 1, ~0U, 0U);
    for (int standard = 0; standard < 3; ++standard) close(standard);
  }

  bool over_a_limit(pid_t run, RunReport& found) const {
    constexpr int kDeepest = 16;
    Taken taken;
    add_taken(run, kDeepest, taken);
    found.cpu_seconds = std::max(found.cpu_seconds, taken.cpu_seconds);
    found.over_cpu |= limits.cpu_seconds > 0 && taken.cpu_seconds > limits.cpu_seconds;
    found.over_memory |= limits.resident_bytes > 0 && taken.resident_bytes > limits.resident_bytes;
    return found.over_cpu || found.over_memory;
  }

  RunReport wait_for(pid_t run) const {
    // Memory fills at a gigabyte a second, or faster.
    const int patience = limits.resident_bytes > 0 ? 10 : limits.cpu_seconds > 0 ? 50 : -1;
    RunReport found;
    pollfd wanted[] = {{static_cast<int>(syscall(SYS_pidfd_open, run, 0)), POLLIN, 0}, {kControl, POLLIN, 0}};
    while ((wanted[0].revents | wanted[1].revents) == 0)
      if (poll(wanted, 2, patience) == 0 && over_a_limit(run, found)) break;
    if (wanted[0].revents == 0) kill(run, SIGKILL);
    while (waitpid(run, &found.status, 0) < 0 && errno == EINTR) {
    }
    return found;
  }
};

}  // namespace

Supervisor::Supervisor(const Launch& launch, const RunLimits& limits) : user_(limits.user) {
  Pipe control = make_pipe(), report = make_pipe();
  supervisor_ = fork();
  if (supervisor_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (supervisor_ == 0) {
    control.write_end.close();
    Watch{control.read_end.get(), report.write_end.get(), limits}.over(launch);
  }
  control_ = std::move(control.write_end);
  report_ = std::move(report.read_end);
  report.write_end.close();
  if (read(report_.get(), &process_, sizeof process_) != sizeof process_ || process_ < 0) {
    wait();
    throw std::system_error(EAGAIN, std::generic_category(), "fork");
  }
}

Supervisor::~Supervisor() {
  end();
  wait();
}

RunReport Supervisor::wait() {
  if (told_) return *told_;
  RunReport& told = told_.emplace();
  ssize_t size;
  do size = read(report_.get(), &told, sizeof told);
  while (size < 0 && errno == EINTR);
  if (size != sizeof told) {  // the supervisor was killed
    told.status = SIGKILL;
    if (user_ != 0) end_all_of(user_);
  }
  while (waitpid(supervisor_, nullptr, 0) < 0 && errno == EINTR) {
  }
  return told;
}

}  // namespace grader::sandbox
