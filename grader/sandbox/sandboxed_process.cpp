// STAFF ONLY. Starts a command in a sandbox of either kind, and reads from the kernel what the command does.
#include "grader/sandbox/sandboxed_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "grader/sandbox/container_root.h"
#include "grader/sandbox/processes/control_groups.h"
#include "grader/sandbox/processes/identity.h"
#include "grader/sandbox/processes/supervisor.h"
#include "grader/sandbox/sandbox.h"

namespace grader::inline sandbox {
namespace {

// `filtered` says that a filter of system calls is on descriptor Launch::kFilter.
std::vector<std::string> bubblewrap_command(const Sandbox& sandbox, const std::vector<std::string>& command,
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
                                  "sandbox",
                                  "--info-fd",
                                  std::to_string(Launch::kInfo)};
  auto append = [&all](std::initializer_list<std::string> words) { all.insert(all.end(), words); };
  if (filtered) append({"--seccomp", std::to_string(Launch::kFilter)});
  if (sandbox.tmp_bytes > 0)
    append({"--size", std::to_string(sandbox.tmp_bytes), "--tmpfs", "/tmp", "--dev-bind", "/dev/null",
            "/dev/null"});
  for (const Mount& mount : sandbox.mounts) {
    std::error_code error;
    if (std::filesystem::is_symlink(mount.source, error) && mount.source == mount.target)
      append({"--symlink", std::filesystem::read_symlink(mount.source).string(), mount.target});
    else
      append({mount.writable ? "--bind" : "--ro-bind", mount.source.string(), mount.target});
  }
  // A compilation gives the same bytes at any time: __DATE__ and __TIME__ are fixed.
  append({"--setenv", "PATH", "/usr/bin", "--setenv", "LC_ALL", "C", "--setenv", "SOURCE_DATE_EPOCH", "1"});
  append({"--remount-ro", "/", "--chdir", sandbox.folder, "--"});
  all.insert(all.end(), command.begin(), command.end());
  return all;
}

// Replaces a path inside the sandbox, in a word of a command, by the path outside. If several mounts match,
// the longest path counts.
std::string outside(const Sandbox& sandbox, const std::string& word) {
  const Mount* found = nullptr;
  std::size_t place = std::string::npos;
  for (const Mount& mount : sandbox.mounts) {
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

std::vector<char*> as_argv(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  return argv;
}

// Adds the time that each thread of a process has computed and waited for a processor: the first two
// numbers of its `schedstat`, in nanoseconds.
void add_busy(pid_t process, std::map<pid_t, SandboxedProcess::Activity::Busy>& busy) {
  std::error_code error;
  const std::filesystem::path tasks = "/proc/" + std::to_string(process) + "/task";
  for (std::filesystem::directory_iterator task(tasks, error), end; !error && task != end;
       task.increment(error)) {
    std::ifstream file(task->path() / "schedstat"), status(task->path() / "stat");
    double computed = 0, queued = 0;
    if (!(file >> computed >> queued)) continue;
    // The line is "THREAD (NAME) STATE ...", and a name may hold parentheses.
    std::string state;
    std::getline(status, state);
    const std::size_t name_end = state.rfind(") ");
    const bool runnable = name_end != std::string::npos && state.compare(name_end, 3, ") R") == 0;
    busy[static_cast<pid_t>(std::atoi(task->path().filename().c_str()))] = {1e-9 * computed, 1e-9 * queued,
                                                                            runnable};
  }
}

// The grader and the suite hold the rest. So the supervisor ends a run before the kernel does.
std::size_t most_memory_of_a_run() {
  constexpr std::size_t kOurs = std::size_t{128} << 20;
  static const std::size_t usable = usable_memory_bytes();
  return usable > 2 * kOurs ? usable - kOurs : kOurs;
}

std::string program_of(pid_t process) {
  std::string name;
  std::ifstream("/proc/" + std::to_string(process) + "/comm") >> name;
  return name;
}

}  // namespace

SandboxedProcess::SandboxedProcess(const Sandbox& sandbox, const std::vector<std::string>& command,
                                   int requests, int replies, int output, const LeaveOut& leave_out)
    : isolation_(sandbox.isolation),
      group_(
          ControlGroup::create(sandbox.limits.memory_bytes, sandbox.limits.processes + 4 /* bwrap's own */)) {
  const bool bounded = group_ && group_->bounds_memory();
  std::vector<std::string> words = command,
                           environment = {"PATH=/usr/bin", "LC_ALL=C", "SOURCE_DATE_EPOCH=1"};
  std::string folder = sandbox.folder;
  RunLimits limits{.cpu_seconds = sandbox.limits.cpu_seconds_of_all};
  Descriptor filter;
  Pipe info = make_pipe();
  Launch launch;
  launch.requests = requests;
  launch.replies = replies;
  launch.output = output;
  switch (isolation_) {
    case Isolation::namespaces:
      if (sandbox.syscalls) filter = Descriptor(syscall_filter_descriptor(*sandbox.syscalls));
      launch.filter_file = filter.get();
      launch.info = info.write_end.get();
      words = bubblewrap_command(sandbox, command, sandbox.syscalls.has_value());
      environment.clear();
      folder.clear();
      launch.identity = sandbox_identity();
      break;
    case Isolation::container:
      launch.identity = identity_of_a_run();
      root_ = std::make_unique<ContainerRoot>(sandbox, launch.identity);
      launch.root = root_->path().c_str();
      if (sandbox.syscalls) launch.filter = syscall_filter(*sandbox.syscalls);
      launch.own_session = true;
      limits.user = launch.identity.user;
      if (!bounded) {
        limits.resident_bytes = std::min(sandbox.limits.memory_bytes, most_memory_of_a_run());
        ended_for_memory_before_ = ended_for_memory();
      }
      break;
    case Isolation::none:
      for (std::string& word : words) word = outside(sandbox, word);
      folder = outside(sandbox, folder);
      launch.identity = sandbox_identity();
      break;
  }
  launch.argv = as_argv(words);
  launch.environment = as_argv(environment);
  if (!folder.empty()) launch.folder = folder.c_str();
  std::vector<Descriptor> joins;
  if (group_)
    for (const auto& file : group_->join_files()) {
      joins.emplace_back(open(file.c_str(), O_WRONLY | O_CLOEXEC));
      if (joins.back()) launch.joins.push_back(joins.back().get());
    }
  if (leave_out) leave_out(launch, limits);
  run_ = std::make_unique<Supervisor>(launch, limits);
  info_ = std::move(info.read_end);
}

SandboxedProcess::SandboxedProcess(SandboxedProcess&&) noexcept = default;

SandboxedProcess::~SandboxedProcess() {
  if (run_) wait(0);
}

void SandboxedProcess::kill() {
  if (run_) run_->end();
}

int SandboxedProcess::handle() const {
  return run_->ended().get();
}

Ending SandboxedProcess::wait(double seconds) {
  if (ending_) return *ending_;
  Ending ending;
  pollfd wanted{handle(), POLLIN, 0};
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
  const RunReport report = run_->wait();
  ending.cpu_seconds = report.cpu_seconds;
  if (WIFSIGNALED(report.status)) {
    ending.signal = WTERMSIG(report.status);
  } else if (WEXITSTATUS(report.status) > 128 && isolation_ == Isolation::namespaces) {
    ending.signal = WEXITSTATUS(report.status) - 128;  // bwrap and shells report a signal so
  } else {
    ending.code = WEXITSTATUS(report.status);
  }
  ending.out_of_memory = report.over_memory || (group_ && group_->ran_out_of_memory());
  // If a container's memory runs out, the kernel ends the runs first.
  if (!ending.well() && ended_for_memory_before_ && ended_for_memory() > *ended_for_memory_before_)
    ending.out_of_memory = true;
  // SIGXCPU is the soft limit on CPU time. SIGKILL has several causes; one is the hard limit, a second later,
  // for a process that ignores SIGXCPU.
  ending.timed_out |= report.over_cpu || ending.signal == SIGXCPU;
  ending_ = ending;
  group_.reset();
  root_.reset();
  return ending;
}

pid_t SandboxedProcess::inner_process() const {
  if (isolation_ != Isolation::namespaces) return run_->process();
  if (init_ < 0) {
    std::string text;
    char letter;
    while (text.find('}') == std::string::npos && read(info_.get(), &letter, 1) == 1) text += letter;
    const std::string key = "\"child-pid\":";
    const std::size_t at = text.find(key);
    init_ = at == std::string::npos ? 0 : std::atoi(text.c_str() + at + key.size());
  }
  if (init_ == 0) return run_->process();
  std::ifstream children("/proc/" + std::to_string(init_) + "/task/" + std::to_string(init_) + "/children");
  pid_t worker = 0;
  return children >> worker ? worker : init_;
}

bool SandboxedProcess::has_started(pid_t process) const {
  switch (isolation_) {
    case Isolation::none:
      return true;
    case Isolation::namespaces:
      return process != run_->process() && process != init_ && program_of(process) != "bwrap";
    case Isolation::container:
      return program_of(process) != program_of(getpid());
  }
  return false;
}

SandboxedProcess::Activity SandboxedProcess::activity() const {
  const pid_t process = inner_process();
  Activity now;
  clockid_t clock;
  timespec used{};
  now.alive = clock_getcpuclockid(process, &clock) == 0 && clock_gettime(clock, &used) == 0;
  now.started = now.alive && has_started(process);
  if (now.alive)
    now.cpu_seconds = static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
  for (const pid_t one : {run_->process(), init_, process})
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

}  // namespace grader::sandbox
