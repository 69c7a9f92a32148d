// STAFF ONLY. Stores what people did with the desk's items.
#include "grader/record/desk_rows.h"

#include <algorithm>

namespace grader::inline record {

std::pair<std::int64_t, std::int64_t> DeskRows::state() {
  return record_.database_.changes();
}

std::map<RowOfItem, DeskRow> DeskRows::all() {
  std::map<RowOfItem, DeskRow> rows;
  record_.database_.each(
      "SELECT what, coalesce(name, ''), looks, who, at, owner, open_by, open_at FROM desk_items LEFT JOIN "
      "people ON people.id = person WHERE assignment = ?",
      {record_.assignment()}, [&](const DatabaseRow& row) {
        rows[{row.text(0), row.text(1)}] = {row.text(2), row.text(3), row.text(4),
                                            row.text(5), row.text(6), row.number(7)};
      });
  return rows;
}

// Each change of a result or a decision is in the log; those of all people have an entry without a person.
std::map<std::string, std::int64_t> DeskRows::versions() {
  std::map<std::string, std::int64_t> found;
  record_.database_.each(
      "SELECT name, (SELECT max(id) FROM log WHERE log.person = people.id OR log.person IS NULL) FROM "
      "results "
      "JOIN people ON people.id = person WHERE assignment = ?",
      {record_.assignment()}, [&](const DatabaseRow& row) { found[row.text(0)] = row.number(1); });
  return found;
}

std::int64_t DeskRows::id_of(const RowOfItem& row) {
  const std::int64_t person = row.person.empty() ? 0 : record_.known_person(row.person),
                     here = record_.assignment();
  record_.database_.run("INSERT OR IGNORE INTO desk_items (assignment, person, what) VALUES (?, ?, ?)",
                        {here, person == 0 ? Value(nullptr) : Value(person), row.what});
  return record_.database_.number(
      "SELECT id FROM desk_items WHERE assignment = ? AND ifnull(person, 0) = ? AND what = ?",
      {here, person, row.what});
}

void DeskRows::accept(const RowOfItem& row, const std::string& looks, const std::vector<std::string>& people,
                      const std::string& detail) {
  Transaction transaction(record_.database_);
  record_.database_.run(
      "UPDATE desk_items SET looks = ?, who = ?, at = strftime('%Y-%m-%d %H:%M:%S', 'now') WHERE id = ?",
      {looks, looks.empty() ? "" : record_.who_, id_of(row)});
  for (const std::string& name : people)
    record_.add_to_log(record_.known_person(name), looks.empty() ? "reopened" : "accepted", detail);
  transaction.commit();
}

void DeskRows::set(const std::string& column, const std::map<RowOfItem, std::string>& texts) {
  Transaction transaction(record_.database_);
  for (const auto& [row, text] : texts)
    record_.database_.run("UPDATE desk_items SET " + column + " = ? WHERE id = ?", {text, id_of(row)});
  transaction.commit();
}

void DeskRows::open(const std::optional<RowOfItem>& row, std::int64_t now) {
  Transaction transaction(record_.database_);
  record_.database_.run("UPDATE desk_items SET open_by = '' WHERE assignment = ? AND open_by = ?",
                        {record_.assignment(), record_.who_});
  if (row)
    record_.database_.run("UPDATE desk_items SET open_by = ?, open_at = ? WHERE id = ?",
                          {record_.who_, now, id_of(*row)});
  transaction.commit();
}

}  // namespace grader::record
