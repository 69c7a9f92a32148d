// STAFF ONLY. What holds files: an archive or a folder. It is listed first and read later, so that what is
// read depends on the names alone. Nothing in it is trusted: not the sizes that it states, nor its paths, nor
// that it ends.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace grader {

// Why something can't be taken: a sentence for the student, without control characters.
class Refused : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Entry {
  enum class Kind { file, folder, symbolic_link, hard_link, special };

  std::string shown;  // the path as it is written there
  std::string path;   // folders and name with '/' between them, without ".", ".." and what leads to a root
  Kind kind = Kind::file;
  std::uintmax_t bytes = 0;    // as stated there
  bool leads_outside = false;  // absolute, or with ".." in it
  bool encrypted = false;
  bool closed = false;  // a folder that can't be listed
};

// `path` and `leads_outside` from `shown`. '\' separates, too: some Windows programs write it into archives.
Entry entry_at(std::string shown);

std::string_view name_of(const Entry& entry);  // the last part of its path

class Container {
 public:
  // The bytes of an entry. Throws Refused if it can't be read or is longer than `most` bytes; it never reads
  // much more.
  using Read = std::function<std::string(std::size_t most)>;

  virtual ~Container() = default;

  // In an order that depends on the container's contents alone. Throws Refused.
  virtual std::vector<Entry> list() = 0;

  // Calls `take` for entries of the list, named by their indices in ascending order. Throws Refused.
  virtual void visit(const std::vector<std::size_t>& indices,
                     const std::function<void(std::size_t index, const Read&)>& take) = 0;
};

// "256 MiB" (rounded down), "100 bytes".
std::string shown_size(std::uintmax_t bytes);

}  // namespace grader
