// STAFF ONLY. Writes and reads the files of a plan that a cluster's nodes share.
#include "grader/class_folder/shared_plan.h"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <fstream>
#include <set>
#include <system_error>

#include "grader/course/input.h"
#include "grader/sandbox/processes/descriptor.h"

namespace grader::inline class_folder {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = ".slurm-";  // no submission's name begins with a dot
constexpr const char* kEnded = ".ended";
// Slurm's credentials are no longer valid on a machine whose clock is five minutes off.
constexpr double kMostClockSeconds = 300;

}  // namespace

std::optional<SharedPlan> SharedPlan::in(const fs::path& grades) {
  std::error_code none;
  for (const fs::directory_entry& entry : fs::directory_iterator(grades, none))
    if (entry.path().filename().string().starts_with(kPrefix)) return SharedPlan(entry.path());
  return {};
}

SharedPlan SharedPlan::make(const fs::path& grades) {
  try {
    clear(grades);
  } catch (const fs::filesystem_error&) {  // a shared folder may keep them for a while
  }
  std::string folder = (fs::absolute(grades).lexically_normal() / kPrefix).string() + "XXXXXX";
  if (mkdtemp(folder.data()) == nullptr)
    throw BadInput(folder + ": can't be made: " + std::generic_category().message(errno));
  for (const char* part : {"hand-ins", "cache", "arrays", "logs", "refused", "results"})
    fs::create_directory(fs::path(folder) / part);
  return SharedPlan(folder);
}

// Two processes may write the same file: Slurm may start a task again whose node only seems dead.
void SharedPlan::write(const std::string& name, const std::string& bytes) const {
  const fs::path file = folder_ / name;
  std::string temporary = (file.parent_path() / ".new-XXXXXX").string();
  const Descriptor out(mkostemp(temporary.data(), O_CLOEXEC));
  ssize_t written = out ? 0 : -1;
  for (std::size_t at = 0; written >= 0 && at < bytes.size(); at += static_cast<std::size_t>(written))
    written = ::write(out.get(), bytes.data() + at, bytes.size() - at);
  if (written >= 0 && fsync(out.get()) == 0 && rename(temporary.c_str(), file.c_str()) == 0) return;
  const std::string why = std::generic_category().message(errno);
  if (out) unlink(temporary.c_str());
  throw BadInput(file.string() + ": can't be written: " + why);
}

std::vector<SentArray> SharedPlan::arrays() const {
  std::vector<SentArray> all;
  while (has(numbered("arrays", all.size()))) all.push_back(get<SentArray>(numbered("arrays", all.size())));
  return all;
}

std::string SharedPlan::nodes_that_refused() const {
  std::set<std::string> nodes;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_ / "refused"))
    if (const std::string name = entry.path().filename().string(); !name.starts_with(".")) nodes.insert(name);
  std::string all;
  for (const std::string& node : nodes) all += (all.empty() ? "" : ",") + node;
  return all;
}

void SharedPlan::forget_refusals() const {
  fs::remove_all(folder_ / "refused");
  fs::create_directory(folder_ / "refused");
}

void SharedPlan::remove() const {
  const fs::path place = (folder_ / "").parent_path(),
                 ended = place.parent_path() / (kEnded + place.filename().string());
  std::error_code ignored;
  fs::rename(place, ended, ignored);
  fs::remove_all(ended, ignored);
}

void SharedPlan::clear(const fs::path& grades) {
  std::vector<fs::path> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(grades))
    if (const std::string name = entry.path().filename().string();
        name == kCollectLog || name.starts_with(kEnded))
      left.push_back(entry.path());
  for (const fs::path& one : left) fs::remove_all(one);
}

void SharedPlan::put_result(std::size_t number, const std::string& fingerprint, const Graded& graded) const {
  write(numbered("results", number), fingerprint + "\n" + json_text(graded, -1));
}

std::string SharedPlan::fingerprint(std::size_t number) const {
  std::string first;
  std::getline(std::ifstream(folder_ / numbered("results", number)), first);
  return first;
}

std::optional<Graded> SharedPlan::graded(std::size_t number) const {
  const fs::path file = folder_ / numbered("results", number);
  if (!fs::exists(file)) return {};
  const std::string text = hair::bytes_of(file);
  return from_json_text<Graded>(text.substr(text.find('\n') + 1), file.string());
}

void SharedPlan::try_it(const std::string& node) const {
  const std::string name = "logs/try-" + node + "-" + std::to_string(getpid());
  write(name, "");
  const auto off = fs::file_time_type::clock::now() - fs::last_write_time(folder_ / name);
  fs::remove(folder_ / name);
  if (const double seconds = std::abs(std::chrono::duration<double>(off).count());
      seconds > kMostClockSeconds)
    throw BadInput("its clock is " + std::to_string(std::lround(seconds)) + " s off that of " +
                   folder_.string());
}

}  // namespace grader::class_folder
