#include "hair/io/files/kept_file.h"

#include <cstdlib>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/digest.h"
#include "hair/io/files/read_file.h"
#include "hair/io/files/write_file.h"

namespace hair {

namespace {

constexpr std::size_t kLargestFile = 1 << 28, kDigest = 16;

std::filesystem::path file_of(const std::filesystem::path& folder, const KeptKind& kind,
                              std::string_view key) {
  return folder / (Digest().add(key).text() + std::string(kind.ending));
}

std::string head_of(const KeptKind& kind, std::string_view key) {
  return std::string(kind.says) + '\n' + std::string(key) + '\n';
}

}  // namespace

std::optional<std::string> find_kept(const std::filesystem::path& folder, const KeptKind& kind,
                                     std::string_view key) {
  std::string bytes;
  try {
    bytes = read_file(file_of(folder, kind, key), kLargestFile, "a file that was kept");
  } catch (const BadInput&) {
    return {};
  }
  const std::string head = head_of(kind, key);
  if (bytes.size() < head.size() + kDigest || !bytes.starts_with(head)) return {};
  const std::string digest = bytes.substr(bytes.size() - kDigest);
  bytes.resize(bytes.size() - kDigest);
  if (digest != Digest().add(std::string_view(bytes)).text()) return {};
  return bytes.substr(head.size());
}

void keep(const std::filesystem::path& folder, const KeptKind& kind, std::string_view key,
          std::string_view content) {
  std::string bytes = head_of(kind, key);
  bytes += content;
  bytes += Digest().add(std::string_view(bytes)).text();
  write_file(file_of(folder, kind, key), bytes);
}

std::optional<std::filesystem::path> cache_folder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::filesystem::path(value ? value : "");
  };
  if (const auto folder = variable("XDG_CACHE_HOME"); folder.is_absolute()) return folder / "hairlab";
  if (const auto home = variable("HOME"); home.is_absolute()) return home / ".cache" / "hairlab";
  return {};
}

}  // namespace hair
