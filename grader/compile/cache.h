// STAFF ONLY. Files that are kept between runs, in a folder that several graders may use at once: a file is
// written under another name first and read through one descriptor, so nobody reads half of it, and a file
// that is removed meanwhile is read to its end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace grader::inline compile {

// A class of 180 with 14 exercises leaves 0.9 GB, and precompiled headers 0.25.
inline constexpr std::uintmax_t kCacheBytes = 2'000'000'000;

// Copies a file into a cache that others may read at any time, first under another name. Ignores failures.
void keep_copy(const std::filesystem::path& file, const std::filesystem::path& kept);

// Marks a file of the cache as used.
void mark_as_used(const std::filesystem::path& kept);

// Removes the files directly in `folder` that were used the longest time ago, until the others have
// `most_bytes` at most. A student can make a large object with each letter that they change.
void shrink_cache(const std::filesystem::path& folder, std::uintmax_t most_bytes);

// Holds an object with the compiler's messages and CPU time: one file, so that all parts exist together.
struct KeptObject {
  std::string object, log;
  double cpu_seconds = 0;
};
std::optional<KeptObject> read_kept(const std::filesystem::path& kept);
std::string text_of(const KeptObject& kept);

}  // namespace grader::compile
