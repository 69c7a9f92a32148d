-- STAFF ONLY. Makes version 9 of 8.
-- In another suite the number of a category may be another category's, so decisions remember the title.
ALTER TABLE decisions ADD COLUMN title TEXT NOT NULL DEFAULT '';  -- '' unless it is about a category
ALTER TABLE decisions ADD COLUMN worth REAL NOT NULL DEFAULT 0;   -- points of its place then; 0: unknown
WITH categories AS (
  SELECT assignment, person, json_extract(exercise.value, '$.id') || '.' || (category.key + 1) AS place,
    json_extract(exercise.value, '$.id') AS exercise, json_extract(category.value, '$.name') AS title,
    json_extract(category.value, '$.max_points') AS worth
  FROM results, json_each(result, '$.exercises') AS exercise,
    json_each(exercise.value, '$.cases') AS category)
UPDATE decisions SET title = now.title, worth = now.worth
  FROM categories AS now
  WHERE now.assignment = decisions.assignment AND now.person = decisions.person
    AND now.place = decisions.place;
-- Comments were decisions with a text of their own; equal ones become one.
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
