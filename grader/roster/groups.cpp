// STAFF ONLY. Finds members of groups.
#include "grader/roster/groups.h"

#include <algorithm>
#include <map>
#include <set>

#include "grader/text/letters.h"

namespace grader::inline roster {
namespace {

struct Group {
  std::string name;  // as the roster writes it
  std::vector<std::size_t> members;
  std::string other = {};  // is another name that a download may write the same: "Team 1-1" beside "Team 11"
};
using Groups = std::map<std::string, Group>;  // by the letters of the name

// Reads "Team 7" or "Team 7, Tutorial 2": a comma may also be part of a name.
Groups groups_of(const Roster& roster) {
  Groups groups;
  for (std::size_t i = 0; i < roster.people().size(); ++i) {
    std::string cell = roster.people()[i].group;
    cell.erase(cell.find_last_not_of(",; ") + 1);
    std::set<std::string> names{cell};
    for (std::size_t begin = 0, end = 0; end != cell.npos; begin = end + 1) {
      end = cell.find_first_of(",;", begin);
      names.insert(composed(cell.substr(begin, end - begin)));
    }
    for (const std::string& name : names)
      if (const std::string key = squeezed(name); !key.empty()) {
        Group& group = groups.try_emplace(key, Group{name, {}}).first->second;
        if (lowered(name) != lowered(group.name)) group.other = name;
        if (group.members.empty() || group.members.back() != i) group.members.push_back(i);
      }
  }
  return groups;
}

bool is_a_person(const std::string& key, const Roster& roster) {
  return std::ranges::any_of(roster.people(), [&](const Person& person) {
    return person.keys.as_spoken == key || person.keys.as_sorted == key;
  });
}

Owner owner_of(const Person& person, const std::string& system) {
  const IdKind kind = system == "canvas" ? IdKind::id : IdKind::participant;
  const bool has_ids = system == "canvas" || system == "moodle";
  return {.name = person.name, .id = has_ids ? person.id(kind) : "", .email = person.email()};
}

// Returns why the hand-in is not the group's; "": it is.
std::string doubt(const HandIn& hand_in, const std::string& key, const Group& group, const Roster& roster) {
  if (!group.other.empty()) return "the group " + group.other + " would be called so, too";
  if (is_a_person(key, roster)) return "a person of the roster has this name, too";
  Owner one = hand_in.owner;
  one.group = false;
  // Moodle's number is a group's: a participant may have the same one.
  const Roster::Match match = hand_in.system == "moodle" ? Roster::Match{} : roster.find(one, hand_in.system);
  if (!match.person || std::ranges::count(group.members, *match.person) > 0) return "";
  return roster.people()[*match.person].name +
         " handed it in, who is in another group of the roster or in none";
}

}  // namespace

KnownOwner known_by(const Roster& roster) {
  return [&roster, groups = groups_of(roster)](const Owner& owner, std::string_view system) {
    const std::string key = squeezed(owner.name);
    const std::optional<std::size_t> person =
        owner.id.empty() ? std::nullopt : roster.find({.id = owner.id}, std::string(system)).person;
    const auto group = groups.find(key);
    if (!person) return group != groups.end() || is_a_person(keys_of(owner.name).as_spoken, roster) ? 1 : 0;
    const NameKeys& keys = roster.people()[*person].keys;
    const bool agrees = key == keys.as_spoken || key == keys.as_sorted ||
                        (group != groups.end() && std::ranges::count(group->second.members, *person) > 0);
    return agrees ? 2 : 1;
  };
}

Membership find_members(std::vector<HandIn>& hand_ins, const Roster& roster) {
  const Groups groups = groups_of(roster);
  const auto key_of = [](const HandIn& hand_in) {
    const Owner& owner = hand_in.owner;
    return owner.members.empty() && !owner.anonymous ? squeezed(owner.name) : "";
  };
  std::map<std::string, int> called_so;
  for (const HandIn& hand_in : hand_ins) ++called_so[key_of(hand_in)];

  Membership all;
  std::size_t found_groups = 0, people = 0;
  for (HandIn& hand_in : hand_ins) {
    const std::string key = key_of(hand_in);
    const auto found = groups.find(key);
    if (found == groups.end()) continue;
    const Group& group = found->second;
    const bool each_alone = called_so.at(key) > 1;  // Canvas does so if it grades each member alone
    const std::string why =
        each_alone ? "other hand-ins have its name, too" : doubt(hand_in, key, group, roster);
    if (!why.empty()) {
      (each_alone ? all.said : all.doubts)
          .push_back(hand_in.name + ": has the name of the roster's group " + group.name +
                     ", but does not count as that group's: " + why);
      continue;
    }
    hand_in.owner.group = true;
    hand_in.owner.name = group.name;
    for (const std::size_t member : group.members)
      hand_in.owner.members.push_back(owner_of(roster.people()[member], hand_in.system));
    ++found_groups;
    people += group.members.size();
  }
  if (found_groups > 0)
    all.said.push_back(std::to_string(found_groups) +
                       " hand-ins have names of the roster's groups and count for " + std::to_string(people) +
                       " people");
  return all;
}

}  // namespace grader::roster
