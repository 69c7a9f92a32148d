// STAFF ONLY. Stores owners and the roster. The list of the class is found anew from both each time.
#include <algorithm>

#include "grader/course/input.h"
#include "grader/record/people_fields.h"
#include "grader/record/record.h"
#include "grader/record/same_people.h"
#include "grader/result/json_fields.h"

namespace grader::inline record {
namespace {

// Keeps the last one of each name.
std::vector<HandIn> with_one_owner(const std::vector<HandIn>& all) {
  std::vector<HandIn> last;
  for (const HandIn& one : all) {
    if (!last.empty() && last.back().name == one.name) last.pop_back();
    last.push_back(one);
  }
  return last;
}

}  // namespace

void Record::put_people(const std::vector<HandIn>& hand_ins, const std::optional<std::vector<Person>>& roster,
                        const std::optional<std::string>& only) {
  Transaction transaction(database_);
  const std::int64_t here = make_assignment();
  const std::vector<std::string> from = grader::drawn_from(read_drawn(), hand_ins);
  for (std::size_t i = 0; i < hand_ins.size(); ++i) {
    const HandIn& hand_in = hand_ins[i];
    if (only && *only != hand_in.name) continue;
    const std::int64_t id = person(hand_in.name, from[i]);
    // Another group may have taken the name of this row.
    database_.run("UPDATE people SET drawn_from = ? WHERE id = ? AND drawn_from <> ?",
                  {from[i], id, from[i]});
    database_.run("UPDATE people SET known_as = ? WHERE id = ?", {hand_in.known_as, id});
    database_.run("INSERT OR REPLACE INTO owners VALUES (?, ?, ?, ?)",
                  {here, id, hand_in.system, json_text(hand_in.owner, -1)});
  }
  if (roster) put_roster(*roster);
  transaction.commit();
}

void Record::put_roster(const std::vector<Person>& roster) {
  database_.run("DELETE FROM roster");
  for (const Person& one : roster)
    database_.run("INSERT INTO roster (person) VALUES (?)", {json_text(one, -1)});
}

// The row has name, owner, system, and the name from intake.
HandIn Record::hand_in_of(const DatabaseRow& row) const {
  const std::string name = row.text(0),
                    where = printable(database_.file().string(), 4096) + ": the owner of " + name;
  return {name, row.is_null(1) ? Owner{} : from_json_text<Owner>(row.text(1), where), row.text(2),
          row.text(3)};
}

// In the course a name may have several owners; the latest one comes last.
std::vector<HandIn> Record::read_hand_ins(Of of) {
  std::vector<HandIn> all;
  database_.each(
      "SELECT people.name, owner, system, known_as FROM people JOIN results ON results.person = people.id "
      "LEFT JOIN owners ON owners.person = people.id AND owners.assignment = results.assignment "
      "JOIN assignments ON assignments.id = results.assignment "
      "WHERE iif(?, instr(assignments.name, char(10)) = 0, results.assignment = ?) ORDER BY people.name, "
      "owners.rowid",
      {std::int64_t{of == Of::course}, assignment()},
      [&](const DatabaseRow& row) { all.push_back(hand_in_of(row)); });
  return all;
}

std::vector<HandIn> Record::hand_ins(Of of) {
  return with_one_owner(read_hand_ins(of));
}

// Lists a name with its owner in each hand-in; this hand-in's owner is the last, or else the latest.
std::vector<Drawn> Record::read_drawn() {
  std::vector<Drawn> all;
  database_.each(
      "SELECT name, owner, system, known_as, drawn_from FROM people LEFT JOIN owners ON owners.person = "
      "people.id ORDER BY name, owners.assignment = ?, owners.rowid",
      {assignment()}, [&](const DatabaseRow& row) {
        all.push_back({hand_in_of(row), row.text(4)});
      });
  return all;
}

std::vector<HandIn> Record::read_owned() {
  std::vector<HandIn> all;
  for (Drawn& one : read_drawn()) all.push_back(std::move(one.hand_in));
  return with_one_owner(all);
}

std::vector<RowName> Record::row_names(const std::vector<HandIn>& hand_ins) {
  return grader::row_names(read_drawn(), hand_ins);
}

std::optional<std::vector<Person>> Record::roster() {
  const std::string where = printable(database_.file().string(), 4096) + ": the roster";
  std::vector<Person> people;
  database_.each("SELECT person FROM roster ORDER BY place", {}, [&](const DatabaseRow& row) {
    people.push_back(from_json_text<Person>(row.text(0), where));
  });
  if (people.empty()) return {};
  return people;
}

std::optional<ClassList> Record::class_list(Of of) {
  const Transaction one_state(database_, Transaction::reads);
  return read_class_list(read_hand_ins(of));
}

std::optional<ClassList> Record::read_class_list(const std::vector<HandIn>& hand_ins) {
  std::optional<std::vector<Person>> people = roster();
  if (!people) return {};
  return grader::class_list(Roster(std::move(*people)), hand_ins);
}

NamesForPeople Record::names_for_people() {
  const Transaction one_state(database_, Transaction::reads);
  if (is_blind()) return {};
  const std::vector<HandIn> all = read_owned();
  return grader::names_for_people(read_class_list(all), all);
}

std::optional<HiddenNames> Record::hidden_names() {
  const Transaction one_state(database_, Transaction::reads);
  if (!is_blind()) return {};
  const std::vector<HandIn> all = read_owned();
  return HiddenNames(all, read_class_list(all));
}

bool Record::is_blind() {
  return database_.number("SELECT blind FROM class") != 0;
}

void Record::set_blind() {
  Transaction transaction(database_);
  if (is_blind()) return;
  if (database_.number("SELECT count(*) FROM results") != 0)
    throw BadInput(printable(database_.file().string(), 4096) +
                   ": its grades have names already; for blind grading name another folder with --out");
  database_.run("UPDATE class SET blind = 1");
  add_to_log({}, "chose blind grading", "");
  transaction.commit();
}

std::map<std::string, std::string> Record::codes() {
  std::map<std::string, std::string> all;
  database_.each("SELECT known_as, name FROM people WHERE known_as <> ''", {},
                 [&](const DatabaseRow& row) { all[row.text(0)] = row.text(1); });
  return all;
}

void Record::forget_on_roster(const std::string& hand_in) {
  const std::optional<ClassList> list = read_class_list(read_hand_ins(Of::course));
  if (!list) return;
  std::vector<Person> people;
  for (const ClassList::Row& row : list->rows)
    if (std::ranges::count(row.hand_ins, hand_in) == 0) people.push_back(row.person);
  if (people.size() < list->rows.size()) put_roster(people);
}

}  // namespace grader::record
