// STAFF ONLY.
#include "grader/compare/pairs.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "hair/io/files/bad_input.h"
#include "hair/io/files/printable.h"

namespace grader {
namespace {

namespace fs = std::filesystem;
using hair::BadInput;
using Names = std::set<std::string>;

std::string shown(const fs::path& path) {
  return hair::printable(path.string(), 4096);
}

enum class Kind { file, folder };

Kind kind_of(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return Kind::folder;
  if (fs::is_regular_file(status)) return Kind::file;
  const std::string why = fs::exists(status) ? "is neither a file nor a folder"
                          : error            ? error.message()
                                             : "is not there";
  throw BadInput(shown(path) + ": " + why + "; give two PNG pictures, or two folders of them");
}

Names pictures_in(const fs::path& folder) {
  Names names;
  std::error_code error;
  for (fs::directory_iterator item(folder, error), end; !error && item != end; item.increment(error)) {
    std::error_code unreadable;
    if (item->path().extension() == ".png" && item->is_regular_file(unreadable))
      names.insert(item->path().filename().string());
  }
  if (error)
    throw BadInput(shown(folder) + ": can't be read (" + error.message() + "); give a folder of pictures");
  if (names.empty()) throw BadInput(shown(folder) + ": holds no file *.png; give a folder of pictures");
  return names;
}

std::vector<std::string> without(const Names& names, const Names& others) {
  std::vector<std::string> rest;
  std::set_difference(names.begin(), names.end(), others.begin(), others.end(), std::back_inserter(rest));
  return rest;
}

}  // namespace

PicturePairs find_pairs(const fs::path& reference, const fs::path& test) {
  const Kind kind = kind_of(reference);
  if (kind_of(test) != kind) {
    const bool first = kind == Kind::folder;
    throw BadInput(shown(reference) + " is a " + (first ? "folder" : "file") + ", " + shown(test) + " is a " +
                   (first ? "file" : "folder") + "; give two PNG pictures, or two folders of them");
  }
  PicturePairs found;
  if (kind == Kind::file) {
    found.pairs.push_back({test.filename().string(), reference, test});
    return found;
  }
  const Names first = pictures_in(reference), second = pictures_in(test);
  found.only_in_reference = without(first, second);
  found.only_in_test = without(second, first);
  for (const std::string& name : first)
    if (second.contains(name)) found.pairs.push_back({name, reference / name, test / name});
  if (found.pairs.empty())
    throw BadInput(shown(reference) + " and " + shown(test) +
                   ": no picture of one has a name of the other's, " + "as " +
                   hair::printable(*first.begin()) + " and " + hair::printable(*second.begin()) +
                   "; pictures are matched by their names");
  return found;
}

}  // namespace grader
