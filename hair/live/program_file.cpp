#include "hair/live/program_file.h"

#include <unistd.h>

#include <system_error>
#include <utility>

namespace hair {

namespace fs = std::filesystem;

namespace {

constexpr int kSettled = 3;

}  // namespace

ProgramFile::ProgramFile(fs::path path) : path_(std::move(path)), known_(time_now()), seen_(known_) {}

fs::file_time_type ProgramFile::time_now() const {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(path_, error);
  return error || access(path_.c_str(), X_OK) != 0 ? fs::file_time_type::min() : time;
}

bool ProgramFile::is_new() {
  const fs::file_time_type now = time_now();
  same_ = now == seen_ ? same_ + 1 : 0;
  seen_ = now;
  if (now == known_ || now == fs::file_time_type::min() || same_ < kSettled) return false;
  known_ = now;
  return true;
}

}  // namespace hair
