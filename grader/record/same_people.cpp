// STAFF ONLY. Finds hand-ins of the same people.
#include "grader/record/same_people.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "grader/intake/names/names.h"

namespace grader::inline record {
namespace {

// A group with unknown members has none.
std::vector<Owner> people_of(const Owner& owner) {
  return owner.members.empty() && !owner.group ? std::vector{owner} : owner.members;
}

// A name is weak evidence: it counts only without other data.
bool same_person(const Owner& a, const Owner& b, bool same_system) {
  if (same_system && !a.id.empty() && !b.id.empty()) return a.id == b.id;
  if (!a.email.empty() && !b.email.empty()) return a.email == b.email;
  return (a.id + a.email + b.id + b.email).empty() && !a.name.empty() && keys_of(a.name) == keys_of(b.name);
}

// Canvas's group has the number of the student who handed in: it counts if the members are unknown.
bool has_ids_of_groups(const HandIn& a, const HandIn& b) {
  const bool members = !a.owner.members.empty() && !b.owner.members.empty();
  return a.owner.group && b.owner.group && a.system == b.system && !a.owner.id.empty() &&
         !b.owner.id.empty() && !(a.system == "canvas" && members);
}

// Rates two hand-ins; 0: others. It is the share of people in both among those in either; an equal id of the
// group counts more, and one person's hand-ins with the same name most.
double sameness(const HandIn& a, const HandIn& b) {
  constexpr double kById = 2, kByName = 3;
  const bool same_system = a.system == b.system;
  if (a.system.empty() || (!a.owner.group && !b.owner.group && a.name == b.name))
    return a.name == b.name ? kByName : 0;
  const bool ids = has_ids_of_groups(a, b);
  if (ids && a.owner.id == b.owner.id) return kById;
  const std::vector<Owner> these = people_of(a.owner), those = people_of(b.owner);
  if (these.empty() || those.empty()) return !ids && a.name == b.name ? 1 : 0;
  const auto both = static_cast<double>(std::ranges::count_if(these, [&](const Owner& one) {
    return std::ranges::any_of(those,
                               [&](const Owner& other) { return same_person(one, other, same_system); });
  }));
  return both / (static_cast<double>(these.size() + those.size()) - both);
}

std::string ids_of(const Owner& owner) {
  std::string all = owner.id;
  std::set<std::string> members;
  for (const Owner& one : owner.members) members.insert(one.id + " " + one.email + " " + one.name);
  for (const std::string& one : members) all += "\n" + one;
  return all;
}

// Finds for each of `now` the one of `before`; null for somebody new.
std::vector<const Drawn*> found_again(const std::vector<Drawn>& before, const std::vector<HandIn>& now) {
  struct Pair {
    double sameness;
    std::size_t before, now;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < before.size(); ++i)
    for (std::size_t j = 0; j < now.size(); ++j)
      if (const double share = sameness(before[i].hand_in, now[j]); share > 0) pairs.push_back({share, i, j});
  const auto order = [&](const Pair& pair) {
    const std::string &was = before[pair.before].hand_in.name, &is = now[pair.now].name;
    return std::tuple(-pair.sameness, was != is, was, is);
  };
  std::ranges::sort(pairs, {}, order);
  std::vector<const Drawn*> found(now.size());
  std::set<std::string> rows;
  for (const Pair& pair : pairs)
    if (!found[pair.now] && rows.insert(before[pair.before].hand_in.name).second)
      found[pair.now] = &before[pair.before];
  return found;
}

bool keeps_its_row(const HandIn& before, const HandIn& now) {
  if (before.owner.group != now.owner.group) return false;
  if (has_ids_of_groups(before, now) && before.owner.id == now.owner.id) return true;
  const std::vector<Owner> these = people_of(before.owner), those = people_of(now.owner);
  return !these.empty() && std::ranges::all_of(these, [&](const Owner& one) {
    const bool a_name_alone = !before.owner.group && one.id.empty() && one.email.empty();
    return !a_name_alone && std::ranges::any_of(those, [&](const Owner& other) {
      return same_person(one, other, before.system == now.system);
    });
  });
}

}  // namespace

std::vector<std::string> drawn_from(const std::vector<Drawn>& before, const std::vector<HandIn>& now) {
  const std::vector<const Drawn*> found = found_again(before, now);
  std::vector<std::string> from(now.size());
  std::set<std::string> taken;
  for (const Drawn& one : before) taken.insert(one.from);
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (found[i]) {
      from[i] = found[i]->from;
      continue;
    }
    from[i] = now[i].known_as.empty() ? now[i].name : now[i].known_as;
    if (!taken.insert(from[i]).second) from[i] = name_among_equals(from[i], ids_of(now[i].owner));
  }
  return from;
}

std::vector<RowName> row_names(const std::vector<Drawn>& before, const std::vector<HandIn>& now) {
  const std::vector<const Drawn*> found = found_again(before, now);
  std::set<std::string> rows;
  for (const Drawn& one : before) rows.insert(one.hand_in.name);
  std::vector<RowName> names;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const HandIn& hand_in = now[i];
    RowName row{hand_in.name};
    const std::string was = found[i] ? found[i]->hand_in.name : "";
    if (found[i] && was != hand_in.name) {
      if (keeps_its_row(found[i]->hand_in, hand_in)) {
        row = {was, hand_in.name + ": is " + was + " under another name, and keeps its row"};
      } else if (hand_in.owner.group && found[i]->hand_in.owner.group) {
        row.told = hand_in.name + ": is " + was + ", but somebody has left it, and has a row of its own; " +
                   "decisions about " + was + " stay there";
      }
    }
    if (row.name == hand_in.name && was != hand_in.name && rows.contains(hand_in.name))
      row = {name_among_equals(hand_in.name, ids_of(hand_in.owner)),
             hand_in.name + ": other people have the row of this name; its own is called by a number, too"};
    names.push_back(std::move(row));
  }
  return names;
}

}  // namespace grader::record
