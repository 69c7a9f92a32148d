// STAFF ONLY. One submission, or a class of folders and archives.
#include "grader/intake/layouts/folders.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "grader/intake/names/archive_format.h"
#include "grader/intake/names/names.h"
#include "grader/intake/names/same_name.h"

namespace grader::inline intake {
namespace {

std::string_view parent_of(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

bool lies_in(std::string_view path, std::string_view folder) {
  return folder.empty() || path == folder || (path.starts_with(folder) && path[folder.size()] == '/');
}

std::size_t shared_length(std::string_view a, std::string_view b) {
  return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

// Returns the first part of `path` below `folder`, with `folder` before it.
std::string_view child_of(std::string_view folder, std::string_view path) {
  return path.substr(0, path.find('/', folder.empty() ? 0 : folder.size() + 1));
}

bool is_exercise_file(const Entry& entry, const FileNames& exercise_files) {
  if (entry.kind == Entry::Kind::folder) return false;
  const auto likeness = exercise_file(name_of(entry), exercise_files);
  return likeness && likeness->degree != Likeness::Degree::like;
}

bool is_archive(const Entry& entry) {
  return entry.kind != Entry::Kind::folder && has_archive_ending(name_of(entry));
}

// Returns the folder that "hw - Copy", "hw (1)" or "hw 2" copies.
std::string_view copied(std::string_view name) {
  static constexpr std::array<std::string_view, 4> kCopies{" - Copy", " copy", " - Kopie", "_copy"};
  std::string_view rest = name;
  if (const Numbered copy = without_number(rest); copy.bracket && rest[copy.name.size()] == ' ')
    rest = copy.name;
  for (const std::string_view copy : kCopies)
    if (rest.ends_with(copy)) rest.remove_suffix(copy.size());
  return rest;
}

// Finds the layout of one argument's entries.
class Finder {
 public:
  Finder(const std::vector<Entry>& entries, const FileNames& exercise_files) : entries_(entries) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (is_ignored(entries[i].path)) continue;
      counted_.push_back(i);
      const Entry& entry = entries[i];
      if (is_exercise_file(entry, exercise_files) || is_archive(entry)) items_.push_back(&entry);
    }
    if (!items_.empty()) root_ = parent_of(items_.front()->path);
    for (const Entry* item : items_) {
      while (!lies_in(parent_of(item->path), root_)) root_ = parent_of(root_);
    }
  }

  bool found() const { return !items_.empty(); }
  Member whole() const { return {"", Member::Kind::whole, counted_}; }

  bool is_class(bool on_disk) const {
    if (is_project()) return false;
    std::set<std::string_view> holding;
    for (const Entry* item : items_) {
      const bool bare = parent_of(item->path) == root_;
      const std::string_view child = child_of(root_, item->path);
      if (bare ? is_archive(*item) : !is_build(child.substr(child.rfind('/') + 1)))
        holding.insert(copied(child));
    }
    const bool lone_archive = items_.size() == 1 && root_.empty() && is_archive(*items_.front()) &&
                              parent_of(items_.front()->path).empty();
    return holding.size() > 1 || (on_disk && lone_archive);
  }

  void divide(Layout& layout) const;

 private:
  bool is_project() const;

  const std::vector<Entry>& entries_;
  std::vector<std::size_t> counted_;
  std::vector<const Entry*> items_;
  std::string_view root_;
};

bool Finder::is_project() const {
  constexpr std::array<std::string_view, 4> given{"solver", "particles", "hair", "student"};
  // Lists folders with a CMakeLists.txt at or around the root, by the length of their paths.
  std::set<std::size_t> around;
  for (const std::size_t i : counted_) {
    if (name_of(entries_[i]) == "CMakeLists.txt" && lies_in(root_, parent_of(entries_[i].path)))
      around.insert(parent_of(entries_[i].path).size());
  }
  return std::any_of(counted_.begin(), counted_.end(), [&](std::size_t i) {
    const std::string_view path = entries_[i].path;
    const std::size_t shared = shared_length(path, root_);
    for (const std::size_t size : around) {
      if (size > shared || size == path.size()) return false;
      if (size > 0 && path[size] != '/') continue;
      const std::string_view child = child_of(path.substr(0, size), path);
      if (child == path && entries_[i].kind != Entry::Kind::folder) continue;
      if (std::ranges::find(given, child.substr(size > 0 ? size + 1 : 0)) != given.end()) return true;
    }
    return false;
  });
}

void Finder::divide(Layout& layout) const {
  std::map<std::pair<std::string, Member::Kind>, Member> members;
  std::set<std::string> strays;
  auto add = [&](const std::string& path, Member::Kind kind, std::size_t entry) {
    Member& member = members[{path, kind}];
    member.path = path;
    member.kind = kind;
    member.entries.push_back(entry);
  };
  for (const std::size_t i : counted_) {
    const Entry& entry = entries_[i];
    if (lies_in(root_, entry.path)) continue;  // the root, or a folder around it
    if (!lies_in(entry.path, root_)) {
      strays.emplace(entry.path.substr(0, entry.path.find('/', shared_length(entry.path, root_))));
      continue;
    }
    const std::string child(child_of(root_, entry.path));
    const std::string_view name = name_of(entry);
    if (child != entry.path || entry.kind == Entry::Kind::folder) {
      add(child, Member::Kind::folder, i);
    } else if (is_archive(entry)) {
      add(child, Member::Kind::archive, i);
    } else if (has_document_ending(name)) {
      add(child, Member::Kind::document, i);
    } else {
      strays.insert(child);
    }
  }
  layout.members.clear();
  for (auto& [key, member] : members) layout.members.push_back(member);
  layout.strays.assign(strays.begin(), strays.end());
}

}  // namespace

Layout layout_of(const std::vector<Entry>& entries, const FileNames& exercise_files, bool on_disk) {
  const Finder finder(entries, exercise_files);
  Layout layout;
  layout.members = {finder.whole()};
  layout.found = finder.found();
  layout.is_class = layout.found && finder.is_class(on_disk);
  if (layout.is_class) finder.divide(layout);
  return layout;
}

}  // namespace grader::intake
