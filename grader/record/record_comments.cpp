// STAFF ONLY. Stores comments and requests in a record.
#include <algorithm>

#include "grader/course/input.h"
#include "grader/record/record.h"

namespace grader::inline record {
namespace {

void check_text(const std::string& text, const std::string& what) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw BadInput("the " + what + " is empty; write one");
}

template <class T>
T with_id(std::vector<T> all, std::int64_t id, const std::string& what) {
  const auto found = std::ranges::find(all, id, &T::id);
  if (found == all.end())
    throw BadInput("there is no " + what + " " + std::to_string(id) + "; `hairgrade " + what +
                   "s` lists them");
  return std::move(*found);
}

}  // namespace

std::string who_have(const Comment& comment) {
  std::string all;
  for (const CommentUse& use : comment.uses)
    all += (all.empty() ? "" : ", ") + use.name + (use.place.empty() ? "" : " " + use.place);
  return all.empty() ? "nobody" : all;
}

std::vector<Comment> Record::comments() {
  std::vector<Comment> all;
  database_.each(
      "SELECT comments.id, text, points, name, place, code, who, at FROM comments LEFT JOIN commented ON "
      "comment = comments.id LEFT JOIN people ON people.id = person WHERE comments.assignment = ? ORDER BY "
      "comments.id, name, place",
      {assignment()}, [&](const DatabaseRow& row) {
        if (all.empty() || all.back().id != row.number(0))
          all.push_back({row.number(0), row.text(1), row.real(2)});
        if (!row.is_null(3))
          all.back().uses.push_back({row.text(3), row.text(4), row.text(5), row.text(6), row.text(7)});
      });
  return all;
}

Comment Record::comment(std::int64_t id) {
  return with_id(comments(), id, "comment");
}

// Finds the comment by its id, or by text and points, or makes it.
void Record::put_comment(std::int64_t person, Decision& decision) {
  if (decision.comment == 0)
    decision.comment =
        database_.number("SELECT min(id) FROM comments WHERE assignment = ? AND text = ? AND points = ?",
                         {assignment(), decision.why, decision.number});
  if (decision.comment == 0) {
    database_.run("INSERT INTO comments (assignment, text, points) VALUES (?, ?, ?)",
                  {assignment(), decision.why, decision.number});
    decision.comment = database_.number("SELECT last_insert_rowid()");
  }
  database_.run(
      "INSERT OR REPLACE INTO commented VALUES (?, ?, ?, ?, ?, ?, ?, strftime('%Y-%m-%d %H:%M:%S', 'now'))",
      {assignment(), decision.comment, person, decision.place, decision.title, decision.code, who_});
}

Comment Record::change_comment(std::int64_t id, const std::string& text, double points) {
  Transaction transaction(database_);
  Comment before = comment(id);
  for (const CommentUse& use : before.uses) {
    Decision now{
        .kind = DecisionKind::comment, .place = use.place, .number = points, .why = text, .comment = id};
    // Its place may be gone since; then only the points of the whole are refused.
    SubmissionResult result = computed(use.name);
    if (!use.place.empty()) now.place = result.exercises.empty() ? "" : result.exercises.front().id;
    check(now, result);
  }
  check_text(text, "comment");
  if (before.text == text && before.points == points) return before;
  database_.run("UPDATE comments SET text = ?, points = ? WHERE id = ?", {text, points, id});
  for (const CommentUse& use : before.uses)
    add_to_log(known_person(use.name), "changed a comment",
               decision_text({.kind = DecisionKind::comment,
                              .place = use.place,
                              .number = points,
                              .why = text,
                              .comment = id}));
  if (before.uses.empty()) add_to_log({}, "changed a comment", std::to_string(id));
  transaction.commit();
  return before;
}

std::vector<Request> Record::requests(const std::string& name) {
  std::vector<Request> all;
  database_.each(
      "SELECT requests.id, name, place, code, text, who, at, answer, answered_by, answered FROM requests "
      "JOIN people ON people.id = person WHERE assignment = ? AND (name = ? OR ? = '') ORDER BY requests.id",
      {assignment(), name, name}, [&](const DatabaseRow& row) {
        all.push_back({row.number(0), row.text(1), row.text(2), row.text(3), row.text(4), row.text(5),
                       row.text(6), row.text(7), row.text(8), row.text(9)});
      });
  return all;
}

std::int64_t Record::ask(const std::string& name, const std::string& place, const std::string& text) {
  Transaction transaction(database_);
  const std::int64_t id = known_person(name);
  check_text(text, "request");
  Decision asked{DecisionKind::comment, place, 0, 0, text};
  check(asked, computed(name));
  for (const Request& one : requests(name))
    if (one.place == place && one.text == text) return 0;
  database_.run(
      "INSERT INTO requests (assignment, person, place, title, code, text, who, at) VALUES (?, ?, ?, ?, ?, "
      "?, ?, "
      "strftime('%Y-%m-%d %H:%M:%S', 'now'))",
      {assignment(), id, place, asked.title, asked.code, text, who_});
  const std::int64_t made = database_.number("SELECT last_insert_rowid()");
  add_to_log(id, "asked", place + (place.empty() ? "" : ": ") + text);
  transaction.commit();
  return made;
}

Request Record::answer(std::int64_t id, const std::string& text) {
  Transaction transaction(database_);
  Request request = with_id(requests(), id, "request");
  if (!request.is_open())
    throw BadInput("request " + std::to_string(id) + ": " + request.answered_by + " answered it on " +
                   request.answered + ", and a request is answered once");
  check_text(text, "answer");
  database_.run(
      "UPDATE requests SET answer = ?, answered_by = ?, answered = strftime('%Y-%m-%d %H:%M:%S', 'now') "
      "WHERE "
      "id = ?",
      {text, who_, id});
  add_to_log(known_person(request.name), "answered", std::to_string(id) + ": " + text);
  transaction.commit();
  return request;
}

}  // namespace grader::record
