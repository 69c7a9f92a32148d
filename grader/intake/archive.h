// STAFF ONLY. Archives: zip (by its central directory) and tar, plain or in one layer of gzip. Told apart by
// content. Reading costs at most what the limits say, whatever sizes the archive states.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "grader/intake/container.h"

namespace grader {

struct ArchiveLimits {
  std::size_t unpacked_bytes;  // of a tar's whole stream; of a zip only what is read is unpacked
  std::size_t entries;
};

class Archive : public Container {
 public:
  // `shown` names it in sentences.
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

// Whether `name` ends as archives do, also those that can't be read here ("x.rar"): a student who hands in
// one gets told.
bool has_archive_ending(std::string_view name);
// `name` without such an ending.
std::string_view without_archive_ending(std::string_view name);
// Whether the file begins as a zip or a gzip does, or holds a tar.
bool has_archive_content(const std::filesystem::path& file);

}  // namespace grader
