// STAFF ONLY. Keeps files, marks used ones, and removes the others.
#include "grader/compile/cache.h"

#include <fcntl.h>
#include <stdlib.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "grader/sandbox/processes/descriptor.h"
#include "hair/io/files/read_file.h"

namespace grader::inline compile {

namespace fs = std::filesystem;

void keep_copy(const fs::path& file, const fs::path& kept) {
  std::error_code error;
  std::string temporary = (kept.parent_path() / "new-XXXXXX").string();
  const Descriptor reserved(mkostemp(temporary.data(), O_CLOEXEC));
  if (!reserved) return;
  if (fs::copy_file(file, temporary, fs::copy_options::overwrite_existing, error))
    fs::rename(temporary, kept, error);
  if (error) fs::remove(temporary, error);
}

void mark_as_used(const fs::path& kept) {
  std::error_code ignored;
  fs::last_write_time(kept, fs::file_time_type::clock::now(), ignored);
}

void shrink_cache(const fs::path& folder, std::uintmax_t most_bytes) {
  struct File {
    fs::file_time_type used;
    std::uintmax_t bytes;
    fs::path path;
  };
  std::vector<File> files;
  std::uintmax_t all = 0;
  std::error_code gone;  // another grader may remove files, too
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, gone)) {
    if (!entry.is_regular_file(gone)) continue;
    const File file{entry.last_write_time(gone), entry.file_size(gone), entry.path()};
    if (gone) continue;
    files.push_back(file);
    all += file.bytes;
  }
  if (all <= most_bytes) return;
  std::ranges::sort(files, {}, &File::used);
  for (const File& file : files) {
    if (all <= most_bytes) return;
    fs::remove(file.path, gone);
    all -= file.bytes;
  }
}

// Writes the number of the log's bytes, the CPU time in ms, a line feed, the log, the object.
std::string text_of(const KeptObject& kept) {
  return std::to_string(kept.log.size()) + " " + std::to_string(std::lround(1000 * kept.cpu_seconds)) + "\n" +
         kept.log + kept.object;
}

std::optional<KeptObject> read_kept(const fs::path& kept) {
  const std::string text = hair::bytes_of(kept);
  std::size_t log = 0;
  long milliseconds = 0;
  const char* const end = text.data() + text.size();
  const auto [blank, wrong] = std::from_chars(text.data(), end, log);
  if (wrong != std::errc() || blank == end || *blank != ' ') return {};
  const auto [feed, other] = std::from_chars(blank + 1, end, milliseconds);
  if (other != std::errc() || feed == end || *feed != '\n') return {};
  const auto line = static_cast<std::size_t>(feed - text.data());
  if (log > text.size() - line - 1) return {};
  return KeptObject{text.substr(line + 1 + log), text.substr(line + 1, log),
                    1e-3 * static_cast<double>(milliseconds)};
}

}  // namespace grader::compile
