// STAFF ONLY. Finds the people of hand-ins.
#include "grader/roster/class_list.h"

#include <algorithm>

#include "grader/intake/names/names.h"
#include "grader/text/letters.h"

namespace grader::inline roster {

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
  std::vector<std::string> doubtful;
  std::string column;
  for (const HandIn& hand_in : hand_ins) {
    const bool members = !hand_in.owner.members.empty();
    for (const Owner& owner : members ? hand_in.owner.members : std::vector{hand_in.owner}) {
      const Roster::Match match = roster.find(owner, hand_in.system);
      const std::string who =
          members ? hand_in.name + ", " + (owner.name.empty() ? owner.id : owner.name) : hand_in.name;
      if (!match.person) {
        if (std::ranges::none_of(list.strangers, [&](const ClassList::Stranger& other) {
              return other.hand_in == hand_in.name && other.owner.name == owner.name &&
                     other.owner.id == owner.id && other.owner.email == owner.email;
            }))
          list.strangers.push_back({hand_in.name, owner, match.told});
        column = Roster::column_for(hand_in.system);
        continue;
      }
      if (!match.told.empty())
        (match.has_other_name ? doubtful : list.said).push_back(who + ": " + match.told);
      std::vector<std::string>& theirs = list.rows[*match.person].hand_ins;
      if (std::ranges::count(theirs, hand_in.name) == 0) theirs.push_back(hand_in.name);
      if (theirs.size() == 2)
        list.to_look_at.push_back(list.rows[*match.person].person.name + ": has two hand-ins, " + theirs[0] +
                                  " and " + theirs[1]);
    }
  }
  // A missing person may be the one who handed in.
  std::vector<std::string> missing;
  for (const Person* person : list.absent())
    missing.push_back(person->name +
                      (person->shown_id() == person->name ? "" : " (" + person->shown_id() + ")"));
  std::ranges::move(doubtful, std::back_inserter(missing.empty() ? list.said : list.to_look_at));
  if (!missing.empty() && !list.strangers.empty())
    list.to_look_at.push_back(
        "nobody on the roster is found for " + std::to_string(list.strangers.size()) +
        " of those who handed in, while these of the roster handed in nothing: " + some_of(missing) +
        "; a roster whose column \"" + column + "\" has the download's numbers tells who is who");
  return list;
}

std::vector<ClassLine> lines_of(const std::optional<ClassList>& list, const std::vector<HandIn>& hand_ins) {
  std::vector<ClassLine> lines;
  const auto line_of = [](const std::string& hand_in, const Owner& owner, const std::string& note) {
    return ClassLine{hand_in, composed(owner.name), owner.id, owner.email, "", note};
  };
  if (!list) {
    for (const HandIn& hand_in : hand_ins) {
      const Owner& owner = hand_in.owner;
      if (hand_in.system == "folders") continue;  // the name is all that it has
      for (const Owner& member : owner.members) lines.push_back(line_of(hand_in.name, member, ""));
      if (owner.members.empty() && !(owner.name.empty() && owner.id.empty() && owner.email.empty()))
        lines.push_back(line_of(hand_in.name, owner, ""));
    }
    return lines;
  }
  for (const ClassList::Row& row : list->rows) {
    const Person& person = row.person;
    const auto line = [&](const std::string& hand_in, const std::string& note) {
      return ClassLine{hand_in, person.name, person.shown_id(), person.email(), person.section, note};
    };
    for (const std::string& hand_in : row.hand_ins) lines.push_back(line(hand_in, ""));
    if (row.hand_ins.empty()) lines.push_back(line("", "nothing handed in"));
  }
  for (const ClassList::Stranger& stranger : list->strangers)
    lines.push_back(line_of(stranger.hand_in, stranger.owner, stranger.why));
  return lines;
}

const std::string& shown_name(const std::string& hand_in, const NamesForPeople& people) {
  const auto person = people.find(hand_in);
  return person == people.end() ? hand_in : person->second;
}

std::string called(const std::string& hand_in, const NamesForPeople& people) {
  return people.contains(hand_in) ? legible(people.at(hand_in)) + " (" + hand_in + ")" : hand_in;
}

NamesForPeople names_for_people(const std::optional<ClassList>& list, const std::vector<HandIn>& hand_ins) {
  NamesForPeople names;
  for (const ClassLine& line : lines_of(list, hand_ins)) {
    if (line.hand_in.empty() || line.name.empty()) continue;
    std::string& name = names[line.hand_in];
    name += (name.empty() ? "" : "; ") + line.name;  // "Doe, Jane; Roe, Richard"
  }
  for (const HandIn& hand_in : hand_ins) {
    std::string joined;  // is set if a group has no name of its own
    for (const Owner& member : hand_in.owner.members) joined += (joined.empty() ? "" : ", ") + member.name;
    if (const auto found = names.find(hand_in.name); found != names.end() && !joined.empty() &&
                                                     !hand_in.owner.name.empty() &&
                                                     hand_in.owner.name != joined)
      found->second = composed(hand_in.owner.name) + " (" + found->second + ")";
  }
  std::erase_if(names, [](const auto& one) { return one.first == one.second; });
  return names;
}

}  // namespace grader::roster
