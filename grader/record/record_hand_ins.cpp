// STAFF ONLY. Computes the common data of a record's hand-ins: their order, the course's free days, and
// totals. Stores the files of the input that reached no hand-in.
#include <algorithm>

#include "grader/record/points/zone.h"
#include "grader/record/record.h"

namespace grader::inline record {

struct Record::Dated {
  std::int64_t id = 0;
  std::string name;
  HandInRules rules;
  std::chrono::sys_seconds due{};
};

std::vector<Record::Dated> Record::dated() {
  std::vector<Dated> all;
  database_.each("SELECT id, name, rules FROM assignments WHERE instr(name, char(10)) = 0 ORDER BY name", {},
                 [&](const DatabaseRow& row) {
                   Dated one{row.number(0), row.text(1), rules_from(row.text(2))};
                   const std::optional<TimeText> due = read_time(one.rules.due);
                   one.due =
                       due ? moment_of(*due, one.rules.zone, Twice::later) : std::chrono::sys_seconds::max();
                   all.push_back(std::move(one));
                 });
  std::ranges::stable_sort(all, {}, &Dated::due);
  return all;
}

std::vector<std::string> Record::named_hand_ins() {
  std::vector<std::string> names;
  for (const Dated& one : dated())
    if (!one.name.empty()) names.push_back(one.name);
  return names;
}

HandedIn Record::handed_in(std::int64_t assignment, const std::string& name) {
  HandedIn latest;
  database_.each(
      "SELECT handed_in, files, marked_late FROM hand_ins JOIN people ON people.id = person WHERE assignment "
      "= ? AND name = ? ORDER BY hand_ins.id DESC LIMIT 1",
      {assignment, name}, [&](const DatabaseRow& row) {
        latest = {row.text(0), row.text(1), row.number(2) != 0};
      });
  return latest;
}

std::string Record::handed_in(const std::string& name) {
  return handed_in(assignment(), name).time;
}

std::string Record::set_handed_in(const std::string& name, const HandedIn& handed_in) {
  Transaction transaction(database_);
  const std::int64_t here = assignment(), id = known_person(name);
  const HandedIn before = this->handed_in(here, name);
  HandedIn now = handed_in;
  if (now.time.empty()) now.time = before.time;
  if (now == before) return before.time;
  leave_stage(id);
  database_.run(
      "UPDATE OR REPLACE hand_ins SET handed_in = ?, files = ?, marked_late = ? WHERE id = (SELECT max(id) "
      "FROM hand_ins WHERE assignment = ? AND person = ?)",
      {now.time, now.files, std::int64_t{now.marked_late}, here, id});
  if (now.time != before.time) add_to_log(id, "was handed in", now.time);
  transaction.commit();
  return before.time;
}

double Record::days_given(std::int64_t assignment, const std::string& name) {
  double days = 0;
  database_.each(
      "SELECT number FROM decisions JOIN people ON people.id = person WHERE assignment = ? AND name = ? AND "
      "kind = ?",
      {assignment, name, to_string(DecisionKind::late_days)},
      [&](const DatabaseRow& row) { days = row.real(0); });
  return days;
}

// Earlier hand-ins have used the rest, whatever was graded first.
int Record::free_days_left(const HandInRules& rules, const std::string& name) {
  int left = rules.free_days_in_all;
  if (left == 0) return 0;
  for (const Dated& other : dated()) {
    if (other.name == hand_in_) break;
    if (other.rules.due.empty()) continue;
    const int late = late_days(other.rules, handed_in(other.id, name).time).value_or(0);
    left -= used_of_all(other.rules, late, {days_given(other.id, name), left});
  }
  return left;
}

std::map<std::string, Record::Total> Record::totals() {
  const std::vector<std::string> all = names();
  const Transaction one_state(database_, Transaction::reads);
  const HandInRules rules = stored_rules();
  std::map<std::string, Total> totals;
  for (const std::string& name : all)
    if (std::optional<Recorded> found = read(name, false)) {
      const SubmissionResult result = under_rules(std::move(found->result), rules, {});
      totals[name] = {points(result), max_points(result), extra_credit_counted(result)};
    }
  return totals;
}

void Record::set_listed(const std::vector<Accounted>& listed) {
  Transaction transaction(database_);
  const std::int64_t assignment = make_assignment();
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
  std::vector<Accounted> all;
  database_.each(
      "SELECT listed_as, path, reason, coalesce(name, '') FROM listed_files LEFT JOIN people ON people.id = "
      "person WHERE assignment = ? ORDER BY place",
      {assignment()}, [&](const DatabaseRow& row) {
        using enum Accounted::As;
        for (const Accounted::As as : {made, older, left_over, notice})
          if (to_string(as) == row.text(0)) all.push_back({row.text(1), as, row.text(2), row.text(3)});
      });
  return all;
}

}  // namespace grader::record
