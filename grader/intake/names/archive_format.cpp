// STAFF ONLY. Recognises formats by first bytes, and kinds by extensions.
#include "grader/intake/names/archive_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>
#include <string>

#include "grader/intake/names/exercise_names.h"

namespace grader::inline intake {
namespace {

constexpr std::array<std::string_view, 19> kArchives{
    ".tar.gz", ".tgz", ".zip", ".tar", ".tar.xz", ".txz", ".tar.bz2", ".tbz2", ".tar.zst", ".rar",
    ".7z",     ".gz",  ".xz",  ".bz2", ".zst",    ".lz",  ".lzma",    ".zipx", ".cab"};

// Text files are no documents: a README.txt or a grades.csv among a class's archives is no hand-in.
constexpr std::array<std::string_view, 8> kDocuments{".pdf", ".doc",   ".docx", ".odt",
                                                     ".rtf", ".pages", ".ppt",  ".pptx"};

std::size_t ending_length(std::string_view name, std::span<const std::string_view> endings) {
  const std::string lower = in_lower_case(name);
  const auto found = std::ranges::find_if(endings, [&](auto ending) { return lower.ends_with(ending); });
  return found == endings.end() ? 0 : found->size();
}

}  // namespace

// "PK00" and "PK\7\8" begin a zip that could have been split, and was not (APPNOTE.TXT 8.5.4).
bool is_zip(std::string_view head) {
  if (head.starts_with("PK00") || head.starts_with("PK\x07\x08")) head.remove_prefix(4);
  return head.starts_with("PK\x03\x04") || head.starts_with("PK\x05\x06");
}

bool is_gzip(std::string_view head) {
  return head.starts_with("\x1f\x8b");
}

bool is_tar(std::string_view head) {
  constexpr std::size_t kSum = 148, kSumSize = 8;
  if (head.size() != kHeadBytes) return false;
  if (head.substr(257, 5) == "ustar") return true;
  // Older tars have only the sum of the header's bytes, with blanks in place of the sum itself. Some programs
  // added the bytes as signed numbers.
  const std::size_t digits = std::min(head.find_first_not_of(' ', kSum), kSum + kSumSize);
  unsigned stated = 0, sum = kSumSize * ' ';
  std::from_chars(head.data() + digits, head.data() + kSum + kSumSize, stated, 8);
  for (std::size_t i = 0; i < head.size(); ++i)
    if (i < kSum || i >= kSum + kSumSize) sum += static_cast<unsigned char>(head[i]);
  const auto negative =
      static_cast<unsigned>(std::ranges::count_if(head, [](char c) { return (c & 0x80) != 0; }));
  return stated == sum || stated == sum - 256 * negative;
}

std::string_view foreign_format(std::string_view head) {
  if (head.starts_with("Rar!")) return "a RAR archive";
  if (head.starts_with("7z\xbc\xaf\x27\x1c")) return "a 7z archive";
  if (head.starts_with("\xfd"
                       "7zXZ"))
    return "packed with xz";
  if (head.starts_with("BZh")) return "packed with bzip2";
  if (head.starts_with("\x28\xb5\x2f\xfd")) return "packed with zstd";
  if (head.starts_with("%PDF")) return "a PDF document";
  if (head.empty()) return "empty";
  return {};
}

bool has_archive_ending(std::string_view name) {
  return ending_length(name, kArchives) > 0;
}

std::string_view without_archive_ending(std::string_view name) {
  const std::size_t archive = ending_length(name, kArchives);
  return name.substr(0, name.size() - (archive > 0 ? archive : ending_length(name, kDocuments)));
}

bool has_document_ending(std::string_view name) {
  return ending_length(name, kDocuments) > 0;
}

}  // namespace grader::intake
