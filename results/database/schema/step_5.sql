-- From version 4 to 5; migration_5.cpp then gives each participant who has begun a token. Understood by SQLite and, as
-- server_schema.cpp rewrites it, by PostgreSQL.
ALTER TABLE study ADD COLUMN locked_hash TEXT;
ALTER TABLE study ADD COLUMN analysis TEXT;
ALTER TABLE questions ADD COLUMN labels TEXT;
ALTER TABLE plans ADD COLUMN locked_hash TEXT;
ALTER TABLE participants ADD COLUMN token TEXT;
ALTER TABLE trials ADD COLUMN visibility TEXT;
ALTER TABLE trials ADD COLUMN angles TEXT;
ALTER TABLE trial_stimuli ADD COLUMN clip INTEGER NOT NULL DEFAULT 0;
ALTER TABLE response_stimuli ADD COLUMN author TEXT;
ALTER TABLE response_stimuli ADD COLUMN author_trial INTEGER;
ALTER TABLE responses ADD COLUMN viewer_x_m REAL;
ALTER TABLE responses ADD COLUMN viewer_z_m REAL;
ALTER TABLE responses ADD COLUMN viewer_heading_deg REAL;
ALTER TABLE responses ADD COLUMN hash TEXT;

-- Without them each participant's start looks through everybody's sessions and answers.
CREATE INDEX sessions_of_participant ON sessions (participant);
CREATE INDEX responses_of_participant ON responses (participant, session);

CREATE TABLE locked_changes (
    id      INTEGER PRIMARY KEY,
    utc_s   REAL NOT NULL,
    what    TEXT NOT NULL,
    reason  TEXT
) STRICT;

-- A hash of the id gave the person away to whoever tried ids. Written anew, so that none stays in the old place.
CREATE TABLE withdrawals_of_5 (
    id    INTEGER PRIMARY KEY,
    utc_s REAL NOT NULL,
    token TEXT,
    cleared INTEGER NOT NULL DEFAULT 1 CHECK (cleared IN (0, 1))
) STRICT;
INSERT INTO withdrawals_of_5 (id, utc_s) SELECT id, utc_s FROM withdrawals;
DROP TABLE withdrawals;
ALTER TABLE withdrawals_of_5 RENAME TO withdrawals;
