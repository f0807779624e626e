-- From version 5 to 6: what one kind of trial keeps moves to tables that take any kind's. Understood by SQLite and, as
-- server_schema.cpp rewrites it, by PostgreSQL.
CREATE TABLE trial_values (
    participant TEXT NOT NULL,
    trial_index INTEGER NOT NULL,
    name        TEXT NOT NULL,
    value       REAL,
    text        TEXT,
    PRIMARY KEY (participant, trial_index, name),
    FOREIGN KEY (participant, trial_index) REFERENCES trials (participant, trial_index),
    CHECK ((value IS NULL) <> (text IS NULL))
) STRICT, WITHOUT ROWID;
CREATE TABLE response_values (
    response INTEGER NOT NULL REFERENCES responses (id),
    name     TEXT NOT NULL,
    value    REAL,
    text     TEXT,
    PRIMARY KEY (response, name),
    CHECK ((value IS NULL) <> (text IS NULL))
) STRICT, WITHOUT ROWID;

INSERT INTO trial_values (participant, trial_index, name, text)
    SELECT participant, trial_index, 'distractors', distractors FROM trials WHERE distractors IS NOT NULL;
INSERT INTO trial_values (participant, trial_index, name, text)
    SELECT participant, trial_index, 'balls', balls FROM trials WHERE balls IS NOT NULL;
INSERT INTO trial_values (participant, trial_index, name, value)
    SELECT participant, trial_index, 'target_place', target_place FROM trials WHERE target_place IS NOT NULL;
INSERT INTO response_values (response, name, value)
    SELECT id, 'chosen_place', chosen_place FROM responses WHERE chosen_place IS NOT NULL;
INSERT INTO response_values (response, name, value)
    SELECT id, 'correct', correct FROM responses WHERE correct IS NOT NULL;

ALTER TABLE responses DROP COLUMN chosen_place;
ALTER TABLE responses DROP COLUMN correct;
