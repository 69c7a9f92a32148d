#include "hair/lab/run/output_folder.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <system_error>
#include <utility>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"
#include "hair/lab/run/run_record.h"

namespace hair {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kTemporary = ".hairlab-";
constexpr std::size_t kBuffer = 1 << 20;  // bytes

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw BadInput(printable(folder.string(), 4096) + ": " + why);
}

[[noreturn]] void cannot_make(const fs::path& folder, const std::error_code& error) {
  refuse(folder,
         "can't be made (" + error.message() + "); give a folder that can be written, with room in it");
}

bool is_of(const OutputKind& kind, const std::string& name) {
  if (name == kind.record) return true;
  if (std::ranges::find(kind.files, name) != kind.files.end()) return true;
  if (!kind.frames) return false;
  constexpr std::string_view kFrame = "frame-", kPng = ".png";
  return name.starts_with(kFrame) && name.ends_with(kPng) && name.size() > kFrame.size() + kPng.size() &&
         std::all_of(name.begin() + kFrame.size(), name.end() - kPng.size(),
                     [](char c) { return c >= '0' && c <= '9'; });
}

bool begins_with(const fs::path& file, std::string_view begin) {
  std::string first(begin.size(), '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(first.data(), static_cast<std::streamsize>(first.size()));
  return in && first == begin;
}

void check_replaceable(const fs::path& folder, const OutputKind& kind) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (!fs::exists(status)) return;
  if (!fs::is_directory(status)) refuse(folder, "is a file; give a folder");
  if (fs::equivalent(folder, fs::current_path(error), error))
    refuse(folder, "is the folder that you are in; give one below it");
  fs::directory_iterator entries(folder, error);
  if (error) refuse(folder, "can't be read (" + error.message() + "); give another folder");
  if (entries == fs::directory_iterator()) return;
  if (!begins_with(folder / kind.record, kind.begin))
    refuse(folder, "is not empty, and not from " + kind.command +
                       "; give an empty folder, or one that is not there yet");
  for (const fs::directory_entry& entry : entries)
    if (!is_of(kind, entry.path().filename().string()))
      refuse(folder, "holds " + printable(entry.path().filename().string()) + ", which is not from " +
                         kind.command + "; move it away, or give another folder");
}

// Removes remains of runs into this folder that could not clean up: killed, or out of power.
void remove_remains(const fs::path& folder) {
  const std::string prefix = kTemporary.data() + folder.filename().string() + "-";
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.parent_path(), ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix)) continue;
    int process = 0;
    const char* end = name.data() + name.size();
    if (std::from_chars(name.data() + prefix.size(), end, process).ptr != end || process <= 0) continue;
    if (kill(process, 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), ignored);
  }
}

}  // namespace

const OutputKind& run_output() {
  static const OutputKind kind{"hairlab run",
                               "run.json",
                               std::string(kRunRecordBegin),
                               {"film.mp4", "motion.json", "states.bin", "states.csv", "view.html"},
                               true};
  return kind;
}

OutputFolder::OutputFolder(const fs::path& folder, const OutputKind& kind) : kind_(kind) {
  if (folder.empty()) refuse("--out", "is empty; give the path of a folder");
  std::error_code error;
  folder_ = fs::weakly_canonical(fs::absolute(folder, error), error);
  if (error) cannot_make(folder, error);
  if (!folder_.has_filename()) folder_ = folder_.parent_path();
  if (folder_ == folder_.root_path()) refuse(folder, "is the root of all files; give a folder of its own");
  check_replaceable(folder_, kind_);

  for (fs::path above = folder_.parent_path(); !fs::exists(above, error); above = above.parent_path())
    above_.push_back(above);
  fs::create_directories(folder_.parent_path(), error);
  if (!error) remove_remains(folder_);
  const fs::path temporary = folder_.parent_path() / (kTemporary.data() + folder_.filename().string() + "-" +
                                                      std::to_string(getpid()));
  if (!error) fs::create_directory(temporary, error);
  if (error) {
    clean_up();
    cannot_make(folder_, error);
  }
  temporary_ = temporary;
}

OutputFolder::~OutputFolder() {
  clean_up();
}

void OutputFolder::clean_up() const {
  std::error_code ignored;
  if (!temporary_.empty()) fs::remove_all(temporary_, ignored);
  for (const fs::path& above : above_) rmdir(above.c_str());  // removes only empty folders
}

void OutputFolder::keep() {
  check_replaceable(folder_, kind_);  // the folder may have changed meanwhile
  std::error_code error;
  const fs::path before = temporary_.string() + "-before";
  const bool replaces = fs::exists(folder_, error);
  if (replaces) fs::rename(folder_, before, error);
  if (error) cannot_make(folder_, error);
  fs::rename(temporary_, folder_, error);
  if (error) {
    std::error_code ignored;
    if (replaces) fs::rename(before, folder_, ignored);
    cannot_make(folder_, error);
  }
  temporary_.clear();
  if (replaces) fs::remove_all(before, error);
}

void write_whole(const OutputFolder& folder, const std::string& name, std::string_view bytes) {
  OutputFile file(folder.now(name), folder.then(name));
  file.write(bytes);
  file.close();
}

std::string frame_name(int frame) {
  const std::string digits = std::to_string(frame);
  return "frame-" + std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits + ".png";
}

OutputFile::OutputFile(const std::filesystem::path& file, std::filesystem::path shown)
    : shown_(std::move(shown)),
      descriptor_(open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0644)) {
  if (descriptor_ < 0) fail(errno);
}

OutputFile::~OutputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void OutputFile::write(std::string_view bytes) {
  buffer_ += bytes;
  if (buffer_.size() >= kBuffer) flush();
}

void OutputFile::overwrite(std::uint64_t at, std::string_view bytes) {
  flush();
  if (lseek(descriptor_, static_cast<off_t>(at), SEEK_SET) < 0) fail(errno);
  buffer_ = bytes;
  flush();
  if (lseek(descriptor_, 0, SEEK_END) < 0) fail(errno);
}

void OutputFile::close() {
  flush();
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void OutputFile::fail(int error) const {
  throw BadInput(printable(shown_.string(), 4096) + ": can't be written (" +
                 std::generic_category().message(error) +
                 "); give a folder that can be written, with room in it");
}

}  // namespace hair
