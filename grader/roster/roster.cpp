// STAFF ONLY. Finds people.
#include "grader/roster/roster.h"

#include <algorithm>
#include <set>

#include "grader/course/input.h"
#include "grader/roster/columns.h"
#include "grader/text/letters.h"

namespace grader::inline roster {
namespace {

std::string without_zeros(const std::string& id) {
  const std::size_t begin = id.find_first_not_of('0');
  const bool number = id.find_first_not_of("0123456789") == id.npos;
  return number && begin != id.npos ? id.substr(begin) : id;
}

// Lists the ids in a system's hand-ins, the most reliable first. The name of a folder may be anything.
std::vector<IdKind> kinds_of(const std::string& system) {
  using enum IdKind;
  if (system == "canvas") return {id};
  if (system == "moodle") return {participant};
  if (system == "gradescope") return {id, sis};
  if (system == "blackboard") return {login, id};
  if (system == "brightspace") return {org_defined, login, id};
  if (system == "autolab") return {email};
  if (system == "classroom") return {github_id, github_login};  // accounts are renamed, numbers are not
  return {id, sis, login, org_defined, github_login, email};
}

std::string count_of(std::size_t people) {
  return std::to_string(people) + " people on the roster";
}

}  // namespace

Roster::Roster(const Csv& table) : said_(table.said) {
  const RosterColumns columns(table);
  for (std::size_t i = 1; i < table.rows.size(); ++i)
    if (std::optional<Person> person = columns.person(table, table.rows[i], said_))
      add(table, table.rows[i], std::move(*person));
  if (people_.empty())
    throw BadInput(table.file + ": nobody stands below the titles; a roster has a row for each person");
}

Roster::Roster(std::vector<Person> people) {
  for (Person& person : people) add(std::move(person));
}

void Roster::add(const Csv& table, const Csv::Row& row, Person person) {
  std::optional<std::size_t> known;
  IdKind by = IdKind::id;
  for (std::size_t i = 0; i < kIdKinds; ++i) {
    if (person.ids[i].empty()) continue;
    const auto found = by_id_[i].find(person.ids[i]);
    if (found == by_id_[i].end()) continue;
    const std::size_t place = found->second.front();
    if (known && *known != place)
      throw BadInput(place_of(table, row) + ": its " + title_of(by) + " is line " +
                     std::to_string(people_[*known].line) + "'s and its " + title_of(static_cast<IdKind>(i)) +
                     " line " + std::to_string(people_[place].line) +
                     "'s; all ids of a row are one person's");
    known = place;
    by = static_cast<IdKind>(i);
  }
  by_line_[row.line] = known.value_or(people_.size());
  if (known) {  // this is the same person in another section
    Person& before = people_[*known];
    for (std::size_t i = 0; i < kIdKinds; ++i)
      if (person.ids[i] != before.ids[i])
        throw BadInput(place_of(table, row) + ": " + title_of(by) + " " + person.id(by) + " is line " +
                       std::to_string(before.line) + "'s, too, with another " +
                       title_of(static_cast<IdKind>(i)) + "; an id is one person's");
    if (person.keys != before.keys)
      throw BadInput(place_of(table, row) + ": " + title_of(by) + " " + person.id(by) + " is line " +
                     std::to_string(before.line) + "'s, too, with another name; an id is one person's");
    if (person.section == before.section && person.group == before.group)
      said_.push_back(place_of(table, row) + ": is line " + std::to_string(before.line) +
                      "'s person again, who counts once");
    for (std::string Person::*cell : {&Person::section, &Person::group})
      if (!(person.*cell).empty() && person.*cell != before.*cell)
        before.*cell += ((before.*cell).empty() ? "" : ", ") + person.*cell;
    return;
  }
  add(std::move(person));
}

void Roster::add(Person person) {
  const std::size_t place = people_.size();
  for (std::size_t i = 0; i < kIdKinds; ++i) {
    if (person.ids[i].empty()) continue;
    by_id_[i][person.ids[i]].push_back(place);
    by_id_without_zeros_[i][without_zeros(person.ids[i])].push_back(place);
  }
  if (!person.keys.as_spoken.empty()) {
    by_spoken_[person.keys.as_spoken].push_back(place);
    by_sorted_[person.keys.as_sorted].push_back(place);
  }
  people_.push_back(std::move(person));
}

std::optional<std::size_t> Roster::at_line(std::size_t line) const {
  const auto found = by_line_.find(line);
  return found == by_line_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::size_t> Roster::with_id(IdKind kind, const std::string& id, std::string& told) const {
  const auto at = [&](const std::array<Places, kIdKinds>& index, const std::string& key) {
    const Places& places = index[static_cast<std::size_t>(kind)];
    const auto found = places.find(key);
    return found == places.end() ? std::vector<std::size_t>() : found->second;
  };
  const bool any_case = kind == IdKind::email || kind == IdKind::github_login;
  const std::string wanted = plain_id(any_case ? lowered(id) : id);
  if (wanted.empty()) return {};
  std::vector<std::size_t> found = at(by_id_, wanted);
  if (found.empty() && !any_case) {
    found = at(by_id_without_zeros_, without_zeros(wanted));
    if (found.size() == 1)
      told = std::string(title_of(kind)) + " " + wanted + " is " + people_[found[0]].id(kind) +
             " on the roster: they differ by zeros in front";
  }
  return found;
}

Roster::Match Roster::find(const Owner& owner, const std::string& system) const {
  if (owner.group) return {{}, "a group is nobody on the roster"};
  std::set<std::size_t> found;
  std::string told;
  const auto look = [&](IdKind kind, const std::string& id) {
    for (const std::size_t place : with_id(kind, id, told)) found.insert(place);
  };
  for (const IdKind kind : kinds_of(system)) {
    look(kind, owner.id);
    if (!found.empty()) break;
  }
  look(IdKind::email, owner.email);
  if (found.size() > 1) return {{}, "its ids name " + count_of(found.size())};
  if (found.size() == 1) {
    const Person& person = people_[*found.begin()];
    const std::string key = keys_of(owner.name).as_spoken;
    const bool other = !key.empty() && !person.keys.as_spoken.empty() && !owner.anonymous &&
                       key != person.keys.as_spoken && key != person.keys.as_sorted;
    if (told.empty() && other)
      told = "its id is " + person.name + "'s on the roster, and its name is " + composed(owner.name) +
             ": perhaps a group's";
    return {*found.begin(), told, other};
  }
  if (owner.anonymous) return {{}, "its code is on no roster"};
  if (owner.name.empty())
    return {{}, "its id" + (owner.id.empty() ? "" : " " + legible(owner.id)) + " is on no roster"};
  if (owner.id.empty())  // perhaps a folder with this name
    for (const IdKind kind : kinds_of(system)) {
      look(kind, owner.name);
      if (found.size() == 1) return {*found.begin(), told};
      if (!found.empty()) return {{}, "its name is an id of " + count_of(found.size())};
    }
  // Canvas's names have lost their comma.
  const NameKeys keys = keys_of(owner.name);
  const Places& places = system == "canvas" ? by_sorted_ : by_spoken_;
  if (const auto at = places.find(keys.as_spoken); at != places.end())
    found.insert(at->second.begin(), at->second.end());
  // People with the same name differ by an id, of whatever kind in the roster.
  std::vector<std::size_t> with_its_id;
  for (const std::size_t place : found)
    if (!owner.id.empty() && std::ranges::count(people_[place].ids, owner.id) > 0)
      with_its_id.push_back(place);
  if (with_its_id.size() == 1) return {with_its_id.front()};
  if (found.size() > 1) return {{}, count_of(found.size()) + " bear its name"};
  if (found.empty()) return {{}, "its name is on no roster"};
  // If the roster has another id for the person of this name, it is another person.
  const Person& person = people_[*found.begin()];
  for (const IdKind kind : kinds_of(system)) {
    if (owner.id.empty() || person.id(kind).empty()) continue;
    return {{},
            "its name is " + person.name + "'s on the roster, whose " + title_of(kind) + " is " +
                legible(person.id(kind)) + " and not " + legible(owner.id)};
  }
  if (!owner.email.empty() && !person.email().empty())
    return {{}, "its name is " + person.name + "'s on the roster, with another e-mail"};
  return {*found.begin(), "found by its name alone: " + person.name};
}

const char* Roster::column_for(const std::string& system) {
  return title_of(kinds_of(system).front());
}

Roster::Match Roster::find(const Person& person) const {
  std::set<std::size_t> found;
  std::string told;
  for (std::size_t i = 0; i < kIdKinds; ++i)
    for (const std::size_t place : with_id(static_cast<IdKind>(i), person.ids[i], told)) found.insert(place);
  if (found.size() == 1) return {*found.begin(), told};
  return {{},
          found.empty() ? person.name + " of the roster has no id in it"
                        : "the ids of " + person.name + " on the roster name " + count_of(found.size())};
}

std::vector<std::size_t> Roster::find_all(const Owner& owner, const std::string& system, const Roster* roster,
                                          std::vector<std::string>& told) const {
  std::vector<std::size_t> found;
  for (const Owner& one : owner.members.empty() ? std::vector{owner} : owner.members) {
    Match match = find(one, system);
    if (!match.person && roster)
      if (const Match on_roster = roster->find(one, system); on_roster.person)
        match = find(roster->people()[*on_roster.person]);
    if (!match.told.empty()) told.push_back(match.told);
    if (match.person) found.push_back(*match.person);
  }
  return found;
}

}  // namespace grader::roster
