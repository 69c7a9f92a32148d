// STAFF ONLY. Finds a zip's end, and clears the flag of UTF-8 of other names (APPNOTE.TXT 4.3.7, 4.3.12,
// 4.3.14 to 4.3.16).
#include "grader/intake/archives/zip_source.h"

#include <archive.h>

#include <algorithm>
#include <cstdio>

#include "grader/intake/archives/container.h"
#include "grader/intake/names/names.h"
#include "grader/text/letters.h"

namespace grader::inline intake {
namespace {

std::uint64_t number_at(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t i = size; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

}  // namespace

ZipSource::ZipSource(ReadAt read, std::uint64_t size) : read_(std::move(read)), size_(size) {
  // Fits the record, the longest comment, and as many bytes behind the end.
  constexpr std::uint64_t kTail = 22 + 2 * 65535;
  std::string tail(static_cast<std::size_t>(std::min(size_, kTail)), '\0');
  const std::uint64_t begin = size_ - tail.size();
  if (!read_all(begin, tail)) return;
  // Takes the last record that fits. A comment may hold such bytes, too.
  for (std::size_t at = tail.rfind("PK\x05\x06"); at != std::string::npos && !is_zip_;
       at = at > 0 ? tail.rfind("PK\x05\x06", at - 1) : std::string::npos)
    is_zip_ = take_end(std::string_view(tail).substr(at), begin + at);
  if (is_zip_) read_directory();
}

bool ZipSource::read_all(std::uint64_t offset, std::string& bytes) const {
  for (std::size_t done = 0; done < bytes.size();) {
    const std::size_t size = read_(begin_ + offset + done, bytes.data() + done, bytes.size() - done);
    if (size == 0) return false;
    done += size;
  }
  return true;
}

// Takes the record at `end` if its directory stands before it.
bool ZipSource::take_end(std::string_view record, std::uint64_t end) {
  constexpr std::uint64_t kEnd = 22, kLocator = 20, kLarge = 56, kMostDirectory = std::uint64_t{1} << 28;
  if (record.size() < kEnd) return false;
  std::uint64_t size = number_at(record, 12, 4), offset = number_at(record, 16, 4), behind = end;
  std::string locator(kLocator, '\0'), large(kLarge, '\0'), first(4, '\0');
  if (end >= kLocator + kLarge && read_all(end - kLocator, locator) && locator.starts_with("PK\x06\x07")) {
    // The record lies where the locator says, or right before it: bytes may precede the first entry.
    const auto is_large = [&](std::uint64_t at) {
      behind = at;
      return at < end && read_all(at, large) && large.starts_with("PK\x06\x06");
    };
    if (!is_large(number_at(locator, 8, 8)) && !is_large(end - kLocator - kLarge)) return false;
    size = number_at(large, 40, 8);
    offset = number_at(large, 48, 8);
  }
  if (size > std::min(behind, kMostDirectory) || offset > behind - size || !read_all(0, first)) return false;
  const std::uint64_t before = behind - size - offset;
  // A zip inside a truncated zip must not count for all of it, unless a whole zip ends before it.
  if (before > 0 && first == "PK\x03\x04" && (!read_all(before - kEnd, first) || first != "PK\x05\x06"))
    return false;
  if (size > 0 && (!read_all(behind - size, first) || first != "PK\x01\x02")) return false;
  begin_ = before;
  size_ = end + kEnd - before;
  directory_ = offset;
  directory_size_ = size;
  return true;
}

void ZipSource::read_directory() {
  constexpr std::size_t kHeader = 46;
  std::string entries(static_cast<std::size_t>(directory_size_), '\0');
  if (!read_all(directory_, entries)) return;
  for (std::size_t at = 0; at + kHeader <= entries.size() && entries.compare(at, 4, "PK\x01\x02") == 0;) {
    const std::string_view name =
        std::string_view(entries).substr(at + kHeader, number_at(entries, at + 28, 2));
    if ((number_at(entries, at + 8, 2) & 0x800) != 0 && !is_utf8(name)) {
      flags_.push_back(directory_ + at + 9);
      flags_.push_back(number_at(entries, at + 42, 4) + 7);
    }
    if (!is_ignored(entry_at(std::string(name)).path)) ++entries_;
    at += kHeader + name.size() + number_at(entries, at + 30, 2) + number_at(entries, at + 32, 2);
  }
  std::ranges::sort(flags_);
}

std::size_t ZipSource::read_block() {
  const std::size_t size =
      read_(begin_ + at_, block_.data(), std::min<std::uint64_t>(block_.size(), size_ - at_));
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

}  // namespace grader::intake
