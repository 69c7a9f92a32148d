// A file that is written piece by piece. It lies in a run's temporary folder, and errors name the place where
// it is going to be.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace hair {

class OutputFile {
 public:
  // All of them throw BadInput, with `shown` and why.
  OutputFile(const std::filesystem::path& file, std::filesystem::path shown);
  void write(std::string_view bytes);
  void overwrite(std::uint64_t at, std::string_view bytes);  // of what was written before
  void close();

  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

 private:
  void flush();
  [[noreturn]] void fail(int error) const;

  std::filesystem::path shown_;
  int descriptor_;
  std::string buffer_;
};

}  // namespace hair
