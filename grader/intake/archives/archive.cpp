// STAFF ONLY. Reads archives by libarchive.
#include "grader/intake/archives/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "grader/course/input.h"
#include "grader/intake/archives/zip_source.h"
#include "grader/intake/names/archive_format.h"
#include "grader/intake/names/names.h"

namespace grader::inline intake {
namespace {

struct CloseArchive {
  void operator()(archive* handle) const { archive_read_free(handle); }
};
using Handle = std::unique_ptr<archive, CloseArchive>;

std::string first_bytes(int file) {
  std::string head(kHeadBytes, '\0');
  head.resize(static_cast<std::size_t>(std::max<ssize_t>(pread(file, head.data(), head.size(), 0), 0)));
  return head;
}

// Returns the name's bytes, in any code page; "" if the library can't give it.
std::string name_in(archive_entry* entry) {
  const char* path = archive_entry_pathname(entry);
  if (!path) path = archive_entry_pathname_utf8(entry);
  return path ? path : "";
}

// Reads an archive once, from its first entry on. A gzip has a reader of its own that counts the output,
// since the library limits only the sizes that the inner tar states.
class Reading {
 public:
  Reading(int file, const std::string& shown, ArchiveLimits limits)
      : shown_(shown), limits_(limits), left_(limits.unpacked_bytes) {
    const std::string head = first_bytes(file);
    entries_.reset(archive_read_new());
    if (is_gzip(head)) {
      stream_.reset(archive_read_new());
      archive_read_append_filter(stream_.get(), ARCHIVE_FILTER_GZIP);
      archive_read_support_format_raw(stream_.get());
      open(stream_, file);
      archive_entry* only = nullptr;
      if (archive_read_next_header(stream_.get(), &only) < ARCHIVE_WARN) refuse_damaged();
      unpack_head();
      read_tar(&Reading::next_unpacked);
    } else if (is_tar(head)) {
      archive_read_support_format_tar(entries_.get());
      open(entries_, file);
    } else if (const std::string_view other = foreign_format(head); !other.empty()) {
      refuse_format(other);
    } else {
      open_zip(file);
      if (!zip_->is_zip() && is_zip(head)) refuse_damaged();
      if (!zip_->is_zip()) refuse_format("neither a zip nor a tar.gz archive");
      if (zip_->entries() > limits.entries) refuse_entries();
      archive_read_support_format_zip_seekable(entries_.get());
      empty_ = zip_->is_empty();  // libarchive reports an empty zip as damaged
      if (!empty_ && zip_->open(entries_.get()) < ARCHIVE_WARN) refuse_damaged();
    }
  }
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  // Returns null at the end.
  archive_entry* next() {
    if (empty_) return nullptr;
    for (;;) {
      archive_entry* entry = nullptr;
      const int result = archive_read_next_header(entries_.get(), &entry);
      if (result == ARCHIVE_EOF) return nullptr;
      if (result < ARCHIVE_WARN) refuse();
      // Files of the operating system are skipped here, so that they use up no limit.
      if (!limits_.with_hidden && is_ignored(entry_at(name_in(entry)).path)) continue;
      if (++count_ > limits_.entries) refuse_entries();
      return entry;
    }
  }

  std::string data(const std::string& path, std::size_t most) {
    if (!is_frugal()) {
      throw Refused(path + " is packed in " + shown_ +
                    " by a method that is not read here. Pack it again as a .zip without special settings.");
    }
    std::string bytes;
    std::array<char, 65536> block;
    for (;;) {
      const la_ssize_t size = archive_read_data(entries_.get(), block.data(), block.size());
      if (size == 0) return bytes;
      if (size < 0) {
        throw Unreadable(path + " is damaged in " + shown_ + ". Pack it again, and check that it opens.");
      }
      bytes.append(block.data(), static_cast<std::size_t>(size));
      if (bytes.size() > most) throw Refused(path + " is larger than " + shown_size(most) + ".");
    }
  }

  void refuse_entries() const {
    throw Refused(shown_ + " holds more than " + std::to_string(limits_.entries) +
                  " files and folders. Hand in only the exercise files.");
  }

 private:
  void open_zip(int file) {
    zip_.emplace(
        [file](std::uint64_t offset, char* block, std::size_t size) {
          return static_cast<std::size_t>(
              std::max<ssize_t>(pread(file, block, size, static_cast<off_t>(offset)), 0));
        },
        static_cast<std::uint64_t>(std::max<off_t>(lseek(file, 0, SEEK_END), 0)));
  }

  void open(Handle& handle, int file) {
    constexpr std::size_t block = 65536;
    if (lseek(file, 0, SEEK_SET) != 0 || archive_read_open_fd(handle.get(), file, block) < ARCHIVE_WARN)
      refuse_damaged();
  }

  // Stored and deflated data need a window of 32 kB. In other methods of zip a few bytes request gigabytes:
  // the dictionary of LZMA and xz, the model of PPMd. The library names the method: "ZIP 2.0 (deflation)".
  bool is_frugal() {
    if (archive_format(entries_.get()) != ARCHIVE_FORMAT_ZIP) return true;
    const std::string_view name = archive_format_name(entries_.get());
    return name.ends_with("(deflation)") || name.ends_with("(uncompressed)");
  }

  void read_tar(la_ssize_t (*read)(archive*, void*, const void**)) {
    archive_read_append_filter(entries_.get(), ARCHIVE_FILTER_NONE);
    archive_read_support_format_tar(entries_.get());
    if (archive_read_open(entries_.get(), this, nullptr, read, nullptr) < ARCHIVE_WARN) refuse();
  }

  // Unpacks a gzip's first block: its content may be one file, and no tar.
  void unpack_head() {
    while (head_ < kHeadBytes) {
      const la_ssize_t size = archive_read_data(stream_.get(), block_.data() + head_, block_.size() - head_);
      if (size < 0) refuse_damaged();
      if (size == 0) break;
      head_ += static_cast<std::size_t>(size);
    }
    const std::string_view head(block_.data(), std::min(head_, kHeadBytes));
    if (head_ > 0 && head.front() != '\0' && !is_tar(head))
      throw Unreadable(
          shown_ +
          " is one file that is packed with gzip, and no tar.gz. Hand in a .zip or .tar.gz archive.");
    left_ -= std::min(left_, head_);
  }

  static la_ssize_t next_unpacked(archive*, void* self, const void** block) {
    auto& reading = *static_cast<Reading*>(self);
    *block = reading.block_.data();
    if (reading.head_ > 0) return static_cast<la_ssize_t>(std::exchange(reading.head_, 0));
    const la_ssize_t size =
        archive_read_data(reading.stream_.get(), reading.block_.data(), reading.block_.size());
    if (size < 0) return ARCHIVE_FATAL;
    if (static_cast<std::size_t>(size) > reading.left_) {
      reading.too_much_ = true;
      return ARCHIVE_FATAL;
    }
    reading.left_ -= static_cast<std::size_t>(size);
    return size;
  }

  [[noreturn]] void refuse_format(std::string_view what) const {
    throw Unreadable(shown_ + " is " + std::string(what) + ". Hand in a .zip or .tar.gz archive.");
  }
  [[noreturn]] void refuse() const {
    if (!too_much_) refuse_damaged();
    throw Refused(shown_ + " unpacks to more than " + shown_size(limits_.unpacked_bytes) +
                  ". Hand in only the exercise files.");
  }
  [[noreturn]] void refuse_damaged() const {
    throw Unreadable(shown_ +
                     " can't be read: it is damaged or cut short. Pack it again, and check that it opens.");
  }

  std::string shown_;
  ArchiveLimits limits_;
  std::size_t left_;
  bool too_much_ = false, empty_ = false;
  std::size_t count_ = 0;
  std::array<char, 65536> block_;
  std::size_t head_ = 0;  // bytes unpacked in the block's first look
  std::optional<ZipSource> zip_;
  Handle stream_;   // is a gzip's only content
  Handle entries_;  // destroyed before the stream that it reads
};

Entry described(archive_entry* entry) {
  Entry result = entry_at(name_in(entry));
  result.bytes = static_cast<std::uintmax_t>(std::max<la_int64_t>(archive_entry_size(entry), 0));
  result.encrypted = archive_entry_is_encrypted(entry) != 0;
  const auto type = archive_entry_filetype(entry);
  if (archive_entry_hardlink(entry)) {
    result.kind = Entry::Kind::hard_link;
  } else if (type == AE_IFLNK) {
    result.kind = Entry::Kind::symbolic_link;
  } else if (type == AE_IFDIR) {
    result.kind = Entry::Kind::folder;
  } else if (type != AE_IFREG) {
    result.kind = Entry::Kind::special;
  }
  return result;
}

}  // namespace

Descriptor opened(const ArchiveSource& source, const std::string& shown) {
  if (const auto* path = std::get_if<std::filesystem::path>(&source)) {
    Descriptor file(open(path->c_str(), O_RDONLY | O_CLOEXEC));
    if (!file) throw Unreadable(shown + " can't be read (" + std::generic_category().message(errno) + ").");
    return file;
  }
  const std::string& bytes = std::get<std::string>(source);
  Descriptor file(memfd_create("archive", MFD_CLOEXEC));
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t size = write(file.get(), bytes.data() + at, bytes.size() - at);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) throw std::system_error(errno, std::generic_category(), "memory for " + shown);
    at += static_cast<std::size_t>(size);
  }
  return file;
}

Archive::Archive(Descriptor file, std::string shown, ArchiveLimits limits)
    : file_(std::move(file)), shown_(std::move(shown)), limits_(limits) {}

std::vector<Entry> Archive::list() {
  Reading reading(file_.get(), shown_, limits_);
  std::vector<Entry> entries;
  while (archive_entry* entry = reading.next()) {
    entries.push_back(described(entry));
    if (entries.back().shown.size() > kLongestPath) {
      throw Refused(shown_ + " holds a path of more than " + std::to_string(kLongestPath) +
                    " characters. Hand in only the exercise files.");
    }
  }
  return entries;
}

void Archive::visit(const std::vector<std::size_t>& indices,
                    const std::function<void(std::size_t, const Read&)>& take) {
  if (indices.empty()) return;
  Reading reading(file_.get(), shown_, limits_);
  std::size_t next = 0;  // is the index of the next entry
  for (const std::size_t index : indices) {
    archive_entry* entry = nullptr;
    for (; next <= index; ++next) {
      entry = reading.next();
      if (!entry) throw Refused(shown_ + " changed while it was read.");
    }
    const std::string path = printable(described(entry).shown);
    take(index, [&](std::size_t most) { return reading.data(path, most); });
  }
}

std::unique_ptr<Container> open_here(const ArchiveSource& source, const std::string& shown,
                                     ArchiveLimits limits) {
  return std::make_unique<Archive>(source, shown, limits);
}

bool has_archive_content(const std::filesystem::path& file) {
  const std::string head = first_bytes(Descriptor(open(file.c_str(), O_RDONLY | O_CLOEXEC)).get());
  return is_zip(head) || is_gzip(head) || is_tar(head);
}

}  // namespace grader::intake
