// STAFF ONLY. Writes archives by libarchive.
#include "grader/archive/archive_writer.h"

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <stdexcept>

namespace grader::inline packing {
namespace {

constexpr std::size_t zero_block = std::size_t{16} << 20;

struct Free {
  void operator()(archive* a) const { archive_write_free(a); }
  void operator()(archive_entry* entry) const { archive_entry_free(entry); }
};
using Writer = std::unique_ptr<archive, Free>;
using Entry = std::unique_ptr<archive_entry, Free>;

void check(archive* a, la_int64_t result) {
  if (result < ARCHIVE_OK) throw std::runtime_error(archive_error_string(a));
}

const std::string& zeros() {
  static const std::string block(zero_block, '\0');
  return block;
}

Entry header_of(const ArchiveEntry& from, std::time_t date) {
  Entry entry(archive_entry_new());
  archive_entry_set_pathname(entry.get(), from.path.c_str());
  archive_entry_set_mtime(entry.get(), date, 0);
  archive_entry_set_perm(entry.get(), static_cast<mode_t>(from.mode));
  if (from.link.empty()) {
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(from.bytes.size() + from.zeros));
  } else {
    archive_entry_set_filetype(entry.get(), AE_IFLNK);
    archive_entry_set_symlink(entry.get(), from.link.c_str());
    archive_entry_set_size(entry.get(), 0);
  }
  return entry;
}

void write_entries(archive* a, const std::vector<ArchiveEntry>& entries, std::time_t date = kArchiveDate) {
  for (const ArchiveEntry& entry : entries) {
    check(a, archive_write_header(a, header_of(entry, date).get()));
    if (!entry.bytes.empty()) check(a, archive_write_data(a, entry.bytes.data(), entry.bytes.size()));
    for (std::uint64_t left = entry.zeros; left > 0;) {
      const std::size_t count = std::min<std::uint64_t>(left, zero_block);
      check(a, archive_write_data(a, zeros().data(), count));
      left -= count;
    }
  }
  check(a, archive_write_close(a));
}

// Makes a gzip member of its own; members in a row decompress to their contents in a row.
std::string gzip(const std::string& bytes) {
  std::string member(bytes.size() + bytes.size() / 1000 + 1024, '\0');
  std::size_t used = 0;
  Writer a(archive_write_new());
  check(a.get(), archive_write_set_format_raw(a.get()));
  check(a.get(), archive_write_add_filter_gzip(a.get()));
  check(a.get(), archive_write_set_options(a.get(), "gzip:!timestamp,gzip:compression-level=9"));
  check(a.get(), archive_write_set_bytes_in_last_block(a.get(), 1));
  check(a.get(), archive_write_open_memory(a.get(), member.data(), member.size(), &used));
  write_entries(a.get(), {{"member", bytes, "", 0}});
  member.resize(used);
  return member;
}

// Collects the tar stream in members. Whole blocks of zeros come by address: nothing is copied or compressed
// twice.
struct TarGz {
  std::ofstream out;
  std::string pending, zero_member;

  void take(const char* data, std::size_t size) {
    if (data != zeros().data() || size != zero_block) {
      pending.append(data, size);
      return;
    }
    flush();
    if (zero_member.empty()) zero_member = gzip(zeros());
    out << zero_member;
  }

  void flush() {
    if (!pending.empty()) out << gzip(pending);
    pending.clear();
  }
};

}  // namespace

void write_zip(const std::filesystem::path& file, const std::vector<ArchiveEntry>& entries) {
  try {
    Writer a(archive_write_new());
    check(a.get(), archive_write_set_format_zip(a.get()));
    check(a.get(), archive_write_open_filename(a.get(), file.c_str()));
    write_entries(a.get(), entries);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file.string() + ": can't be written: " + error.what());
  }
}

void write_tar_gz(const std::filesystem::path& file, const std::vector<ArchiveEntry>& entries,
                  std::time_t date) {
  TarGz tar_gz{std::ofstream(file, std::ios::binary), "", ""};
  const auto take = [](archive*, void* to, const void* data, std::size_t size) {
    static_cast<TarGz*>(to)->take(static_cast<const char*>(data), size);
    return static_cast<la_ssize_t>(size);
  };
  try {
    Writer a(archive_write_new());
    check(a.get(), archive_write_set_format_gnutar(a.get()));
    check(a.get(), archive_write_set_bytes_per_block(a.get(), 0));
    check(a.get(), archive_write_open(a.get(), &tar_gz, nullptr, take, nullptr));
    write_entries(a.get(), entries, date);
    tar_gz.flush();
    tar_gz.out.close();
    if (!tar_gz.out) throw std::runtime_error("no space, or no permission");
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file.string() + ": can't be written: " + error.what());
  }
}

}  // namespace grader::packing
