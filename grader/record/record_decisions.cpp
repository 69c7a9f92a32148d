// STAFF ONLY. Stores decisions of people in a record.
#include <algorithm>

#include "grader/course/input.h"
#include "grader/record/points/rules.h"
#include "grader/record/record.h"
#include "grader/result/json_fields.h"

namespace grader::inline record {
namespace {

constexpr std::size_t kDate = std::size("2025-03-04") - 1;

}  // namespace

std::vector<Decision> Record::decisions(const std::string& name) {
  std::vector<Decision> all;
  database_.each(
      "SELECT kind, place, number, computed, why, who, at, title, worth, 0 AS comment, '' FROM decisions "
      "JOIN "
      "people ON people.id = person WHERE assignment = ? AND name = ? UNION ALL SELECT ?, place, points, 0, "
      "text, who, at, title, 0, comment, code FROM commented JOIN comments ON comments.id = comment JOIN "
      "people ON people.id = person WHERE commented.assignment = ? AND name = ? ORDER BY 1, place, comment",
      {assignment(), name, to_string(DecisionKind::comment), assignment(), name},
      [&](const DatabaseRow& row) {
        const std::optional<DecisionKind> kind = decision_kind_from(row.text(0));
        if (!kind) throw BadInput("a decision about " + name + " is \"" + printable(row.text(0)) + "\"");
        all.push_back({*kind, row.text(1), row.real(2), row.real(3), row.text(4), row.text(5), row.text(6),
                       row.text(7), row.real(8), row.number(9), row.text(10)});
      });
  return all;
}

std::vector<std::string> Record::conflicts(const std::string& name) {
  const Transaction one_state(database_, Transaction::reads);
  return grader::conflicts(computed(name), decisions(name));
}

HandInRules Record::rules_from(const std::string& text) const {
  return text.empty()
             ? HandInRules{}
             : from_json_text<HandInRules>(text, printable(database_.file().string(), 4096) + ": rules");
}

HandInRules Record::stored_rules() {
  return rules_from(database_.text("SELECT rules FROM assignments WHERE name = ?", {hand_in_}));
}

HandInRules Record::rules() {
  return with_share(stored_rules());
}

HandInRules Record::with_share(HandInRules rules) {
  if (!rules.extra_credit_share)
    rules.extra_credit_share =
        database_.number("SELECT all_extra_credit FROM class") != 0 ? kAllExtraCredit : kExtraCreditShare;
  return rules;
}

void Record::set_rules(const HandInRules& rules) {
  Transaction transaction(database_);
  if (stored_rules() == rules) return;
  make_assignment();
  const std::string text = json_text(rules, -1);
  database_.run("UPDATE assignments SET rules = ? WHERE name = ?", {text, hand_in_});
  add_to_log({}, "set rules", text);
  transaction.commit();
}

SubmissionResult Record::under_rules(SubmissionResult result, HandInRules rules, const ChangePoints& change,
                                     Lateness* late) {
  rules = with_share(std::move(rules));
  const std::int64_t here = assignment();
  const std::string name = result.name;
  const auto [time, files, marked_late] = handed_in(here, name);
  const MoreDays more{days_given(here, name), free_days_left(rules, name)};
  result = decided(with_by_hand(rules, std::move(result)), decisions(name));
  for (const Request& one : requests(name)) {
    std::string text = "You asked on " + one.at.substr(0, kDate) + ": " + one.text + "\n";
    text += one.is_open() ? "The staff have not answered yet."
                          : "The staff answered on " + one.answered.substr(0, kDate) + ": " + one.answer;
    say(result, {one.place, one.code, text});
  }
  if (change) change(result);
  if (late) {
    *late = lateness(rules, result, time, more);
    late->marked = marked_late;
  }
  return under(rules, std::move(result), time, more);
}

std::optional<Recorded> Record::find_decided(const std::string& name) {
  const Transaction one_state(database_, Transaction::reads);
  std::optional<Recorded> found = read(name);
  if (found) found->result = under_rules(std::move(found->result), stored_rules(), {}, &found->late);
  return found;
}

std::optional<SubmissionResult> Record::find_under(const std::string& name, const HandInRules& rules,
                                                   const ChangePoints& change) {
  const Transaction one_state(database_, Transaction::reads);
  const std::optional<Recorded> found = read(name);
  if (!found) return {};
  return under_rules(found->result, rules, change);
}

SubmissionResult Record::computed(const std::string& name) {
  if (std::optional<Recorded> found = read(name, false))
    return with_by_hand(stored_rules(), std::move(found->result));
  SubmissionResult nothing;
  nothing.name = name;
  return nothing;
}

void Record::decide(const std::string& name, Decision decision) {
  Transaction transaction(database_);
  const std::int64_t id = known_person(name);
  if (decision.comment != 0) {
    const Comment earlier = comment(decision.comment);
    decision.why = earlier.text;
    decision.number = earlier.points;
  }
  check(decision, computed(name), decisions(name));
  if (decision.kind == DecisionKind::comment) {
    put_comment(id, decision);
  } else {
    // Also replaces one about a category that had this number and is gone.
    database_.run(
        "DELETE FROM decisions WHERE assignment = ? AND person = ? AND kind = ? AND instr(place, ? || ' ') = "
        "1",
        {assignment(), id, to_string(decision.kind), decision.place});
    database_.run(
        "INSERT OR REPLACE INTO decisions VALUES (?, ?, ?, ?, ?, ?, ?, ?, strftime('%Y-%m-%d %H:%M:%S', "
        "'now'), ?, ?)",
        {assignment(), id, to_string(decision.kind), decision.place, decision.number, decision.computed,
         decision.why, who_, decision.title, decision.worth});
  }
  add_to_log(id, "decided", decision_text(decision));
  transaction.commit();
}

void Record::undo(const std::string& name, DecisionKind kind, const std::string& place,
                  std::int64_t comment) {
  Transaction transaction(database_);
  const std::int64_t id = known_person(name);
  const std::vector<Decision> all = decisions(name);
  const bool is_only = std::ranges::count(all, kind, &Decision::kind) == 1;
  bool any = false;
  for (const Decision& decision : all)
    if (decision.kind == kind && (decision.place == place || (place.empty() && is_only)) &&
        (comment == 0 || decision.comment == comment)) {
      database_.run("DELETE FROM decisions WHERE assignment = ? AND person = ? AND kind = ? AND place = ?",
                    {assignment(), id, to_string(kind), decision.place});
      database_.run("DELETE FROM commented WHERE person = ? AND comment = ? AND place = ?",
                    {id, decision.comment, decision.place});
      add_to_log(id, "took back", decision_text(decision));
      any = true;
    }
  if (any) return transaction.commit();
  std::string there;
  for (const Decision& one : all)
    there += (there.empty() ? "" : ", ") + to_string(one.kind) + (one.place.empty() ? "" : " " + one.place);
  throw BadInput(name + ": nobody decided about " + to_string(kind) +
                 (place.empty() ? "" : " of " + printable(place)) + "; there is " +
                 (there.empty() ? "nothing" : there));
}

}  // namespace grader::record
