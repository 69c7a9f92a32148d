// STAFF ONLY. Archives: zip (by its central directory, data stored or deflated) and tar, plain or in one layer
// of gzip, recognised by content. The limits bound the cost of reading, whatever sizes the archive claims.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "grader/intake/container.h"

namespace grader {

struct ArchiveLimits {
  std::size_t unpacked_bytes;  // of a tar's whole stream; of a zip, only of the entries that are read
  std::size_t entries;
};

class Archive : public Container {
 public:
  // `shown` is its name in messages.
  Archive(std::filesystem::path file, std::string shown, ArchiveLimits limits);
  Archive(std::string bytes, std::string shown, ArchiveLimits limits);

  std::vector<Entry> list() override;
  void visit(const std::vector<std::size_t>& indices,
             const std::function<void(std::size_t index, const Read&)>& take) override;

 private:
  std::variant<std::filesystem::path, std::string> source_;  // a file, or an archive's bytes
  std::string shown_;
  ArchiveLimits limits_;
};

// Whether `name` has an archive's extension, including archives that can't be read here ("x.rar"), so that a
// student who hands one in gets a message.
bool has_archive_ending(std::string_view name);
// `name` without such an extension.
std::string_view without_archive_ending(std::string_view name);
// Whether the file starts like a zip or a gzip, or is a tar.
bool has_archive_content(const std::filesystem::path& file);

}  // namespace grader
