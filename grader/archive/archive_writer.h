// STAFF ONLY. Writes archives of the handout, of students or of attackers: any path, links, files larger than
// any disk. The same entries give the same bytes, if the time zone is UTC and the locale's encoding UTF-8.
#pragma once

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

namespace grader::inline packing {

struct ArchiveEntry {
  std::string path;
  std::string bytes;        // are a file's content
  std::string link;         // not empty: a symbolic link with this target
  std::uint64_t zeros = 0;  // this many zero bytes follow `bytes`
  unsigned mode = 0644;     // are the file's rights
};

inline constexpr std::time_t kArchiveDate = 946684800;  // dates all files: 2000-01-01 00:00 UTC

// Both throw std::runtime_error with the path and the reason.
void write_zip(const std::filesystem::path& file, const std::vector<ArchiveEntry>& entries);

// A long run of zeros becomes identical gzip members, so that 10 GB of zeros take no longer than writing 10
// MB.
void write_tar_gz(const std::filesystem::path& file, const std::vector<ArchiveEntry>& entries,
                  std::time_t date = kArchiveDate);

}  // namespace grader::packing
