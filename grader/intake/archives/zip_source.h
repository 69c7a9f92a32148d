// STAFF ONLY. A zip's bytes as libarchive expects them, which is stricter than other programs:
//
// - It looks for the end record in the last 16 KiB. So a comment and bytes behind the end are removed.
// - Bytes before the first entry, as of a program that unpacks itself, go if the zip's offsets don't count
// them.
// - An entry with the flag of UTF-8 and other bytes gets no name, so that two of them look equal. The flag is
// cleared: names keep their bytes, and container.cpp decodes them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

struct archive;

namespace grader::inline intake {

class ZipSource {
 public:
  // Reads up to `size` bytes at an offset; 0 at the end.
  using ReadAt = std::function<std::size_t(std::uint64_t offset, char* bytes, std::size_t size)>;

  ZipSource(ReadAt read, std::uint64_t size);

  bool is_zip() const { return is_zip_; }
  // Returns how many entries the directory claims, except the skipped ones. The library keeps all of them in
  // memory.
  std::size_t entries() const { return entries_; }
  bool is_empty() const { return directory_size_ == 0; }

  // Opens the reader with these bytes. It must not outlive this object. Returns libarchive's code.
  int open(archive* reader);

 private:
  static constexpr std::size_t kBlock = 65536;

  bool read_all(std::uint64_t offset, std::string& bytes) const;
  bool take_end(std::string_view record, std::uint64_t end);
  void read_directory();
  std::size_t read_block();

  ReadAt read_;
  std::uint64_t begin_ = 0, size_, at_ = 0;  // all but `begin_` count from there
  std::uint64_t directory_ = 0, directory_size_ = 0;
  bool is_zip_ = false;
  std::size_t entries_ = 0;
  std::vector<std::uint64_t> flags_;  // are offsets of bytes whose bit 3 is wrong, ascending
  std::string block_ = std::string(kBlock, '\0');
};

}  // namespace grader::intake
