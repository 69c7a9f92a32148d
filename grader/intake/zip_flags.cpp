// STAFF ONLY. Clears the flag of UTF-8 where a zip's names are none (APPNOTE.TXT 4.3.7, 4.3.12, 4.3.14 to 4.3.16).
#include "grader/intake/zip_flags.h"

#include <archive.h>

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "grader/text/letters.h"

namespace grader {
namespace {

std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = size; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

}  // namespace

ZipSource::ZipSource(ReadAt read, std::uint64_t size) : read_(std::move(read)), size_(size) {
  find_wrong_flags();
}

bool ZipSource::read_all(std::uint64_t offset, std::string& bytes) const {
  for (std::size_t done = 0; done < bytes.size();) {
    const std::size_t size = read_(offset + done, bytes.data() + done, bytes.size() - done);
    if (size == 0) return false;
    done += size;
  }
  return true;
}

void ZipSource::find_wrong_flags() {
  constexpr std::uint64_t kEnd = 22, kLongestComment = 65535, kMostDirectory = std::uint64_t{1} << 28;
  std::string tail(static_cast<std::size_t>(std::min(size_, kEnd + kLongestComment)), '\0');
  if (!read_all(size_ - tail.size(), tail)) return;
  const std::size_t end = tail.rfind("PK\x05\x06");
  if (end == std::string::npos || tail.size() - end < kEnd) return;
  std::uint64_t directory_size = number_at(tail, end + 12, 4), directory = number_at(tail, end + 16, 4);
  if (end >= 20 && tail.compare(end - 20, 4, "PK\x06\x07") == 0) {
    std::string large(56, '\0');
    if (!read_all(number_at(tail, end - 12, 8), large)) return;
    directory_size = number_at(large, 40, 8);
    directory = number_at(large, 48, 8);
  }
  if (directory_size > std::min(size_, kMostDirectory) || directory > size_ - directory_size) return;
  std::string entries(static_cast<std::size_t>(directory_size), '\0');
  if (!read_all(directory, entries)) return;
  constexpr std::size_t kHeader = 46;
  for (std::size_t at = 0; at + kHeader <= entries.size() && entries.compare(at, 4, "PK\x01\x02") == 0;) {
    const std::size_t name = number_at(entries, at + 28, 2);
    const std::size_t next =
        at + kHeader + name + number_at(entries, at + 30, 2) + number_at(entries, at + 32, 2);
    if (next > entries.size()) return;
    if ((number_at(entries, at + 8, 2) & 0x800) != 0 &&
        !is_utf8(std::string_view(entries).substr(at + kHeader, name))) {
      flags_.push_back(directory + at + 9);
      flags_.push_back(number_at(entries, at + 42, 4) + 7);
    }
    at = next;
  }
  std::ranges::sort(flags_);
}

std::size_t ZipSource::read_block() {
  const std::size_t size = read_(at_, block_.data(), block_.size());
  for (auto flag = std::ranges::lower_bound(flags_, at_); flag != flags_.end() && *flag < at_ + size; ++flag)
    block_[static_cast<std::size_t>(*flag - at_)] =
        static_cast<char>(block_[static_cast<std::size_t>(*flag - at_)] & ~0x08);
  at_ += size;
  return size;
}

int ZipSource::open(archive* reader) {
  const auto read = [](archive*, void* self, const void** block) -> la_ssize_t {
    auto& source = *static_cast<ZipSource*>(self);
    *block = source.block_.data();
    return static_cast<la_ssize_t>(source.read_block());
  };
  const auto seek = [](archive*, void* self, la_int64_t offset, int whence) -> la_int64_t {
    auto& source = *static_cast<ZipSource*>(self);
    const auto size = static_cast<la_int64_t>(source.size_);
    const la_int64_t from = whence == SEEK_SET   ? 0
                            : whence == SEEK_CUR ? static_cast<la_int64_t>(source.at_)
                                                 : size;
    if (offset < -from || offset > size - from) return ARCHIVE_FATAL;
    source.at_ = static_cast<std::uint64_t>(from + offset);
    return from + offset;
  };
  archive_read_set_read_callback(reader, read);
  archive_read_set_seek_callback(reader, seek);
  archive_read_set_callback_data(reader, this);
  return archive_read_open1(reader);
}

}  // namespace grader
