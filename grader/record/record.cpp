// STAFF ONLY. Reads and writes a class's record.
#include "grader/record/record.h"

#include <pwd.h>
#include <unistd.h>

#include <utility>

#include "grader/compile/hash.h"
#include "grader/course/input.h"
#include "grader/record/changes.h"
#include "grader/record/points/hand_ins.h"
#include "grader/record/schema.h"
#include "grader/result/json_fields.h"
#include "grader/result/result_fields.h"

namespace grader::inline record {
namespace {

constexpr const char* kEntered = "entered into a gradebook";

namespace fs = std::filesystem;

// Digests replace pictures in the text; the pictures are in a table of their own.
std::string text_of(const SubmissionResult& result, std::map<std::string, std::string>& pictures) {
  return json_text(result, -1,
                   {[&](const std::string& png) {
                      std::string digest = png.empty() ? "" : sha256(png);
                      if (!png.empty()) pictures.emplace(digest, png);
                      return digest;
                    },
                    {}});
}

template <class T>
std::string compact(const T& value) {
  return json_text(value, -1);
}

}  // namespace

std::string user() {
  const passwd* entry = getpwuid(geteuid());
  return entry ? entry->pw_name : std::to_string(geteuid());
}

bool Record::is_in(const fs::path& folder) {
  std::error_code none;
  return fs::exists(folder / kRecordFile, none);
}

Record::Record(const fs::path& folder, Journal journal) : Record(folder, "", journal) {}

Record::Record(const fs::path& folder, std::string hand_in, Journal journal)
    : hand_in_(std::move(hand_in)), who_(user()), database_(folder / kRecordFile, journal) {
  migrate(database_);
}

fs::path Record::pages() const {
  const fs::path folder = database_.file().parent_path();
  return hand_in_.empty() ? folder : folder / folder_of_hand_in(hand_in_);
}

// Returns 0 until the hand-in has a row: then no other row belongs to it.
std::int64_t Record::assignment() {
  return database_.number("SELECT id FROM assignments WHERE name = ?", {hand_in_});
}

std::int64_t Record::make_assignment() {
  if (const std::int64_t known = assignment(); known != 0) return known;
  const std::string folder = hand_in_.ends_with(kStage) ? hand_in_ : folder_of_hand_in(hand_in_),
                    other = database_.text("SELECT name FROM assignments WHERE folder = ? COLLATE NOCASE",
                                           {folder});
  if (!other.empty())
    throw BadInput(printable(database_.file().string(), 4096) + ": has the folder " + folder + " for \"" +
                   printable(other) + "\"; give \"" + printable(hand_in_) + "\" another name");
  database_.run("INSERT INTO assignments (name, folder) VALUES (?, ?)", {hand_in_, folder});
  return assignment();
}

std::int64_t Record::known_person(const std::string& name) {
  const std::int64_t id = database_.number("SELECT id FROM people WHERE name = ?", {name});
  if (id == 0)
    throw BadInput(printable(name) + ": nobody in " + printable(database_.file().string(), 4096) +
                   " has this name; the names are those of the folders beside it");
  return id;
}

std::int64_t Record::person(const std::string& name, const std::string& drawn_from) {
  database_.run("INSERT OR IGNORE INTO people (name, drawn_from) VALUES (?, ?)", {name, drawn_from});
  return known_person(name);
}

void Record::add_to_log(std::optional<std::int64_t> person, const std::string& did,
                        const std::string& detail) {
  database_.run(
      "INSERT INTO log (at, who, assignment, person, did, detail) VALUES (strftime('%Y-%m-%d %H:%M:%S', "
      "'now'), ?, ?, ?, ?, ?)",
      {who_, assignment(), person ? Value(*person) : Value(nullptr), did, detail});
}

std::string Record::in_one(const std::function<void()>& changes) {
  Transaction transaction(database_);
  std::string made = database_.changes_of(changes);
  transaction.commit();
  return made;
}

bool Record::take_back(const std::string& changes, const std::vector<std::string>& people,
                       const std::string& what) {
  Transaction transaction(database_);
  if (!database_.take_back(changes)) return false;
  for (const std::string& name : people) add_to_log(known_person(name), "took back", what);
  transaction.commit();
  return true;
}

std::string Record::now() {
  return database_.text("SELECT strftime('%Y-%m-%d %H:%M:%S', 'now')");
}

std::string Record::made_by() {
  return database_.text("SELECT made_by FROM assignments WHERE name = ?", {hand_in_});
}

void Record::set_made_by(const std::string& json) {
  Transaction transaction(database_);
  make_assignment();
  database_.run("UPDATE assignments SET made_by = ? WHERE name = ?", {json, hand_in_});
  transaction.commit();
}

std::string Record::drawn_from(const std::string& name) {
  return database_.text("SELECT drawn_from FROM people WHERE id = ?", {known_person(name)});
}

std::string Record::put(const Recorded& one, const HandedIn& handed_in) {
  const SubmissionResult& result = one.result;
  std::map<std::string, std::string> pictures;
  const std::string text = text_of(result, pictures), study = one.study ? compact(*one.study) : "",
                    costs = compact(one.costs);
  Transaction transaction(database_);
  const std::int64_t id = person(result.name, result.name), assignment = make_assignment();
  database_.run("INSERT OR REPLACE INTO results VALUES (?, ?, ?, ?, ?, ?, ?)",
                {assignment, id, result.origin, text, study, "", costs});
  leave_stage(id);
  if (hand_in_.ends_with(kStage))
    database_.run("DELETE FROM log WHERE assignment = ? AND person = ?", {assignment, id});
  // A table of times is not given each time. Older records don't say which files a row had: there the newest
  // one counts, so that nobody becomes later. A stage has the times of its hand-in.
  std::string before;
  const std::string of = hand_in_.substr(0, hand_in_.find('\n'));
  for (const std::string& files : {handed_in.files, std::string()})
    if (before.empty() && !handed_in.files.empty())
      before = database_.text(
          "SELECT handed_in FROM hand_ins JOIN assignments ON assignments.id = assignment WHERE name IN (?, "
          "?) "
          "AND person = ? AND files = ? ORDER BY hand_ins.id DESC LIMIT 1",
          {hand_in_, of, id, files});
  database_.run(
      "INSERT OR REPLACE INTO hand_ins (assignment, person, origin, fingerprint, handed_in, files, "
      "marked_late) VALUES (?, ?, ?, ?, ?, ?, ?)",
      {assignment, id, result.origin, result.fingerprint, handed_in.time.empty() ? before : handed_in.time,
       handed_in.files, std::int64_t{handed_in.marked_late}});
  std::vector<std::string> earlier;  // may have become unused; searching all pictures would take long
  database_.each("SELECT digest FROM shown WHERE assignment = ? AND person = ?", {assignment, id},
                 [&](const DatabaseRow& row) { earlier.push_back(row.text(0)); });
  database_.run("DELETE FROM shown WHERE assignment = ? AND person = ?", {assignment, id});
  for (const auto& [digest, png] : pictures) {
    database_.run("INSERT OR IGNORE INTO pictures VALUES (?, ?)", {digest, Blob{png}});
    database_.run("INSERT INTO shown VALUES (?, ?, ?)", {assignment, id, digest});
  }
  for (const std::string& digest : earlier)
    database_.run(
        "DELETE FROM pictures WHERE digest = ? AND NOT EXISTS (SELECT 1 FROM shown WHERE shown.digest = "
        "pictures.digest)",
        {digest});
  follow_categories(assignment, id);
  add_to_log(id, "graded", compact(points_then(result)));
  transaction.commit();
  return before;
}

void Record::remove_pictures_that_none_shows() {
  database_.run(
      "DELETE FROM pictures WHERE NOT EXISTS (SELECT 1 FROM shown WHERE shown.digest = pictures.digest)");
}

std::vector<std::string> Record::names() {
  std::vector<std::string> all;
  for (const auto& [name, row] : rows()) all.push_back(name);
  return all;
}

std::map<std::string, Record::Row> Record::rows() {
  std::map<std::string, Row> all;
  database_.each(
      "SELECT name, origin, (SELECT files FROM hand_ins WHERE hand_ins.assignment = results.assignment AND "
      "hand_ins.person = results.person ORDER BY id DESC LIMIT 1) FROM results JOIN people ON people.id = "
      "person WHERE assignment = ?",
      {assignment()}, [&](const DatabaseRow& row) {
        all[row.text(0)] = {row.text(1), row.text(2)};
      });
  return all;
}

std::string Record::picture(const std::string& digest) {
  if (digest.empty()) return "";
  std::string png = database_.text("SELECT png FROM pictures WHERE digest = ?", {digest});
  if (sha256(png) != digest) throw BadInput("its picture " + printable(digest) + " is damaged");
  return png;
}

std::optional<Recorded> Record::find(const std::string& name) {
  const Transaction one_state(database_, Transaction::reads);
  return read(name);
}

std::optional<SubmissionResult> Record::find_without_pictures(const std::string& name) {
  std::optional<Recorded> found = read(name, false);
  return found ? std::optional(std::move(found->result)) : std::nullopt;
}

std::optional<Recorded> Record::read(const std::string& name, bool with_pictures) {
  std::string text, study, costs;
  const std::string where = printable(database_.file().string(), 4096) + ": the result of " + name;
  database_.each(
      "SELECT result, study, costs FROM results JOIN people ON people.id = person WHERE "
      "assignment = ? AND name = ?",
      {assignment(), name}, [&](const DatabaseRow& row) {
        text = row.text(0);
        study = row.text(1);
        costs = row.text(2);
      });
  if (text.empty()) return {};
  Recorded one{from_json_text<SubmissionResult>(
      text, where,
      {{}, [&](const std::string& digest) { return with_pictures ? picture(digest) : std::string(); }})};
  one.costs = from_json_text<TimingByExercise>(costs, where);
  if (!study.empty()) one.study = from_json_text<SubmissionStudy>(study, where);
  return one;
}

void Record::set_run(const TimingByExercise& reference, const std::optional<LastRun>& run) {
  Transaction transaction(database_);
  make_assignment();
  database_.run("UPDATE assignments SET reference_costs = ?, last_run = ? WHERE name = ?",
                {compact(reference), compact(run), hand_in_});
  transaction.commit();
}

ClassCosts Record::costs() {
  const std::string where = printable(database_.file().string(), 4096) + ": costs";
  ClassCosts all;
  database_.each("SELECT reference_costs, last_run FROM assignments WHERE name = ?", {hand_in_},
                 [&](const DatabaseRow& row) {
                   if (const std::string text = row.text(0); !text.empty())
                     all.reference = from_json_text<TimingByExercise>(text, where);
                   if (const std::string text = row.text(1); !text.empty())
                     all.last_run = from_json_text<std::optional<LastRun>>(text, where);
                 });
  database_.each("SELECT name, costs FROM results JOIN people ON people.id = person WHERE assignment = ?",
                 {assignment()}, [&](const DatabaseRow& row) {
                   all.submissions[row.text(0)] = from_json_text<TimingByExercise>(row.text(1), where);
                 });
  return all;
}

std::vector<LogEntry> Record::log(const std::string& name) {
  std::vector<LogEntry> all;
  database_.each("SELECT at, who, did, detail FROM log WHERE person = ? AND assignment = ? ORDER BY id",
                 {known_person(name), assignment()}, [&](const DatabaseRow& row) {
                   all.push_back({row.text(0), row.text(1), row.text(2), row.text(3)});
                 });
  return all;
}

void Record::put_entered(const std::vector<std::pair<std::string, std::string>>& cells) {
  Transaction transaction(database_);
  for (const auto& [name, cell] : cells) add_to_log(known_person(name), kEntered, cell);
  transaction.commit();
}

std::vector<std::string> Record::entered(const std::string& name) {
  std::vector<std::string> cells;
  for (LogEntry& entry : log(name))
    if (entry.did == kEntered) cells.push_back(std::move(entry.detail));
  return cells;
}

void Record::forget(const std::string& name) {
  Transaction transaction(database_);
  // Paths of files without an owner may still contain their names.
  database_.run(
      "DELETE FROM listed_files WHERE person IS NULL AND EXISTS (SELECT 1 FROM people LEFT JOIN owners ON "
      "owners.person = people.id WHERE people.name = ? AND (instr(path || reason, people.name) OR instr(path "
      "|| "
      "reason, nullif(json_extract(owner, '$.name'), ''))))",
      {name});
  forget_on_roster(name);
  database_.run("DELETE FROM people WHERE id = ?", {known_person(name)});
  remove_pictures_that_none_shows();
  // A comment that nobody else has may name the person.
  database_.run(
      "DELETE FROM comments WHERE NOT EXISTS (SELECT 1 FROM commented WHERE comment = comments.id)");
  add_to_log({}, "forgot somebody", "");
  transaction.commit();
}

void Record::shred() {
  if (!database_.shred())
    throw BadInput(
        printable(database_.file().string(), 4096) +
        ": another program reads it, so its journal still holds what was deleted; end that one, and "
        "run hairgrade forget without a name");
}

std::optional<SubmissionResult> recorded_result(const fs::path& folder, const std::string& name) {
  if (!Record::is_in(folder)) return {};
  std::optional<Recorded> found = Record(folder).find(name);
  return found ? std::optional(std::move(found->result)) : std::nullopt;
}

}  // namespace grader::record
