-- STAFF ONLY. Makes version 7 of a record, the first one that this hairgrade reads.
-- Deleting a person deletes their rows in all other tables, except pictures, which several may share.
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
