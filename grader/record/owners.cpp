// STAFF ONLY. Owners and the roster in the record. What the class looks like is found anew from both each time.
#include "grader/record/owners.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "grader/record/database.h"
#include "grader/record/record.h"
#include "grader/record/schema.h"

namespace grader {
namespace {

using Json = nlohmann::json;

Json json_of(const Owner& owner) {
  Json members = Json::array();
  for (const Owner& member : owner.members) members.push_back(json_of(member));
  return {{"name", owner.name},           {"id", owner.id},       {"email", owner.email},
          {"anonymous", owner.anonymous}, {"group", owner.group}, {"members", members}};
}

Owner owner_from(const Json& json) {
  Owner owner{.name = json.at("name"),
              .id = json.at("id"),
              .email = json.at("email"),
              .anonymous = json.at("anonymous"),
              .group = json.at("group")};
  for (const Json& member : json.at("members")) owner.members.push_back(owner_from(member));
  return owner;
}

Json json_of(const Person& person) {
  return {{"name", person.name},
          {"section", person.section},
          {"ids", person.ids},
          {"spoken", person.keys.as_spoken},
          {"sorted", person.keys.as_sorted}};
}

Person person_from(const Json& json) {
  return {.name = json.at("name"),
          .section = json.at("section"),
          .ids = json.at("ids"),
          .keys = {json.at("spoken"), json.at("sorted")}};
}

Database opened(const std::filesystem::path& folder) {
  Database database(folder / kRecordFile);
  migrate(database);
  return database;
}

}  // namespace

void record_people(const std::filesystem::path& folder, const std::vector<HandIn>& hand_ins,
                   const std::optional<std::vector<Person>>& roster) {
  Database database = opened(folder);
  Transaction transaction(database);
  for (const HandIn& hand_in : hand_ins) {
    database.run("INSERT OR IGNORE INTO people (name, drawn_from) VALUES (?, ?)",
                 {hand_in.name, hand_in.name});
    database.run("INSERT OR REPLACE INTO owners SELECT id, ?, ? FROM people WHERE name = ?",
                 {hand_in.system, json_of(hand_in.owner).dump(), hand_in.name});
  }
  if (roster) {
    database.run("DELETE FROM roster");
    for (const Person& person : *roster)
      database.run("INSERT INTO roster (person) VALUES (?)", {json_of(person).dump()});
  }
  transaction.commit();
}

std::vector<HandIn> recorded_hand_ins(const std::filesystem::path& folder) {
  std::vector<HandIn> all;
  Database database = opened(folder);
  database.each(
      "SELECT name, owner, system FROM people JOIN results ON results.person = people.id LEFT JOIN owners ON "
      "owners.person = people.id ORDER BY name",
      {}, [&](const DatabaseRow& row) {
        all.push_back(
            {row.text(0), row.is_null(1) ? Owner{} : owner_from(Json::parse(row.text(1))), row.text(2)});
      });
  return all;
}

std::optional<ClassList> recorded_class_list(const std::filesystem::path& folder) {
  std::vector<Person> people;
  Database database = opened(folder);
  database.each("SELECT person FROM roster ORDER BY place", {},
                [&](const DatabaseRow& row) { people.push_back(person_from(Json::parse(row.text(0)))); });
  if (people.empty()) return {};
  return class_list(Roster(std::move(people)), recorded_hand_ins(folder));
}

void forget_on_roster(const std::filesystem::path& folder, const std::string& hand_in) {
  const std::optional<ClassList> list = recorded_class_list(folder);
  if (!list) return;
  std::vector<Person> people;
  for (const ClassList::Row& row : list->rows)
    if (std::ranges::count(row.hand_ins, hand_in) == 0) people.push_back(row.person);
  if (people.size() < list->rows.size()) record_people(folder, {}, people);
}

}  // namespace grader
