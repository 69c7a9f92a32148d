// STAFF ONLY. Makes archives for tests in memory, entry by entry, including archives that no normal program
// makes.
#pragma once

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace grader::inline intake {

enum class Packing { zip, tar, tar_gz, v7, v7_gz, gz };  // gz: one file without a tar

class ArchiveBuilder {
 public:
  explicit ArchiveBuilder(Packing packing, const char* options = nullptr) : handle_(archive_write_new()) {
    check(packing == Packing::zip  ? archive_write_set_format_zip(handle_)
          : packing == Packing::gz ? archive_write_set_format_raw(handle_)
          : packing == Packing::v7 || packing == Packing::v7_gz
              ? archive_write_set_format_v7tar(handle_)
              : archive_write_set_format_pax_restricted(handle_));
    if (packing == Packing::tar_gz || packing == Packing::v7_gz || packing == Packing::gz)
      check(archive_write_add_filter_gzip(handle_));
    if (options) check(archive_write_set_options(handle_, options));
    check(archive_write_set_passphrase(handle_, "secret"));
    check(archive_write_set_bytes_in_last_block(handle_, 1));
    check(archive_write_open(handle_, this, nullptr, &ArchiveBuilder::append, nullptr));
  }
  ~ArchiveBuilder() { archive_write_free(handle_); }
  ArchiveBuilder(const ArchiveBuilder&) = delete;
  ArchiveBuilder& operator=(const ArchiveBuilder&) = delete;

  ArchiveBuilder& file(const std::string& path, const std::string& text = "int x;\n") {
    begin(path, AE_IFREG, text.size());
    if (archive_write_data(handle_, text.data(), text.size()) < 0) fail();
    return *this;
  }
  ArchiveBuilder& zeros(const std::string& path, std::size_t bytes) {
    const std::string block(std::size_t{1} << 20, '\0');
    begin(path, AE_IFREG, bytes);
    for (std::size_t left = bytes; left > 0; left -= std::min(left, block.size())) {
      if (archive_write_data(handle_, block.data(), std::min(left, block.size())) < 0) fail();
    }
    return *this;
  }
  ArchiveBuilder& folder(const std::string& path) { return begin(path, AE_IFDIR, 0); }
  ArchiveBuilder& special(const std::string& path, unsigned type) { return begin(path, type, 0); }
  ArchiveBuilder& symbolic_link(const std::string& path, const std::string& target) {
    return begin(path, AE_IFLNK, 0, &archive_entry_set_symlink, target.c_str());
  }
  ArchiveBuilder& hard_link(const std::string& path, const std::string& target) {
    return begin(path, AE_IFREG, 0, &archive_entry_set_hardlink, target.c_str());
  }

  std::string bytes() {
    check(archive_write_close(handle_));
    return bytes_;
  }

 private:
  ArchiveBuilder& begin(const std::string& path, unsigned type, std::size_t bytes,
                        void (*set_target)(archive_entry*, const char*) = nullptr,
                        const char* target = nullptr) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, path.c_str());
    archive_entry_set_filetype(entry, type);
    archive_entry_set_perm(entry, 0644);
    archive_entry_set_size(entry, static_cast<la_int64_t>(bytes));
    if (set_target) set_target(entry, target);
    const int result = archive_write_header(handle_, entry);
    archive_entry_free(entry);
    check(result);
    return *this;
  }
  static la_ssize_t append(archive*, void* self, const void* bytes, std::size_t size) {
    static_cast<ArchiveBuilder*>(self)->bytes_.append(static_cast<const char*>(bytes), size);
    return static_cast<la_ssize_t>(size);
  }
  void check(int result) const {
    if (result < ARCHIVE_WARN) fail();
  }
  [[noreturn]] void fail() const { throw std::runtime_error(archive_error_string(handle_)); }

  archive* handle_;
  std::string bytes_;
};

inline std::string gzip(const std::string& bytes) {
  return ArchiveBuilder(Packing::gz).file("x", bytes).bytes();
}

// Makes a zip whose entries and directory state offsets that count the bytes `before` the first entry.
inline std::string counted_behind(const std::string& before, std::string zip) {
  const auto add = [&](std::size_t at) {
    std::uint32_t offset = 0;
    std::memcpy(&offset, zip.data() + at, sizeof offset);
    offset += static_cast<std::uint32_t>(before.size());
    std::memcpy(zip.data() + at, &offset, sizeof offset);
  };
  for (std::size_t at = 0; (at = zip.find("PK\x01\x02", at)) != std::string::npos; ++at) add(at + 42);
  add(zip.rfind("PK\x05\x06") + 16);
  return before + zip;
}

inline std::string with_comment(std::string zip, const std::string& comment) {
  zip.at(zip.size() - 2) = static_cast<char>(comment.size() & 255);
  zip.at(zip.size() - 1) = static_cast<char>(comment.size() >> 8);
  return zip + comment;
}

// Returns one zip in the forms that other programs write and open. Comments have `length` bytes.
inline std::map<std::string, std::string> forms_of(const std::string& zip, std::size_t length = 65535) {
  const std::string longest(length, 'c'), zeros(length, '\0'), stub = "#!/bin/sh\nexec unzip $0\n";
  return {{"none", zip},
          {"a comment", with_comment(zip, longest)},
          {"a comment with the mark of an end", with_comment(zip, "PK\x05\x06" + std::string(100, 'P'))},
          {"a zip as a comment", with_comment(zip, zip)},
          {"another zip before it", ArchiveBuilder(Packing::zip).file("old.cpp").bytes() + zip},
          {"bytes behind the end", zip + zeros},
          {"a comment, and bytes behind it", with_comment(zip, longest) + zeros},
          {"PK00", "PK00" + zip},
          {"PK00, counted", counted_behind("PK00", zip)},
          {"PK78, counted", counted_behind("PK\x07\x08", zip)},
          {"a stub", stub + zip},
          {"a long stub", "MZ" + zeros + zeros + zip},
          {"a stub, counted", counted_behind(stub, zip)},
          {"all of it", "MZ" + zeros + with_comment(zip, longest) + zeros}};
}

// Makes a zip of one file "a.cpp" with these packed data. The methods of zip are (APPNOTE.TXT, 4.4.5): 8
// deflate, 12 bzip2, 14 LZMA, 93 Zstandard, 95 xz, 98 PPMd.
inline std::string zip_of_method(int method, const std::string& data) {
  std::string zip = ArchiveBuilder(Packing::zip, "zip:compression=store").file("a.cpp", data).bytes();
  zip.at(8) = static_cast<char>(method);
  zip.at(zip.find("PK\x01\x02") + 10) = static_cast<char>(method);
  return zip;
}

}  // namespace grader::intake
