// STAFF ONLY. Starts bubblewrap around a command, and reads from the kernel what the command does.
#include "grader/sandbox/cage.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "grader/sandbox/identity.h"

namespace grader {
namespace {

enum : int { kRequests = 3, kReplies = 4, kInfo = 5, kFilter = 6 };

// A word of a command with the path in it that some mount puts there replaced by the path out here; the
// longest such path counts.
std::string outside(const Cage& cage, const std::string& word) {
  const Mount* found = nullptr;
  std::size_t place = std::string::npos;
  for (const Mount& mount : cage.mounts) {
    const std::size_t at = word.find(mount.target);
    const std::size_t end = at + mount.target.size();
    if (at == std::string::npos || (end != word.size() && word[end] != '/')) continue;
    if (found != nullptr && found->target.size() >= mount.target.size()) continue;
    found = &mount;
    place = at;
  }
  if (found == nullptr) return word;
  return word.substr(0, place) + found->source.string() + word.substr(place + found->target.size());
}

std::vector<std::string> bwrap_command(const Cage& cage, const std::vector<std::string>& command,
                                       bool filtered) {
  std::vector<std::string> all = {"/usr/bin/bwrap",
                                  "--unshare-user",
                                  "--unshare-pid",
                                  "--unshare-net",
                                  "--unshare-ipc",
                                  "--unshare-uts",
                                  "--unshare-cgroup-try",
                                  "--disable-userns",
                                  "--die-with-parent",
                                  "--new-session",
                                  "--clearenv",
                                  "--hostname",
                                  "cage",
                                  "--info-fd",
                                  std::to_string(kInfo)};
  auto append = [&all](std::initializer_list<std::string> words) { all.insert(all.end(), words); };
  if (filtered) append({"--seccomp", std::to_string(kFilter)});
  if (cage.tmp_bytes > 0)
    append({"--size", std::to_string(cage.tmp_bytes), "--tmpfs", "/tmp", "--dev-bind", "/dev/null",
            "/dev/null"});
  for (const Mount& mount : cage.mounts) {
    std::error_code error;
    if (std::filesystem::is_symlink(mount.source, error) && mount.source == mount.target)
      append({"--symlink", std::filesystem::read_symlink(mount.source).string(), mount.target});
    else
      append({mount.writable ? "--bind" : "--ro-bind", mount.source.string(), mount.target});
  }
  // The same bytes whenever it is compiled: __DATE__ and __TIME__ are those of this second.
  append({"--setenv", "PATH", "/usr/bin", "--setenv", "LC_ALL", "C", "--setenv", "SOURCE_DATE_EPOCH", "1"});
  if (cage.as_first_process) append({"--as-pid-1"});
  append({"--remount-ro", "/", "--chdir", cage.folder, "--"});
  all.insert(all.end(), command.begin(), command.end());
  return all;
}

std::vector<char*> as_argv(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  return argv;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Of each thread of a process: what it has computed and waited for a processor, the first two numbers of
// its `schedstat`, in nanoseconds.
void add_busy(pid_t process, std::map<pid_t, CagedProcess::Activity::Busy>& busy) {
  std::error_code error;
  const std::filesystem::path tasks = "/proc/" + std::to_string(process) + "/task";
  for (std::filesystem::directory_iterator task(tasks, error), end; !error && task != end;
       task.increment(error)) {
    std::ifstream file(task->path() / "schedstat"), status(task->path() / "stat");
    double computed = 0, queued = 0;
    if (!(file >> computed >> queued)) continue;
    // "THREAD (NAME) STATE ...", and a name may hold parentheses.
    std::string state;
    std::getline(status, state);
    const std::size_t name_end = state.rfind(") ");
    const bool runnable = name_end != std::string::npos && state.compare(name_end, 3, ") R") == 0;
    busy[static_cast<pid_t>(std::atoi(task->path().filename().c_str()))] = {1e-9 * computed, 1e-9 * queued,
                                                                            runnable};
  }
}

// What happens between fork and exec: system calls only, for other threads may have held any lock.
struct Child {
  std::vector<char*> argv, environment;
  std::vector<int> joins;  // open cgroup.procs files
  const char* folder;      // null: stay
  int requests, replies, output, info, filter;
  Identity identity;

  [[noreturn]] void exec() const {
    for (int group : joins)
      if (write(group, "0", 1) != 1) _exit(126);
    int sources[] = {output, output, requests, replies, info, filter};
    const int targets[] = {1, 2, kRequests, kReplies, kInfo, kFilter};
    for (int& source : sources)
      if (source >= 0 && (source = fcntl(source, F_DUPFD_CLOEXEC, 32)) < 0)
        _exit(126);  // out of the targets' way
    if (syscall(SYS_close_range, 3, ~0U, 4U /* CLOSE_RANGE_CLOEXEC */) != 0) _exit(126);
    for (int i = 0; i < 6; ++i)
      if (sources[i] >= 0 && dup2(sources[i], targets[i]) < 0) _exit(126);
    const int nothing = open("/dev/null", O_RDWR | O_CLOEXEC);
    if (dup2(nothing, 0) < 0) _exit(126);
    if (output < 0 && (dup2(nothing, 1) < 0 || dup2(nothing, 2) < 0)) _exit(126);
    if (!become(identity)) _exit(126);
    if (folder != nullptr && chdir(folder) != 0) _exit(126);
    execve(argv[0], argv.data(), environment.data());
    _exit(127);
  }
};

}  // namespace

CagedProcess::CagedProcess(const Cage& cage, const std::vector<std::string>& command, int requests,
                           int replies, int output)
    : isolated_(cage.isolated),
      group_(ControlGroup::create(cage.limits.memory_bytes, cage.limits.processes + 4 /* bwrap's own */)) {
  if (cage.limits.memory_of_group && !(group_ && group_->bounds_memory()))
    throw std::runtime_error("no control group bounds the memory of a program with sanitizers");
  std::vector<std::string> words, environment;
  std::string folder;
  Descriptor filter;
  Pipe info = make_pipe();
  if (cage.isolated) {
    if (cage.syscalls) filter = Descriptor(syscall_filter_descriptor(*cage.syscalls));
    words = bwrap_command(cage, command, cage.syscalls.has_value());
  } else {
    for (const std::string& word : command) words.push_back(outside(cage, word));
    folder = outside(cage, cage.folder);
    environment = {"PATH=/usr/bin", "LC_ALL=C", "SOURCE_DATE_EPOCH=1"};
  }

  std::vector<Descriptor> joins;
  if (group_)
    for (const auto& file : group_->join_files())
      joins.emplace_back(open(file.c_str(), O_WRONLY | O_CLOEXEC));

  Child child{as_argv(words),
              as_argv(environment),
              {},
              folder.empty() ? nullptr : folder.c_str(),
              requests,
              replies,
              output,
              cage.isolated ? info.write_end.get() : -1,
              filter.get(),
              sandbox_identity()};
  for (const Descriptor& join : joins)
    if (join) child.joins.push_back(join.get());

  process_ = fork();
  if (process_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (process_ == 0) child.exec();
  info_ = std::move(info.read_end);
}

CagedProcess::CagedProcess(CagedProcess&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      isolated_(other.isolated_),
      info_(std::move(other.info_)),
      init_(other.init_),
      group_(std::move(other.group_)),
      ending_(other.ending_) {
  other.group_.reset();
}

CagedProcess::~CagedProcess() {
  if (process_ > 0) wait(0);
}

void CagedProcess::kill() {
  if (process_ > 0 && !ending_) ::kill(process_, SIGKILL);
}

Descriptor CagedProcess::handle() const {
  return Descriptor(static_cast<int>(syscall(SYS_pidfd_open, process_, 0)));
}

Ending CagedProcess::wait(double seconds) {
  if (ending_) return *ending_;
  Ending ending;
  const Descriptor ended = handle();
  pollfd wanted{ended.get(), POLLIN, 0};
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  int ready = 0;
  do {
    const std::chrono::duration<double, std::milli> left = deadline - std::chrono::steady_clock::now();
    ready = poll(&wanted, 1, std::max(0, static_cast<int>(std::ceil(left.count()))));
  } while (ready < 0 && errno == EINTR);
  if (ready == 0) {
    kill();
    ending.timed_out = true;
  }
  int status = 0;
  rusage used{};
  while (wait4(process_, &status, 0, &used) < 0 && errno == EINTR) {
  }
  ending.cpu_seconds = seconds_of(used.ru_utime) + seconds_of(used.ru_stime);
  if (WIFSIGNALED(status)) {
    ending.signal = WTERMSIG(status);
  } else if (WEXITSTATUS(status) > 128 && isolated_) {
    ending.signal = WEXITSTATUS(status) - 128;  // as bwrap and shells report it
  } else {
    ending.code = WEXITSTATUS(status);
  }
  ending.out_of_memory = group_ && group_->ran_out_of_memory();
  // The soft limit on CPU time. SIGKILL may be the hard one, a second later, for a process that ignores the first; or anybody's.
  ending.timed_out |= ending.signal == SIGXCPU;
  ending_ = ending;
  group_.reset();
  return ending;
}

pid_t CagedProcess::inner_process() const {
  if (!isolated_) return process_;
  if (init_ < 0) {
    std::string text;
    char letter;
    while (text.find('}') == std::string::npos && read(info_.get(), &letter, 1) == 1) text += letter;
    const std::string key = "\"child-pid\":";
    const std::size_t at = text.find(key);
    init_ = at == std::string::npos ? 0 : std::atoi(text.c_str() + at + key.size());
  }
  if (init_ == 0) return process_;
  std::ifstream children("/proc/" + std::to_string(init_) + "/task/" + std::to_string(init_) + "/children");
  pid_t worker = 0;
  return children >> worker ? worker : init_;
}

CagedProcess::Activity CagedProcess::activity() const {
  const pid_t process = inner_process();
  Activity now;
  clockid_t clock;
  timespec used{};
  now.alive = clock_getcpuclockid(process, &clock) == 0 && clock_gettime(clock, &used) == 0;
  std::string program;
  std::ifstream("/proc/" + std::to_string(process) + "/comm") >> program;
  now.started = now.alive && (!isolated_ || (process != process_ && process != init_ && program != "bwrap"));
  if (now.alive)
    now.cpu_seconds = static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  for (const pid_t one : {process_, init_, process})
    if (one > 0) add_busy(one, now.busy);
  return now;
}

std::vector<std::string> with_inner_limits(const Limits& limits, const std::vector<std::string>& command) {
  std::vector<std::string> all = {
      "/usr/bin/prlimit",
      "--as=" + std::to_string(limits.memory_bytes),
      "--nproc=" + std::to_string(limits.processes),
      "--cpu=" + std::to_string(limits.cpu_seconds) + ":" + std::to_string(limits.cpu_seconds + 1),
      "--fsize=" + std::to_string(limits.file_bytes),
      "--core=0",
      "--nofile=256",
      "--"};
  all.insert(all.end(), command.begin(), command.end());
  return all;
}

}  // namespace grader
