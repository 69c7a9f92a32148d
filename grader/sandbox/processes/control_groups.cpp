// STAFF ONLY. Reads our own control groups, makes groups below them, and removes these, also those of killed
// graders.
#include "grader/sandbox/processes/control_groups.h"

#include <sched.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;

// A compiler takes 600 MB; hairgrade and its suite take the rest.
constexpr std::size_t kMemoryOfAJob = 750'000'000;

bool lists(const std::string& words, const std::string& word) {
  return ("," + words + ",").find("," + word + ",") != std::string::npos;
}

fs::path below(const fs::path& root, const fs::path& path) {
  return root / path.relative_path();
}

std::optional<fs::path> mount_point(const std::string& controller, const fs::path& root) {
  std::ifstream mounts(root / "proc/self/mounts");
  std::string device, folder, type, options, rest;
  while (mounts >> device >> folder >> type >> options && std::getline(mounts, rest))
    if (controller.empty() ? type == "cgroup2" : type == "cgroup" && lists(options, controller))
      return below(root, folder);
  return {};
}

// Returns this process's own group, relative to the mount point.
fs::path own_group(const std::string& controller, const fs::path& root) {
  std::ifstream groups(root / "proc/self/cgroup");
  std::string line;
  while (std::getline(groups, line)) {
    std::istringstream fields(line);
    std::string number, controllers, path;
    std::getline(fields, number, ':');
    std::getline(fields, controllers, ':');
    std::getline(fields, path);
    if (controller.empty() ? controllers.empty() : lists(controllers, controller))
      return fs::path(path).relative_path();
  }
  return {};
}

// Returns nothing if there is no such file, or if it says "max" or -1: no limit.
std::optional<double> number_in(const fs::path& file) {
  double number = -1;
  if (!(std::ifstream(file) >> number) || number < 0) return {};
  return number;
}

}  // namespace

std::vector<fs::path> own_groups(const std::string& controller, const fs::path& root) {
  const std::optional<fs::path> top = mount_point(controller, root);
  std::vector<fs::path> groups;
  if (!top) return groups;
  // Inside a container the path may be the host's, and only the mounted folder exists.
  for (fs::path group = own_group(controller, root); !group.empty(); group = group.parent_path())
    if (fs::exists(*top / group)) groups.push_back(*top / group);
  groups.push_back(*top);
  return groups;
}

double usable_processors(const fs::path& root) {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  double least = sched_getaffinity(0, sizeof allowed, &allowed) == 0
                     ? CPU_COUNT(&allowed)
                     : static_cast<double>(sysconf(_SC_NPROCESSORS_ONLN));
  const auto bound_by = [&least](std::optional<double> quota, std::optional<double> period) {
    if (quota && period && *period > 0) least = std::min(least, *quota / *period);
  };
  for (const fs::path& group : own_groups("", root)) {
    std::ifstream both(group / "cpu.max");  // "QUOTA PERIOD"
    if (double quota = 0, period = 0; both >> quota >> period) bound_by(quota, period);
  }
  for (const fs::path& group : own_groups("cpu", root))
    bound_by(number_in(group / "cpu.cfs_quota_us"), number_in(group / "cpu.cfs_period_us"));
  return least;
}

std::size_t usable_memory_bytes(const fs::path& root) {
  double least = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  for (const fs::path& group : own_groups("", root))
    least = std::min(least, number_in(group / "memory.max").value_or(least));
  for (const fs::path& group : own_groups("memory", root))
    least = std::min(least, number_in(group / "memory.limit_in_bytes").value_or(least));
  return static_cast<std::size_t>(least);
}

int usable_jobs(const fs::path& root) {
  const auto fit = static_cast<int>(usable_memory_bytes(root) / kMemoryOfAJob);
  return std::max(1, std::min(static_cast<int>(std::ceil(usable_processors(root))), fit));
}

long ended_for_memory(const fs::path& group) {
  long ended = 0;
  for (const char* file : {"memory.events", "memory.oom_control"}) {
    std::ifstream events(group / file);
    std::string key;
    for (long value; events >> key >> value;)
      if (key == "oom_kill") ended += value;
  }
  return ended;
}

long ended_for_memory() {
  long ended = 0;
  for (const char* controller : {"", "memory"})
    if (const auto groups = own_groups(controller); !groups.empty())
      ended += ended_for_memory(groups.front());
  return ended;
}

namespace {

bool write_value(const fs::path& file, const std::string& value) {
  std::ofstream out(file);
  out << value << std::flush;
  return static_cast<bool>(out);
}

constexpr const char* kPrefix = "hairgrade-";  // precedes the maker's process number and a random number

// Removes groups of killed graders. A group in use can't be removed, and nobody uses a new one after a
// minute. (The maker's process number does not help: a container may share our control groups, but not our
// processes.)
void remove_stale(const fs::path& parent) {
  std::error_code error;
  const auto old = fs::file_time_type::clock::now() - std::chrono::minutes(1);
  for (const fs::directory_entry& entry : fs::directory_iterator(parent, error))
    if (entry.path().filename().string().starts_with(kPrefix) &&
        fs::last_write_time(entry.path(), error) < old && !error)
      fs::remove(entry.path(), error);
}

using Settings = std::vector<std::pair<std::string, std::string>>;

// Makes a group with these settings, below our own group or else at the top of the hierarchy.
std::optional<fs::path> make_group(const std::string& controller, const std::string& name,
                                   const Settings& settings) {
  const std::vector<fs::path> groups = own_groups(controller);
  if (groups.empty()) return {};
  for (const fs::path& parent : {groups.front(), groups.back()}) {
    remove_stale(parent);
    const fs::path folder = parent / name;
    std::error_code error;
    if (!fs::create_directory(folder, error)) continue;
    bool set = true;
    for (const auto& [file, value] : settings)
      set = set && fs::exists(folder / file, error) && write_value(folder / file, value);
    if (set) return folder;
    fs::remove(folder, error);
  }
  return {};
}

}  // namespace

std::optional<ControlGroup> ControlGroup::create(std::size_t memory_bytes, int processes) {
  const std::string name = kPrefix + std::to_string(getpid()) + "-" + std::to_string(std::random_device()());
  const std::string memory = std::to_string(memory_bytes), pids = std::to_string(processes);
  if (auto both = make_group("", name, {{"memory.max", memory}, {"pids.max", pids}}))
    return ControlGroup({*both}, true);

  std::vector<fs::path> folders;
  if (auto folder = make_group("memory", name, {{"memory.limit_in_bytes", memory}}))
    folders.push_back(*folder);
  const bool bounds_memory = !folders.empty();
  if (auto folder = make_group("pids", name, {{"pids.max", pids}})) folders.push_back(*folder);
  if (folders.empty()) return {};
  return ControlGroup(std::move(folders), bounds_memory);
}

ControlGroup::~ControlGroup() {
  for (const fs::path& folder : folders_) {
    std::error_code error;
    // A killed process leaves its group a moment later.
    for (int i = 0; i < 200 && !fs::remove(folder, error) && fs::exists(folder, error); ++i) {
      std::ifstream processes(folder / "cgroup.procs");
      for (pid_t process; processes >> process;)
        if (process > 0) kill(process, SIGKILL);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
}

std::vector<fs::path> ControlGroup::join_files() const {
  std::vector<fs::path> files;
  for (const fs::path& folder : folders_) files.push_back(folder / "cgroup.procs");
  return files;
}

bool ControlGroup::ran_out_of_memory() const {
  return std::ranges::any_of(folders_, [](const fs::path& folder) { return ended_for_memory(folder) > 0; });
}

}  // namespace grader::sandbox
