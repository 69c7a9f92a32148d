// A program's file that may be rebuilt while it is used.
#pragma once

#include <filesystem>

namespace hair {

class ProgramFile {
 public:
  explicit ProgramFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }

  // True once for each other file with this name. A file that is still being written does not count: call
  // this function some times a second.
  bool is_new();

 private:
  std::filesystem::file_time_type time_now() const;  // the earliest time if there is no program

  std::filesystem::path path_;
  std::filesystem::file_time_type known_, seen_;
  int same_ = 0;  // the number of times it was seen unchanged
};

}  // namespace hair
