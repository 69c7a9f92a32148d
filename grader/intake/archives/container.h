// STAFF ONLY. A container of files: an archive or a folder. It is listed first and read later, so that names
// alone decide which files are read. The container is untrusted: its sizes, its paths and its length may be
// wrong or infinite.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace grader::inline intake {

// The reason for a rejection: a sentence for the student, without control characters.
class Refused : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Rejects content that can't be read in its format. The whole submission then gets a status of its own.
class Unreadable : public Refused {
 public:
  // `failure` is a sentence for staff if our reader failed because of it, or empty.
  explicit Unreadable(const std::string& why, std::string failure = {})
      : Refused(why), failure_(std::move(failure)) {}
  const std::string& failure() const { return failure_; }

 private:
  std::string failure_;
};

struct Entry {
  enum class Kind { file, folder, symbolic_link, hard_link, special };

  std::string shown;  // is the path as the container states it
  std::string path;   // has folders and name separated by '/', without ".", ".." and a root
  Kind kind = Kind::file;
  std::uintmax_t bytes = 0;    // as the container states it
  bool leads_outside = false;  // has ".." behind a folder
  bool lost_root = false;      // began at a root ("/", "C:\\") or with "..", which is removed
  bool replaced = false;       // a later entry with this path replaces it
  bool encrypted = false;
  bool closed = false;  // is a folder that can't be listed
};

// Derives `path`, `leads_outside` and `lost_root` from `shown`. '\' also separates, because some Windows
// programs write it. A root is removed with the folder of all users in it: "C:\Users\bob\x" is "bob/x".
Entry entry_at(std::string shown);

// Makes names readable: decoded and composed; a nameless entry becomes "entry 17".
// "name-1a2b3c4d" replaces a part of more than 255 bytes or with more than 30 marks in a row. Marks replaced
// entries. Returns a line for each name that was guessed, refused or left out; each begins with `shown`.
std::vector<std::string> settle_names(std::vector<Entry>& list, const std::string& shown);

std::string_view name_of(const Entry& entry);  // returns the last part of its path

class Container {
 public:
  // Returns the bytes of an entry. Throws Refused if it can't be read or is longer than `most` bytes; it
  // never reads much more than that.
  using Read = std::function<std::string(std::size_t most)>;

  virtual ~Container() = default;

  // The order depends only on the container's contents. Throws Refused.
  virtual std::vector<Entry> list() = 0;

  // Calls `take` for the listed entries with these indices, which are in ascending order. Throws Refused.
  virtual void visit(const std::vector<std::size_t>& indices,
                     const std::function<void(std::size_t index, const Read&)>& take) = 0;
};

// Opens a folder on disk. Links are listed as links and never followed. Names that is_ignored (names.h) names
// are not listed.
std::unique_ptr<Container> open_folder(const std::filesystem::path& path, const std::string& shown,
                                       std::size_t most_entries);

// Returns "256 MiB" (rounded down), "100 bytes".
std::string shown_size(std::uintmax_t bytes);

}  // namespace grader::intake
