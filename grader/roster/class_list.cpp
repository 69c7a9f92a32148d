// STAFF ONLY. Hand-ins find their people.
#include "grader/roster/class_list.h"

#include <algorithm>

namespace grader {

std::vector<const Person*> ClassList::absent() const {
  std::vector<const Person*> people;
  for (const Row& row : rows)
    if (row.hand_ins.empty()) people.push_back(&row.person);
  return people;
}

ClassList class_list(const Roster& roster, const std::vector<HandIn>& hand_ins) {
  ClassList list;
  list.said = roster.said();
  for (const Person& person : roster.people()) list.rows.push_back({person, {}});
  for (const HandIn& hand_in : hand_ins) {
    const bool members = !hand_in.owner.members.empty();
    for (const Owner& owner : members ? hand_in.owner.members : std::vector{hand_in.owner}) {
      const Roster::Match match = roster.find(owner, hand_in.system);
      const std::string who =
          members ? hand_in.name + ", " + (owner.name.empty() ? owner.id : owner.name) : hand_in.name;
      if (!match.person) {
        list.strangers.push_back({who, match.told});
        continue;
      }
      if (!match.told.empty()) list.said.push_back(who + ": " + match.told);
      std::vector<std::string>& theirs = list.rows[*match.person].hand_ins;
      if (std::ranges::count(theirs, hand_in.name) == 0) theirs.push_back(hand_in.name);
      if (theirs.size() == 2)
        list.said.push_back(list.rows[*match.person].person.name + ": has two hand-ins, " + theirs[0] +
                            " and " + theirs[1]);
    }
  }
  return list;
}

}  // namespace grader
