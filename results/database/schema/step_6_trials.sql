-- From version 5 to 6, after step_6.sql: SQLite drops no column that a check of the table names. (PostgreSQL does.)
CREATE TABLE trials_of_6 (
    participant    TEXT NOT NULL REFERENCES plans (participant),
    trial_index    INTEGER NOT NULL,
    stage          TEXT NOT NULL REFERENCES stages (name),
    kind           TEXT NOT NULL,
    practice       INTEGER NOT NULL CHECK (practice IN (0, 1)),
    attempt        INTEGER NOT NULL,
    page           INTEGER NOT NULL,
    layout         TEXT REFERENCES layouts (name),
    distance       TEXT REFERENCES distances (name),
    target_id      TEXT,
    target_x_m     REAL,
    target_y_m     REAL,
    target_z_m     REAL,
    check_kind     TEXT CHECK (check_kind IN ('number', 'catch', 'repeat')),
    check_stimulus INTEGER,
    check_expected REAL,
    check_of_trial INTEGER,
    visibility     TEXT,
    angles         TEXT,
    PRIMARY KEY (participant, trial_index)
) STRICT, WITHOUT ROWID;
INSERT INTO trials_of_6 SELECT participant, trial_index, stage, kind, practice, attempt, page, layout, distance, target_id, target_x_m, target_y_m, target_z_m, check_kind, check_stimulus, check_expected, check_of_trial, visibility, angles FROM trials;
DROP TABLE trials;
ALTER TABLE trials_of_6 RENAME TO trials;
