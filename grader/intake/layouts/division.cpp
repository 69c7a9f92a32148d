// STAFF ONLY. Divides a learning system's download.
#include "grader/intake/layouts/division.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "grader/intake/names/archive_format.h"
#include "grader/intake/names/names.h"
#include "grader/text/letters.h"

namespace grader::inline intake {
namespace {

// This is a name directly in the download's folder.
struct Child {
  bool is_folder = false;
  std::vector<std::size_t> files = {};
  std::optional<NamedPath> named = {};
};
using Children = std::map<std::string, Child>;    // by path
using Folders = std::map<std::string, Children>;  // by the folder around the names

std::string_view last_part(std::string_view path) {
  return path.substr(path.rfind('/') + 1);
}

// Lists all names in `around`, or in each folder in it.
Folders names_in(const std::vector<Entry>& list, const std::string& around, bool in_each) {
  Folders folders;
  if (!in_each) folders[around];
  const std::string prefix = around.empty() ? "" : around + "/";
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string& path = list[i].path;
    if (is_ignored(path) || !path.starts_with(prefix)) continue;
    const std::size_t end = in_each ? path.find('/', prefix.size()) : prefix.size();
    const std::size_t begin = end + (in_each ? 1 : 0);
    if (end == path.npos || begin >= path.size()) continue;
    const std::size_t slash = path.find('/', begin);
    Child& child = folders[in_each ? path.substr(0, end) : around][path.substr(0, slash)];
    const bool is_folder = list[i].kind == Entry::Kind::folder;
    if (slash != path.npos || is_folder) child.is_folder = true;
    if (!is_folder) child.files.push_back(i);
  }
  return folders;
}

// Reads the children's names, and returns how many of them the system knows.
std::pair<std::size_t, std::size_t> read_names(Children& children, const System& system,
                                               const Around& around) {
  std::size_t known = 0, made = 0;
  for (auto& [path, child] : children) {
    child.named = system.read(last_part(path), child.is_folder, around);
    if (child.named) (child.named->kind == NamedPath::Kind::made ? made : known) += 1;
  }
  return {known, children.size() - made};
}

using Attempt = std::tuple<std::string, int>;  // a time, a version
Attempt attempt_of(const NamedPath& named) {
  return {named.handed_in, named.version};
}

class Divider {
 public:
  Divider(std::vector<Entry>& list, Children& children, Division& division, const KnownOwner& known)
      : list_(list), children_(children), division_(division), known_(known) {}

  void divide();

 private:
  using Key = std::pair<std::string, std::string>;  // an owner's name and id
  static Key key_of(const NamedPath& named) { return {named.owner.name, named.owner.id}; }
  std::string unit_of(const NamedPath& named) const {
    return division_.system->files_have_versions ? named.inside : "";
  }

  void set_aside(const Child& child, Accounted::As as, const std::string& reason,
                 std::size_t hand_in = Division::kNobody) {
    for (const std::size_t i : child.files) division_.aside.push_back({i, as, reason, hand_in});
  }

  std::vector<Entry>& list_;
  Children& children_;
  Division& division_;
  const KnownOwner& known_;
};

void Divider::divide() {
  const std::string system(division_.system->shown);
  std::vector<NamedPath*> names;
  for (auto& [path, child] : children_)
    if (child.named && child.named->kind != NamedPath::Kind::made) names.push_back(&*child.named);
  if (division_.system->settle) division_.system->settle(names);
  for (NamedPath* named : names) settle_readings(*named, division_.system->name, known_);

  std::map<Key, std::size_t> owners;
  for (const NamedPath* named : names) owners.try_emplace(key_of(*named), 0);
  for (auto& [key, number] : owners) {
    number = division_.hand_ins.size();
    division_.hand_ins.emplace_back();
  }
  std::map<std::pair<std::size_t, std::string>, Attempt> newest;
  for (const NamedPath* named : names) {
    Attempt& latest = newest[{owners.at(key_of(*named)), unit_of(*named)}];
    latest = std::max(latest, attempt_of(*named));
  }
  for (auto& [path, child] : children_) {
    if (!child.named) {
      set_aside(child, Accounted::As::left_over,
                "belongs to nobody: its name does not have the form of " + system);
      continue;
    }
    const NamedPath& named = *child.named;
    if (named.kind == NamedPath::Kind::made) {
      set_aside(child, Accounted::As::made, "made by " + system);
      continue;
    }
    if (!child.is_folder)
      for (const std::size_t i : child.files) list_[i].path = path + "/" + named.inside;
    const std::size_t number = owners.at(key_of(named));
    FoundHandIn& hand_in = division_.hand_ins[number];
    const bool counts = attempt_of(named) == newest.at({number, unit_of(named)});
    const auto folder_of = [](const std::string& of) { return of.substr(0, of.rfind('/') + 1); };
    if (!hand_in.path.empty() && hand_in.remarks.empty() && folder_of(hand_in.path) != folder_of(path))
      hand_in.remarks.push_back(path + " is by a person who is also in " + folder_of(hand_in.path) +
                                "; both count as one hand-in");
    if (hand_in.path.empty() || counts) {
      hand_in.path = path;
      hand_in.owner = named.owner;
      hand_in.handed_in = named.handed_in;
    }
    hand_in.late = hand_in.late || named.late;
    if (!named.doubt.empty()) hand_in.doubts.push_back(path + " " + named.doubt);
    if (named.kind == NamedPath::Kind::text && !child.is_folder) {
      set_aside(child, Accounted::As::made, "made by " + system + " from a typed text or a link", number);
    } else if (!counts) {
      set_aside(child, Accounted::As::older, "a newer hand-in counts", number);
    } else {
      for (const std::size_t i : child.files) {
        const std::string_view inside = name_of(list_[i]);
        if (named.kind == NamedPath::Kind::text && inside.ends_with(".html")) {
          division_.aside.push_back(
              {i, Accounted::As::made, "made by " + system + " from a typed text", number});
          continue;
        }
        hand_in.entries.push_back(i);
      }
    }
  }
}

// Returns the system that knows most names of each folder, and reads the names as that system.
const System* known_in_each(Folders& folders, const std::string& container, const System* said) {
  const auto known_by = [&](const System& system) {
    std::size_t all = 0;
    for (auto& [path, children] : folders) {
      const Around around{path.empty() ? container : std::string(last_part(path)), said != nullptr};
      const auto [known, of] = read_names(children, system, around);
      if (known == 0 || (!said && 2 * known <= of)) return std::size_t{0};
      all += known;
    }
    return all;
  };
  const System* best = nullptr;
  std::size_t most = 0;
  for (const System& system : systems()) {
    if (said && &system != said) continue;
    if (const std::size_t known = known_by(system); known > most) {
      best = &system;
      most = known;
    }
  }
  if (best) known_by(*best);
  return best;
}

// True if the path has the name of a hand-in, or of a file in one.
bool may_be_a_hand_in(std::string_view path, const Division& division) {
  const std::string_view called = last_part(path), name = without_archive_ending(called);
  return told_by_name(called, false) || told_by_name(called, true) ||
         std::ranges::any_of(division.hand_ins, [&](const FoundHandIn& one) {
           return name == one.owner.id || submission_name(name) == name_of_owner(one.owner) ||
                  squeezed(name) == squeezed(one.owner.name);
         });
}

Division divided(std::vector<Entry>& list, Folders& folders, const System& system, const KnownOwner& known) {
  Children children;
  for (auto& [path, some] : folders) children.merge(some);
  Division division{.system = &system};
  Divider(list, children, division, known).divide();
  std::vector<bool> lies_in_it(list.size());
  for (const auto& [path, child] : children)
    for (const std::size_t i : child.files) lies_in_it[i] = true;
  for (std::size_t i = 0; i < list.size(); ++i)
    if (!lies_in_it[i] && list[i].kind != Entry::Kind::folder && !is_ignored(list[i].path))
      division.aside.push_back(
          {i, Accounted::As::left_over, "belongs to nobody: it lies outside of the download's folder"});
  return division;
}

}  // namespace

std::optional<Division> divide(std::vector<Entry>& list, const std::string& container, const System* said,
                               bool may_have_sections, const KnownOwner& known) {
  constexpr int kMostAround = 8;
  std::string around;
  for (int depth = 0; depth <= kMostAround; ++depth) {
    Folders folders = names_in(list, around, false);
    std::vector<std::string> inner;
    for (const auto& [path, child] : folders.at(around))
      if (child.is_folder) inner.push_back(path);
    if (const System* system = known_in_each(folders, container, said))
      return divided(list, folders, *system, known);
    if (inner.size() == 1) {  // folders may enclose the download, with files beside them
      around = inner.front();
      continue;
    }
    if (inner.empty() || !may_have_sections) return {};
    folders = names_in(list, around, true);
    const System* system = folders.size() == inner.size() ? known_in_each(folders, container, said) : nullptr;
    if (!system) return {};
    std::vector<Entry> of_sections = list;
    Division division = divided(of_sections, folders, *system, known);
    if (std::ranges::any_of(inner, [&](const auto& path) { return may_be_a_hand_in(path, division); }))
      return {};
    list = std::move(of_sections);
    return division;
  }
  return {};
}

}  // namespace grader::intake
