// STAFF ONLY. A zip's bytes, where entries that say "UTF-8" of other bytes don't say so any more: libarchive gives such an entry no name at
// all, and two of them could not be told apart. Names are then as they stand, and code_page.h decodes them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

struct archive;

namespace grader {

class ZipSource {
 public:
  // Reads up to `size` bytes at an offset; 0 at the end.
  using ReadAt = std::function<std::size_t(std::uint64_t offset, char* bytes, std::size_t size)>;

  ZipSource(ReadAt read, std::uint64_t size);

  // Opens the reader with these bytes. It must not outlive this. Returns libarchive's code.
  int open(archive* reader);

 private:
  static constexpr std::size_t kBlock = 65536;

  bool read_all(std::uint64_t offset, std::string& bytes) const;
  void find_wrong_flags();
  std::size_t read_block();

  ReadAt read_;
  std::uint64_t size_, at_ = 0;
  std::vector<std::uint64_t> flags_;  // offsets of bytes whose bit 3 is wrong, ascending
  std::string block_ = std::string(kBlock, '\0');
};

}  // namespace grader
