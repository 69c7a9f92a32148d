// STAFF ONLY. Reads the limits of control groups.
#include "grader/sandbox/processes/own_groups.h"

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

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

}  // namespace grader::sandbox
