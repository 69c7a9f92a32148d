// STAFF ONLY.
#include "grader/intake/layout.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "grader/intake/archive_format.h"

namespace grader {
namespace {

std::string_view parent_of(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
}

std::string_view without_folders(std::string_view path) {
  return path.substr(path.rfind('/') + 1);
}

bool lies_in(std::string_view path, std::string_view folder) {
  return folder.empty() || path == folder || (path.starts_with(folder) && path[folder.size()] == '/');
}

// The first part of `path` below `folder`, with `folder` before it.
std::string_view child_of(std::string_view folder, std::string_view path) {
  return path.substr(0, path.find('/', folder.empty() ? 0 : folder.size() + 1));
}

bool is_exercise_file(const Entry& entry, const FileNames& exercise_files) {
  return entry.kind != Entry::Kind::folder && exercise_files.count(name_of(entry)) > 0;
}

bool is_archive(const Entry& entry) {
  return entry.kind != Entry::Kind::folder && has_archive_ending(name_of(entry));
}

bool is_canvas_file(const Entry& entry, const FileNames& exercise_files) {
  return entry.kind != Entry::Kind::folder &&
         canvas_exercise_file(name_of(entry), exercise_files).has_value();
}

// What one argument holds, while its layout is found.
class Finder {
 public:
  Finder(const std::vector<Entry>& entries, const FileNames& exercise_files)
      : entries_(entries), exercise_files_(exercise_files) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      if (is_ignored(entries[i].path)) continue;
      counted_.push_back(i);
      const Entry& entry = entries[i];
      if (is_exercise_file(entry, exercise_files) || is_archive(entry) ||
          is_canvas_file(entry, exercise_files))
        items_.push_back(&entry);
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
      if (bare && is_canvas_file(*item, exercise_files_)) return true;
      if (!bare || is_archive(*item)) holding.insert(child_of(root_, item->path));
    }
    const bool lone_archive = items_.size() == 1 && root_.empty() && is_archive(*items_.front()) &&
                              parent_of(items_.front()->path).empty();
    return holding.size() > 1 || (on_disk && lone_archive);
  }

  void divide(Layout& layout) const;

 private:
  bool is_project() const;
  bool from_canvas() const;
  std::string in_root(const std::string& name) const {
    return root_.empty() ? name : std::string(root_) + "/" + name;
  }

  const std::vector<Entry>& entries_;
  const FileNames& exercise_files_;
  std::vector<std::size_t> counted_;
  std::vector<const Entry*> items_;
  std::string_view root_;
};

bool Finder::is_project() const {
  constexpr std::array<std::string_view, 4> given{"solver", "particles", "hair", "student"};
  std::set<std::string_view> around;  // folders with a CMakeLists.txt that the root is or lies in
  for (const std::size_t i : counted_) {
    if (name_of(entries_[i]) == "CMakeLists.txt" && lies_in(root_, parent_of(entries_[i].path)))
      around.insert(parent_of(entries_[i].path));
  }
  return std::any_of(around.begin(), around.end(), [&](std::string_view folder) {
    return std::any_of(counted_.begin(), counted_.end(), [&](std::size_t i) {
      const Entry& entry = entries_[i];
      if (entry.path == folder || !lies_in(entry.path, folder)) return false;
      const std::string_view child = child_of(folder, entry.path);
      if (child == entry.path && entry.kind != Entry::Kind::folder) return false;
      const std::string_view name = folder.empty() ? child : child.substr(folder.size() + 1);
      return std::find(given.begin(), given.end(), name) != given.end();
    });
  });
}

// Then a file in the root that Canvas named for a student is that student's, whatever it is.
bool Finder::from_canvas() const {
  return std::any_of(items_.begin(), items_.end(), [&](const Entry* item) {
    return parent_of(item->path) == root_ && canvas_name(name_of(*item), exercise_files_);
  });
}

void Finder::divide(Layout& layout) const {
  const bool canvas = from_canvas();
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
      std::string_view around = parent_of(root_);
      while (!lies_in(entry.path, around)) around = parent_of(around);
      strays.emplace(child_of(around, entry.path));
      continue;
    }
    const std::string child(child_of(root_, entry.path));
    const std::string_view name = name_of(entry);
    if (child != entry.path || entry.kind == Entry::Kind::folder) {
      add(child, Member::Kind::folder, i);
    } else if (is_archive(entry)) {
      add(child, Member::Kind::archive, i);
    } else if (const auto found = canvas_name(name, exercise_files_); found && canvas) {
      add(in_root(found->student), Member::Kind::canvas, i);
    } else if (has_document_ending(name)) {
      add(child, Member::Kind::document, i);
    } else {
      strays.insert(child);
    }
  }
  layout.members.clear();
  for (auto& [key, member] : members) {
    if (const auto name = canvas_name(without_folders(member.path), exercise_files_);
        name && member.kind == Member::Kind::archive) {
      const std::string files = in_root(name->student);
      if (members.count({files, Member::Kind::canvas}) > 0)
        layout.of_one_student.emplace_back(files, member.path);
    }
    layout.members.push_back(member);
  }
  layout.strays.assign(strays.begin(), strays.end());
}

}  // namespace

bool is_ignored(std::string_view path) {
  while (!path.empty()) {
    const std::string_view part = path.substr(0, path.find('/'));
    if (part == "__MACOSX" || part == "Thumbs.db" || part == "desktop.ini" || part.starts_with('.'))
      return true;
    path.remove_prefix(std::min(part.size() + 1, path.size()));
  }
  return false;
}

Layout layout_of(const std::vector<Entry>& entries, const FileNames& exercise_files, bool on_disk) {
  const Finder finder(entries, exercise_files);
  Layout layout;
  layout.members = {finder.whole()};
  layout.found = finder.found();
  layout.is_class = layout.found && finder.is_class(on_disk);
  if (layout.is_class) finder.divide(layout);
  return layout;
}

Takings takings_of(const std::vector<Entry>& list, const Member& member, const FileNames& exercise_files) {
  Takings takings;
  std::map<std::string, int> latest;
  const bool canvas = member.kind == Member::Kind::canvas;
  if (canvas) {
    for (const std::size_t i : member.entries) {
      const auto found = canvas_exercise_file(name_of(list[i]), exercise_files);
      if (found) latest[found->file] = std::max(latest[found->file], found->version);
    }
  }
  for (const std::size_t i : member.entries) {
    if (const auto found = canvas_exercise_file(name_of(list[i]), exercise_files); canvas && found) {
      if (found->version == latest.at(found->file))
        takings.files.push_back({i, found->file});
      else
        takings.outdated.push_back(i);
    } else if (is_exercise_file(list[i], exercise_files)) {
      takings.files.push_back({i, std::string(name_of(list[i]))});
    } else if (is_archive(list[i])) {
      takings.archives.push_back(i);
    }
  }
  if (!takings.files.empty()) takings.left_shut.swap(takings.archives);
  return takings;
}

}  // namespace grader
