// STAFF ONLY. Holds the tables of a record.
#include "grader/record/schema.h"

#include <algorithm>

#include "grader/course/input.h"

namespace grader::inline record {
namespace {

constexpr std::int64_t kApplication = 0x68616972;  // "hair"
constexpr std::int64_t kBaseVersion = 7;           // is that of an empty file's first tables

// Deleting a person deletes their rows in all other tables, except pictures, which several may share.
constexpr const char* kBase = R"(
CREATE TABLE migrations (version INTEGER PRIMARY KEY, at TEXT NOT NULL) STRICT;
CREATE TABLE class (blind INTEGER NOT NULL) STRICT;  -- one row; 1: names of people are codes
INSERT INTO class VALUES (0);
CREATE TABLE assignments (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,      -- '' in a record of one assignment
  made_by TEXT NOT NULL DEFAULT '',         -- JSON, see grading/made_by.h
  reference_costs TEXT NOT NULL DEFAULT '', -- JSON
  last_run TEXT NOT NULL DEFAULT '',        -- JSON
  rules TEXT NOT NULL DEFAULT '',           -- JSON, see rules.h
  folder TEXT NOT NULL DEFAULT ''           -- of its pages, below the record's
) STRICT;
CREATE UNIQUE INDEX folder_of_assignment ON assignments (folder COLLATE NOCASE);
INSERT INTO assignments (name) VALUES ('');
CREATE TABLE people (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL UNIQUE,      -- of files and folders
  drawn_from TEXT NOT NULL,       -- their inputs are; stored at first sight (same_people.h)
  known_as TEXT NOT NULL DEFAULT ''         -- where name is a code: the name that intake found
) STRICT;
CREATE TABLE hand_ins (
  id INTEGER PRIMARY KEY,
  assignment INTEGER NOT NULL REFERENCES assignments,
  person INTEGER NOT NULL REFERENCES people ON DELETE CASCADE,
  origin TEXT NOT NULL,
  fingerprint TEXT NOT NULL,
  handed_in TEXT NOT NULL,        -- as the download says it; '' if it does not
  files TEXT NOT NULL DEFAULT '',           -- their hash; '' in older rows
  marked_late INTEGER NOT NULL DEFAULT 0,   -- 1: by the learning system
  UNIQUE (assignment, person, origin, fingerprint, handed_in)
) STRICT;
CREATE TABLE results (
  assignment INTEGER NOT NULL REFERENCES assignments,
  person INTEGER NOT NULL REFERENCES people ON DELETE CASCADE,
  origin TEXT NOT NULL,
  result TEXT NOT NULL,           -- JSON, pictures by digest
  study TEXT NOT NULL,            -- JSON of it and of the reference's in the same run; '' without
  beside_itself TEXT NOT NULL,
  costs TEXT NOT NULL,            -- JSON
  PRIMARY KEY (assignment, person)
) STRICT, WITHOUT ROWID;
CREATE TABLE pictures (digest TEXT PRIMARY KEY, png BLOB NOT NULL) STRICT, WITHOUT ROWID;
CREATE TABLE shown (
  assignment INTEGER NOT NULL REFERENCES assignments,
  person INTEGER NOT NULL REFERENCES people ON DELETE CASCADE,
  digest TEXT NOT NULL REFERENCES pictures,
  PRIMARY KEY (assignment, person, digest)
) STRICT, WITHOUT ROWID;
CREATE INDEX shown_of_picture ON shown (digest);
CREATE TABLE decisions (
  assignment INTEGER NOT NULL REFERENCES assignments,
  person INTEGER NOT NULL REFERENCES people ON DELETE CASCADE,
  kind TEXT NOT NULL,
  place TEXT NOT NULL,            -- 'H2.3', 'H2', or '' for the whole
  number REAL NOT NULL,           -- points or days
  computed REAL NOT NULL,         -- the points that it was decided against
  why TEXT NOT NULL,
  who TEXT NOT NULL,
  at TEXT NOT NULL,
  PRIMARY KEY (assignment, person, kind, place)
) STRICT, WITHOUT ROWID;
CREATE TABLE log (
  id INTEGER PRIMARY KEY,
  at TEXT NOT NULL,
  who TEXT NOT NULL,
  assignment INTEGER REFERENCES assignments,
  person INTEGER REFERENCES people ON DELETE CASCADE,
  did TEXT NOT NULL,
  detail TEXT NOT NULL
) STRICT;
CREATE INDEX log_of_person ON log (person);
-- A group's members may differ from one hand-in to the next, and each keeps its own.
CREATE TABLE owners (
  assignment INTEGER NOT NULL REFERENCES assignments,
  person INTEGER NOT NULL REFERENCES people ON DELETE CASCADE,
  system TEXT NOT NULL,           -- the layout that the hand-in came in
  owner TEXT NOT NULL,            -- JSON
  PRIMARY KEY (assignment, person)
) STRICT;
CREATE TABLE roster (place INTEGER PRIMARY KEY, person TEXT NOT NULL) STRICT;  -- JSON
CREATE TABLE listed_files (
  place INTEGER PRIMARY KEY,
  assignment INTEGER NOT NULL REFERENCES assignments,
  person INTEGER REFERENCES people ON DELETE CASCADE,  -- null: nobody's
  listed_as TEXT NOT NULL,        -- see intake/archives/accounted.h
  path TEXT NOT NULL,
  reason TEXT NOT NULL
) STRICT;
)";

// Records that began before extra credit had a share keep their totals.
constexpr const char* kExtraCredit = R"(
ALTER TABLE class ADD COLUMN all_extra_credit INTEGER NOT NULL DEFAULT 0;  -- 1: it has no share
UPDATE class SET all_extra_credit = EXISTS (SELECT 1 FROM assignments WHERE made_by <> '' OR rules <> '')
  OR EXISTS (SELECT 1 FROM people);
)";

constexpr const char* kDesk = R"(
CREATE TABLE desk_items (
  id INTEGER PRIMARY KEY,
  assignment INTEGER NOT NULL REFERENCES assignments,
  person INTEGER REFERENCES people ON DELETE CASCADE,  -- null: of several people
  what TEXT NOT NULL,             -- kind and place, see grader/record/desk_rows.h
  looks TEXT NOT NULL DEFAULT '', -- when it was accepted
  who TEXT NOT NULL DEFAULT '',   -- accepted it
  at TEXT NOT NULL DEFAULT '',
  owner TEXT NOT NULL DEFAULT '',
  open_by TEXT NOT NULL DEFAULT '',
  open_at INTEGER NOT NULL DEFAULT 0
) STRICT;
CREATE UNIQUE INDEX desk_item ON desk_items (assignment, ifnull(person, 0), what);
)";

// In another suite the number of a category may be another category's, so decisions remember the title.
constexpr const char* kRegrades = R"(
ALTER TABLE decisions ADD COLUMN title TEXT NOT NULL DEFAULT '';  -- '' unless it is about a category
ALTER TABLE decisions ADD COLUMN worth REAL NOT NULL DEFAULT 0;   -- points of its place then; 0: unknown
)";
constexpr const char* kTitles = R"(UPDATE decisions SET title = now.title, worth = now.worth
  FROM categories AS now
  WHERE now.assignment = decisions.assignment AND now.person = decisions.person AND now.place = decisions.place;
)";

// Comments were decisions with a text of their own; equal ones become one.
constexpr const char* kComments = R"(
CREATE TABLE comments (
  id INTEGER PRIMARY KEY,
  assignment INTEGER NOT NULL REFERENCES assignments,
  text TEXT NOT NULL,
  points REAL NOT NULL            -- given at each of its places, or below 0 taken
) STRICT;
CREATE TABLE commented (
  assignment INTEGER NOT NULL REFERENCES assignments,
  comment INTEGER NOT NULL REFERENCES comments,
  person INTEGER NOT NULL REFERENCES people ON DELETE CASCADE,
  place TEXT NOT NULL,            -- as of decisions, or 'H2:17', a line of its file
  title TEXT NOT NULL,            -- of its category
  code TEXT NOT NULL,             -- that line
  who TEXT NOT NULL,
  at TEXT NOT NULL,
  PRIMARY KEY (person, comment, place)
) STRICT, WITHOUT ROWID;
CREATE INDEX commented_with ON commented (comment);
INSERT INTO comments (assignment, text, points)
  SELECT assignment, why, 0 FROM decisions WHERE kind = 'comment' GROUP BY assignment, why ORDER BY min(at);
INSERT INTO commented SELECT assignment, comments.id, person, place, title, '', who, at FROM decisions
  JOIN comments USING (assignment) WHERE text = why AND kind = 'comment';
DELETE FROM decisions WHERE kind = 'comment';
CREATE TABLE requests (
  id INTEGER PRIMARY KEY,
  assignment INTEGER NOT NULL REFERENCES assignments,
  person INTEGER NOT NULL REFERENCES people ON DELETE CASCADE,
  place TEXT NOT NULL,
  title TEXT NOT NULL,
  code TEXT NOT NULL,
  text TEXT NOT NULL,
  who TEXT NOT NULL,              -- entered it
  at TEXT NOT NULL,
  answer TEXT NOT NULL DEFAULT '',          -- '': it is open
  answered_by TEXT NOT NULL DEFAULT '',
  answered TEXT NOT NULL DEFAULT ''         -- the time
) STRICT;
CREATE INDEX requests_of_person ON requests (person);
)";

}  // namespace

const std::vector<std::string>& migrations() {
  static const std::vector<std::string> all = {
      kBase, kExtraCredit, std::string(kRegrades) + kWithCategories + kTitles + kComments + kDesk};
  return all;
}

void migrate(Database& database, const std::vector<std::string>& steps) {
  const auto version = [&] { return database.number("PRAGMA user_version"); };
  const std::string where = printable(database.file().string(), 4096);
  // One statement sees one state of the file, whoever makes it at this moment.
  if (database.number("SELECT application_id <> ? AND (application_id <> 0 OR (SELECT count(*) FROM "
                      "sqlite_master) <> 0) FROM pragma_application_id",
                      {kApplication}) != 0)
    throw BadInput(where + ": is a database, but no record of grades; name another folder with --out");
  const auto last = kBaseVersion - 1 + static_cast<std::int64_t>(steps.size());
  const std::int64_t found = version();
  if (found > last || (found > 0 && found < kBaseVersion))
    throw BadInput(where + ": has version " + std::to_string(found) + ", and this hairgrade knows " +
                   std::to_string(kBaseVersion) + " to " + std::to_string(last) +
                   "; use the hairgrade that made it");
  while (version() < last) {
    Transaction transaction(database);
    const std::int64_t next = std::max(kBaseVersion, version() + 1);  // another process may have migrated it
    if (next > last) return;
    database.run_all(steps[static_cast<std::size_t>(next - kBaseVersion)]);
    database.run("INSERT INTO migrations VALUES (?, strftime('%Y-%m-%d %H:%M:%S', 'now'))", {next});
    database.run_all("PRAGMA application_id = " + std::to_string(kApplication) +
                     "; PRAGMA user_version = " + std::to_string(next) + ";");
    transaction.commit();
  }
}

}  // namespace grader::record
