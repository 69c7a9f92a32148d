// STAFF ONLY. Gathers a regrade's results in a stage, and puts them in the place of the old ones at once.
#include "grader/record/record.h"
#include "grader/record/schema.h"

namespace grader::inline record {
namespace {

// These tables have a column "assignment", and are a stage's as well.
constexpr const char* kOfAStage[] = {"shown", "results", "hand_ins", "listed_files", "log"};

}  // namespace

void Record::begin_stage(const std::string& made_by) {
  Transaction transaction(database_);
  const std::int64_t stage = make_assignment();
  if (database_.text("SELECT made_by FROM assignments WHERE id = ?", {stage}) != made_by)
    for (const std::string table : kOfAStage)
      database_.run("DELETE FROM " + table + " WHERE assignment = ?", {stage});
  remove_pictures_that_none_shows();
  database_.run("UPDATE assignments SET made_by = ? WHERE id = ?", {made_by, stage});
  transaction.commit();
}

std::vector<std::string> Record::take_stage() {
  Transaction transaction(database_);
  const std::int64_t here = assignment(), stage = stage_of_this();
  std::vector<std::string> missing;
  database_.each(
      "SELECT name FROM results JOIN people ON people.id = person WHERE assignment = ? AND person NOT IN "
      "(SELECT person FROM results WHERE assignment = ?) ORDER BY name",
      {here, stage}, [&](const DatabaseRow& row) { missing.push_back(row.text(0)); });
  if (!missing.empty()) return missing;
  for (const std::string table : {"shown", "results", "listed_files"})
    database_.run("DELETE FROM " + table + " WHERE assignment = ?", {here});
  for (const std::string table : kOfAStage)
    database_.run("UPDATE OR REPLACE " + table + " SET assignment = ? WHERE assignment = ?", {here, stage});
  database_.run(
      "UPDATE assignments SET (made_by, reference_costs, last_run, rules) = (SELECT made_by, "
      "reference_costs, "
      "last_run, rules FROM assignments WHERE id = ?) WHERE id = ?",
      {stage, here});
  database_.run("DELETE FROM assignments WHERE id = ?", {stage});
  follow_categories(here);
  remove_pictures_that_none_shows();
  add_to_log({}, "regraded", "");
  transaction.commit();
  return {};
}

std::int64_t Record::stage_of_this() {
  return database_.number("SELECT id FROM assignments WHERE name = ?", {hand_in_ + kStage});
}

// A newer version, or another time of it, makes the staged result one of the past.
void Record::leave_stage(std::int64_t person) {
  const std::int64_t stage = stage_of_this();
  for (const std::string table : kOfAStage)
    database_.run("DELETE FROM " + table + " WHERE assignment = ? AND person = ?", {stage, person});
}

void Record::follow_categories(std::int64_t assignment, std::int64_t person) {
  for (const std::string table : {"decisions", "commented", "requests"}) {
    // "H2.3 Forces" is no place: without its category the decision waits for a person.
    database_.run(
        "UPDATE OR REPLACE " + table +
            " SET place = place || ' ' || title WHERE assignment = ?1 AND ?2 IN (0, person) AND title "
            "<> '' AND instr(place, ' ') = 0",
        {assignment, person});
    database_.run(
        kWithCategories + ("UPDATE OR REPLACE " + table) +
            " AS old SET place = now.place FROM categories AS now WHERE old.assignment = ?1 AND ?2 IN "
            "(0, old.person) AND now.assignment = ?1 AND now.person = old.person AND now.title = "
            "old.title AND instr(old.place, now.exercise || '.') = 1",
        {assignment, person});
  }
}

}  // namespace grader::record
