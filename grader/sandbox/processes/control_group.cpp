// STAFF ONLY. Makes control groups below our own, and removes them, also those of killed graders.
#include "grader/sandbox/processes/control_group.h"

#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <random>
#include <string>
#include <thread>

#include "grader/sandbox/processes/own_groups.h"

namespace grader::inline sandbox {
namespace {

namespace fs = std::filesystem;

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
