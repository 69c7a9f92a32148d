// STAFF ONLY. Lists and reads a folder on disk, and follows no link.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "grader/course/input.h"
#include "grader/intake/archives/container.h"
#include "grader/intake/names/names.h"
#include "grader/sandbox/processes/descriptor.h"

namespace grader::inline intake {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
  return " (" + std::generic_category().message(error) + ")";
}

Entry described(const fs::path& file, std::string shown) {
  Entry entry;
  entry.path = shown;
  entry.shown = std::move(shown);
  std::error_code error;
  const fs::file_status status = fs::symlink_status(file, error);
  if (fs::is_symlink(status)) {
    entry.kind = Entry::Kind::symbolic_link;
  } else if (fs::is_directory(status)) {
    entry.kind = Entry::Kind::folder;
  } else if (fs::is_regular_file(status)) {
    const std::uintmax_t bytes = fs::file_size(file, error);
    entry.bytes = error ? 0 : bytes;
  } else {
    entry.kind = Entry::Kind::special;
  }
  return entry;
}

std::string read_file(const fs::path& file, const std::string& shown, std::size_t most) {
  // A pipe in place of a file would wait for a writer.
  const Descriptor in(open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  struct stat status {};
  if (!in || fstat(in.get(), &status) != 0) throw Refused(shown + " can't be read" + reason(errno) + ".");
  if (!S_ISREG(status.st_mode)) throw Refused(shown + " is not a file.");
  std::string bytes;
  char block[65536];
  for (;;) {
    const ssize_t size = read(in.get(), block, sizeof block);
    if (size == 0) return bytes;
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) throw Refused(shown + " can't be read" + reason(errno) + ".");
    bytes.append(block, static_cast<std::size_t>(size));
    if (bytes.size() > most) throw Refused(shown + " is larger than " + shown_size(most) + ".");
  }
}

class Folder : public Container {
 public:
  Folder(fs::path path, std::string shown, std::size_t most_entries)
      : path_(std::move(path)), shown_(std::move(shown)), most_entries_(most_entries) {}

  std::vector<Entry> list() override {                // sorts by path
    constexpr std::size_t kNone = std::string::npos;  // is the folder itself
    std::vector<Entry> entries;
    std::vector<std::size_t> waiting{kNone};
    while (!waiting.empty()) {
      const std::size_t at = waiting.back();
      const std::string folder = at == kNone ? "" : entries[at].path;
      waiting.pop_back();
      std::error_code error;
      for (fs::directory_iterator item(path_ / folder, error), end; !error && item != end;
           item.increment(error)) {
        if (entries.size() == most_entries_) {
          throw Refused(shown_ + " holds more than " + std::to_string(most_entries_) +
                        " files and folders. Hand in only the exercise files.");
        }
        const std::string name = item->path().filename().string();
        if (is_ignored(name)) continue;
        entries.push_back(described(item->path(), folder.empty() ? name : folder + "/" + name));
        if (entries.back().kind == Entry::Kind::folder) waiting.push_back(entries.size() - 1);
      }
      if (!error) continue;
      if (folder.empty()) throw Unreadable(shown_ + " can't be read" + reason(error.value()) + ".");
      entries[at].closed = true;
    }
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.path < b.path; });
    listed_.clear();
    for (const Entry& entry : entries) listed_.push_back(entry.path);
    return entries;
  }

  void visit(const std::vector<std::size_t>& indices,
             const std::function<void(std::size_t, const Read&)>& take) override {
    for (const std::size_t index : indices) {
      take(index, [&](std::size_t most) {
        return read_file(path_ / listed_.at(index), printable(listed_.at(index)), most);
      });
    }
  }

 private:
  fs::path path_;
  std::string shown_;
  std::size_t most_entries_;
  std::vector<std::string> listed_;
};

}  // namespace

std::unique_ptr<Container> open_folder(const fs::path& path, const std::string& shown,
                                       std::size_t most_entries) {
  return std::make_unique<Folder>(path, shown, most_entries);
}

}  // namespace grader::intake
