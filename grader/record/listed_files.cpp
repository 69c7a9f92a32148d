// STAFF ONLY. Stores the files of the input that reached no hand-in.
#include "grader/course/input.h"
#include "grader/record/record.h"

namespace grader::inline record {

void Record::set_listed(const std::vector<Accounted>& listed) {
  const std::lock_guard lock(one_at_a_time_);
  Transaction transaction(database_);
  make_assignment();
  const std::int64_t assignment = this->assignment();
  database_.run("DELETE FROM listed_files WHERE assignment = ?", {assignment});
  for (const Accounted& file : listed) {
    const std::int64_t person = database_.number("SELECT id FROM people WHERE name = ?", {file.whose});
    if (person == 0 && !file.whose.empty()) continue;  // belongs to a student outside this run
    database_.run(
        "INSERT INTO listed_files (assignment, person, listed_as, path, reason) VALUES (?, ?, ?, ?, ?)",
        {assignment, person == 0 ? Value(nullptr) : Value(person), to_string(file.as), file.path,
         file.reason});
  }
  transaction.commit();
}

std::vector<Accounted> Record::listed() {
  const std::lock_guard lock(one_at_a_time_);
  std::vector<Accounted> all;
  database_.each(
      "SELECT listed_as, path, reason, coalesce(name, '') FROM listed_files LEFT JOIN people ON people.id = "
      "person "
      "WHERE assignment = ? ORDER BY place",
      {assignment()}, [&](const DatabaseRow& row) {
        using enum Accounted::As;
        for (const Accounted::As as : {made, older, left_over, notice})
          if (to_string(as) == row.text(0)) all.push_back({row.text(1), as, row.text(2), row.text(3)});
      });
  return all;
}

}  // namespace grader::record
