// A file that is written piece by piece. It lies in a run's temporary folder; errors name its final path.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace hair {

class OutputFile {
 public:
  // All functions throw BadInput with `shown` and the reason.
  OutputFile(const std::filesystem::path& file, std::filesystem::path shown);
  void write(std::string_view bytes);
  void overwrite(std::uint64_t at, std::string_view bytes);  // replaces bytes that were written before
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
