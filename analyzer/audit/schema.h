// The tables of a store, as a list of steps: a store of an older owlint gets the missing steps. docs/audit.md describes
// the tables for people who read them.
#pragma once

#include <array>

namespace owlint::audit {

inline constexpr int kApplicationId = 0x6f776c74;  // "owlt", for file(1)

/// `PRAGMA user_version` is the number of steps that were made.
inline constexpr std::array kSteps = {
    // 1: runs, files, findings; what is known about each file for the next run.
    R"sql(
CREATE TABLE run (
  id       INTEGER PRIMARY KEY,
  started  TEXT NOT NULL,      -- UTC, as 2026-11-25T23:30:00Z
  seconds  REAL,               -- NULL while it runs
  state    TEXT NOT NULL CHECK (state IN ('running', 'complete', 'interrupted')),
  version  TEXT NOT NULL,      -- of owlint
  tool     TEXT NOT NULL,      -- a hash of the program that ran
  options  TEXT NOT NULL,      -- JSON object: what the command line said
  roots    TEXT NOT NULL,      -- JSON list: the paths that were audited
  shard    TEXT NOT NULL,      -- '' or I/N
  files    INTEGER,            -- programs that there are
  analysed INTEGER,            -- of these, how many were not known from a run before
  errors INTEGER, warnings INTEGER, infos INTEGER,
  new INTEGER, gone INTEGER    -- findings, against the run before
);
CREATE TABLE settings (
  id   INTEGER PRIMARY KEY,
  hash TEXT NOT NULL UNIQUE    -- of the tool, the machine and the options
);
CREATE TABLE file (
  path     TEXT PRIMARY KEY,   -- absolute; the bytes of the file system
  id       INTEGER NOT NULL UNIQUE,
  present  INTEGER NOT NULL DEFAULT 0,  -- one of the last complete run's programs
  stamp    INTEGER NOT NULL DEFAULT 0,  -- tells whether size, times or inode have changed; 0: look at the bytes
  hash     TEXT NOT NULL DEFAULT '',    -- XXH3, 128 bits, of the bytes that were analysed last
  settings INTEGER NOT NULL DEFAULT 0,
  machine  INTEGER NOT NULL DEFAULT 0   -- the machine calls it without a program
) WITHOUT ROWID;
CREATE TABLE content (          -- what a program was, from one run to another
  file INTEGER NOT NULL, since INTEGER NOT NULL, until INTEGER,  -- until: the first run in which it was not so; NULL: it still is
  hash TEXT NOT NULL, bytes INTEGER NOT NULL, lines INTEGER NOT NULL,
  problem TEXT NOT NULL,        -- why it could not be read, or ''
  PRIMARY KEY (file, since)
) WITHOUT ROWID;
CREATE TABLE finding (
  id INTEGER PRIMARY KEY,
  file INTEGER NOT NULL, since INTEGER NOT NULL, until INTEGER,
  first INTEGER NOT NULL,       -- the run that found it first, on whatever line it was then
  code TEXT NOT NULL, rule TEXT NOT NULL, severity TEXT NOT NULL,
  line INTEGER NOT NULL, "column" INTEGER NOT NULL, end_line INTEGER NOT NULL, end_column INTEGER NOT NULL,
  message TEXT NOT NULL, help TEXT NOT NULL, interpreter TEXT NOT NULL,
  stops INTEGER NOT NULL, reach TEXT NOT NULL, scope TEXT NOT NULL,
  fingerprint TEXT NOT NULL,
  record BLOB NOT NULL          -- owlint's own: all of it, with the lines that it points at
);
CREATE INDEX finding_file ON finding (file);
CREATE INDEX finding_since ON finding (since);
CREATE INDEX finding_until ON finding (until);
CREATE TABLE analysis (         -- what the next run need not find out again
  file INTEGER PRIMARY KEY,
  run INTEGER NOT NULL, seconds REAL NOT NULL, bytes INTEGER NOT NULL, lines INTEGER NOT NULL,
  record BLOB NOT NULL
);
CREATE INDEX analysis_run ON analysis (run);
CREATE TABLE fact (             -- what analyses rest on besides the program's bytes
  id INTEGER PRIMARY KEY,
  kind INTEGER NOT NULL,        -- 0 to 3: what a search path answered; 4: what bytes a file has
  subject TEXT NOT NULL,        -- the folders of the search path, or the file
  name TEXT NOT NULL,
  answer TEXT NOT NULL,
  stamp INTEGER NOT NULL DEFAULT 0
);
CREATE TABLE rests_on (
  file INTEGER NOT NULL, fact INTEGER NOT NULL,
  PRIMARY KEY (file, fact)
) WITHOUT ROWID;
CREATE INDEX rests_on_fact ON rests_on (fact);
CREATE TABLE machine (          -- what is wrong with INIs
  record BLOB NOT NULL
);
)sql",
    // 2: for people.
    R"sql(
CREATE VIEW current AS
  SELECT file.path, finding.code, finding.rule, finding.severity, finding.line, finding."column", finding.message,
         finding.stops, finding.scope, finding.first, finding.fingerprint
  FROM finding JOIN file ON file.id = finding.file WHERE finding.until IS NULL;
CREATE VIEW program AS
  SELECT file.path, content.bytes, content.lines, content.hash, content.since, content.problem, analysis.seconds
  FROM content JOIN file ON file.id = content.file LEFT JOIN analysis ON analysis.file = content.file WHERE content.until IS NULL;
)sql",
};

}  // namespace owlint::audit
