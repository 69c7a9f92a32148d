// STAFF ONLY. Archives: zip (read by its central directory, with any bytes before and behind it, data stored
// or deflated) and tar of any age, plain or in one layer of gzip, recognised by content. The limits bound the
// cost of reading, whatever sizes the archive claims.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <variant>

#include "grader/intake/archives/container.h"
#include "grader/sandbox/processes/descriptor.h"

namespace grader::inline intake {

struct ArchiveLimits {
  std::size_t unpacked_bytes;  // counts a tar's whole stream; of a zip, the entries that are read
  std::size_t entries;
  bool with_hidden = false;  // also files that is_ignored names
};

inline constexpr std::size_t kLongestPath = 4096;  // bytes of a path in an archive

// This is a file on disk, or an archive's bytes.
using ArchiveSource = std::variant<std::filesystem::path, std::string>;

// Opens a file; bytes become a file in memory. Throws Unreadable for a path that can't be opened.
Descriptor opened(const ArchiveSource& source, const std::string& shown);

class Archive : public Container {
 public:
  // `shown` is the archive's name in messages.
  Archive(Descriptor file, std::string shown, ArchiveLimits limits);
  Archive(const ArchiveSource& source, const std::string& shown, ArchiveLimits limits)
      : Archive(opened(source, shown), shown, limits) {}

  std::vector<Entry> list() override;
  void visit(const std::vector<std::size_t>& indices,
             const std::function<void(std::size_t index, const Read&)>& take) override;

 private:
  Descriptor file_;
  std::string shown_;
  ArchiveLimits limits_;
};

// Opens an archive. `open_here` reads it in this process, with all its rights, whatever its bytes do to the
// library; sandboxed_archive.h reads it in a sandbox.
using OpenArchive =
    std::function<std::unique_ptr<Container>(const ArchiveSource&, const std::string& shown, ArchiveLimits)>;
std::unique_ptr<Container> open_here(const ArchiveSource& source, const std::string& shown,
                                     ArchiveLimits limits);

// True if the file starts like a zip or a gzip, or is a tar.
bool has_archive_content(const std::filesystem::path& file);

}  // namespace grader::intake
