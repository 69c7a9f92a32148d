// STAFF ONLY. Divides a learning system's download.
#include "grader/intake/layouts/division.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "grader/intake/ignored.h"

namespace grader {
namespace {

// A name directly in the folder that the download's names stand in.
struct Child {
  bool is_folder = false;
  std::vector<std::size_t> files = {};
  std::optional<Named> named = {};
};
using Children = std::map<std::string, Child>;

Children children_below(const std::vector<Entry>& list, const std::string& root) {
  Children children;
  const std::string prefix = root.empty() ? "" : root + "/";
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Entry& entry = list[i];
    if (is_ignored(entry.path) || !entry.path.starts_with(prefix) || entry.path.size() == prefix.size())
      continue;
    const std::size_t slash = entry.path.find('/', prefix.size());
    Child& child = children[entry.path.substr(prefix.size(), slash - prefix.size())];
    const bool is_folder = entry.kind == Entry::Kind::folder;
    if (slash != std::string::npos || is_folder) child.is_folder = true;
    if (!is_folder) child.files.push_back(i);
  }
  return children;
}

// How many children the system knows. It reads their names.
std::pair<std::size_t, std::size_t> read_names(Children& children, const System& system,
                                               const Around& around) {
  std::size_t known = 0, made = 0;
  for (auto& [name, child] : children) {
    child.named = system.read(name, child.is_folder, around);
    if (child.named) (child.named->kind == Named::Kind::made ? made : known) += 1;
  }
  return {known, children.size() - made};
}

using Attempt = std::tuple<std::string, int>;  // a time, a version
Attempt attempt_of(const Named& named) {
  return {named.handed_in, named.version};
}

class Divider {
 public:
  Divider(std::vector<Entry>& list, const std::string& root, Children& children, Division& division)
      : list_(list), prefix_(root.empty() ? "" : root + "/"), children_(children), division_(division) {}

  void divide();

 private:
  // A version counts for each file of its own where there is no time (Canvas), else for all of an attempt.
  using Key = std::pair<std::string, std::string>;  // an owner's name and id
  static Key key_of(const Named& named) { return {named.owner.name, named.owner.id}; }
  static std::string unit_of(const Named& named) { return named.handed_in.empty() ? named.inside : ""; }

  void set_aside(const Child& child, Accounted::As as, const std::string& reason,
                 std::size_t hand_in = Division::kNobody) {
    for (const std::size_t i : child.files) division_.aside.push_back({i, as, reason, hand_in});
  }

  std::vector<Entry>& list_;
  std::string prefix_;
  Children& children_;
  Division& division_;
};

void Divider::divide() {
  const std::string system(division_.system->shown);
  std::vector<Named*> names;
  for (auto& [name, child] : children_)
    if (child.named && child.named->kind != Named::Kind::made) names.push_back(&*child.named);
  if (division_.system->settle) division_.system->settle(names);

  std::map<Key, std::size_t> owners;
  for (const Named* named : names) owners.try_emplace(key_of(*named), 0);
  for (auto& [key, number] : owners) {
    number = division_.hand_ins.size();
    division_.hand_ins.emplace_back();
  }
  std::map<std::pair<std::size_t, std::string>, Attempt> newest;
  for (const Named* named : names) {
    Attempt& latest = newest[{owners.at(key_of(*named)), unit_of(*named)}];
    latest = std::max(latest, attempt_of(*named));
  }
  for (auto& [name, child] : children_) {
    if (!child.named) {
      set_aside(child, Accounted::As::left_over,
                "belongs to nobody: it has no name that " + system + " gives");
      continue;
    }
    const Named& named = *child.named;
    if (named.kind == Named::Kind::made) {
      set_aside(child, Accounted::As::made, system + " writes it");
      continue;
    }
    const std::size_t number = owners.at(key_of(named));
    HandIn& hand_in = division_.hand_ins[number];
    const bool counts = attempt_of(named) == newest.at({number, unit_of(named)});
    if (hand_in.path.empty() || counts) {
      hand_in.path = prefix_ + name;
      hand_in.owner = named.owner;
      hand_in.handed_in = named.handed_in;
    }
    hand_in.late = hand_in.late || named.late;
    if (!named.doubt.empty()) hand_in.doubts.push_back(prefix_ + name + " " + named.doubt);
    if (named.kind == Named::Kind::text && !child.is_folder) {
      set_aside(child, Accounted::As::made, system + " writes it of what was typed or linked", number);
    } else if (!counts) {
      set_aside(child, Accounted::As::older, "a newer hand-in counts", number);
    } else {
      for (const std::size_t i : child.files) {
        const std::string_view inside = name_of(list_[i]);
        if (named.kind == Named::Kind::text && inside.ends_with(".html")) {
          division_.aside.push_back(
              {i, Accounted::As::made, system + " writes it of what was typed", number});
          continue;
        }
        if (!child.is_folder) list_[i].path = prefix_ + name + "/" + named.inside;
        hand_in.entries.push_back(i);
      }
    }
  }
}

}  // namespace

std::optional<Division> divide(std::vector<Entry>& list, const std::string& container, const System* said) {
  constexpr int kMostAround = 8;
  std::string root;
  for (int depth = 0; depth <= kMostAround; ++depth) {
    Children children = children_below(list, root);
    const std::size_t slash = root.rfind('/');
    const Around around{root.empty()                 ? container
                        : slash == std::string::npos ? root
                                                     : root.substr(slash + 1),
                        said != nullptr};
    Division best;
    for (const System& system : systems()) {
      if (said && &system != said) continue;
      const auto [known, of] = read_names(children, system, around);
      if (known > best.known) best = {&system, known, of};
    }
    if (best.known > 0 && (said || 2 * best.known > best.children)) {
      read_names(children, *best.system, around);
      Divider(list, root, children, best).divide();
      // A file may lie beside the folders around the download.
      const std::string prefix = root.empty() ? "" : root + "/";
      for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i].kind == Entry::Kind::folder || is_ignored(list[i].path) ||
            list[i].path.starts_with(prefix))
          continue;
        best.aside.push_back({i, Accounted::As::left_over, "belongs to nobody: it lies outside of " + root});
      }
      return best;
    }
    // Around the download there may be folders, and files beside them.
    const std::string* only = nullptr;
    std::size_t folders = 0;
    for (const auto& [name, child] : children)
      if (child.is_folder) {
        ++folders;
        only = &name;
      }
    if (folders != 1) return {};
    root += (root.empty() ? "" : "/") + *only;
  }
  return {};
}

}  // namespace grader
