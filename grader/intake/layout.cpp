// STAFF ONLY.
#include "grader/intake/layout.h"

#include <algorithm>
#include <map>

#include "grader/intake/archive.h"

namespace grader {
namespace {

std::string_view parent_of(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : path.substr(0, slash);
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

}  // namespace

bool is_ignored(std::string_view path) {
  while (!path.empty()) {
    const std::string_view part = path.substr(0, path.find('/'));
    if (part == "__MACOSX" || part.starts_with('.')) return true;
    path.remove_prefix(std::min(part.size() + 1, path.size()));
  }
  return false;
}

Layout layout_of(const std::vector<Entry>& entries, const FileNames& exercise_files, bool on_disk) {
  Layout layout;
  std::vector<std::size_t> all;
  std::vector<const Entry*> things;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (is_ignored(entries[i].path)) continue;
    all.push_back(i);
    if (is_exercise_file(entries[i], exercise_files) || is_archive(entries[i])) things.push_back(&entries[i]);
  }
  layout.members = {{"", false, all}};
  layout.found = !things.empty();
  if (!layout.found) return layout;

  std::string_view root = parent_of(things.front()->path);
  for (const Entry* thing : things) {
    while (!lies_in(parent_of(thing->path), root)) root = parent_of(root);
  }
  std::set<std::string_view> holding;
  bool project = false;
  for (const Entry* thing : things) {
    holding.insert(child_of(root, thing->path));
    project |= is_exercise_file(*thing, exercise_files) && parent_of(thing->path) == root;
  }
  for (const std::size_t i : all) {
    project |= name_of(entries[i]) == "CMakeLists.txt" && lies_in(root, parent_of(entries[i].path));
  }
  const bool lone_archive = on_disk && things.size() == 1 && root.empty() && is_archive(*things.front()) &&
                            things.front()->path == *holding.begin();
  layout.is_class = !project && (holding.size() > 1 || lone_archive);
  if (!layout.is_class) return layout;

  std::map<std::string_view, Member> members;
  for (const std::size_t i : all) {
    const Entry& entry = entries[i];
    if (entry.path == root || !lies_in(entry.path, root)) continue;
    const std::string_view child = child_of(root, entry.path);
    const bool is_child = child == entry.path;
    if (is_child && entry.kind != Entry::Kind::folder && !is_archive(entry)) continue;
    Member& member = members[child];
    member.path = child;
    member.archive |= is_child && is_archive(entry);
    member.entries.push_back(i);
  }
  layout.members.clear();
  for (auto& [path, member] : members) layout.members.push_back(std::move(member));
  return layout;
}

Takings takings_of(const std::vector<Entry>& list, const std::vector<std::size_t>& entries,
                   const FileNames& exercise_files) {
  Takings takings;
  for (const std::size_t i : entries) {
    if (is_exercise_file(list[i], exercise_files)) takings.files.push_back(i);
    if (is_archive(list[i])) takings.archives.push_back(i);
  }
  if (!takings.files.empty()) takings.archives.clear();
  return takings;
}

}  // namespace grader
