-- The tables of the newest version; documented column by column in docs/database.md. What server_schema.cpp makes of
-- them for PostgreSQL is made from this text: a new type or function here must be known there. A new column stands
-- last in its table, as ALTER TABLE puts it.

-- What a study is. One study a database.
CREATE TABLE study (
    id       INTEGER PRIMARY KEY CHECK (id = 1),
    name     TEXT NOT NULL,
    title    TEXT NOT NULL,
    hash     TEXT NOT NULL,
    source   TEXT,
    alpha    REAL NOT NULL,
    ball_diameter_m REAL,                -- NULL: brought over from an older version
    locked_hash TEXT,                    -- of all that a participant sees or that decides it; NULL: not locked
    analysis TEXT                        -- the other keys of [analysis], JSON; NULL: brought over from an older version
) STRICT;

CREATE TABLE stages (
    position    INTEGER PRIMARY KEY,
    name        TEXT NOT NULL UNIQUE,
    kind        TEXT NOT NULL,           -- as in the study file
    sitting     INTEGER NOT NULL,        -- Stage::session
    practice_of TEXT,
    measure     TEXT,                    -- rating kinds
    scale_low   INTEGER,
    scale_high  INTEGER,
    question    TEXT
) STRICT;

CREATE TABLE systems (
    position  INTEGER PRIMARY KEY,
    name      TEXT NOT NULL UNIQUE,
    generator TEXT,
    manifest  TEXT,
    levels    TEXT NOT NULL DEFAULT '{}' -- JSON object, factor -> level
) STRICT;

CREATE TABLE layouts (
    position    INTEGER PRIMARY KEY,
    name        TEXT NOT NULL UNIQUE,
    viewer_x_m  REAL NOT NULL,
    viewer_z_m  REAL NOT NULL,
    heading_deg REAL NOT NULL
) STRICT;

CREATE TABLE distances (
    position    INTEGER PRIMARY KEY,
    name        TEXT NOT NULL UNIQUE,
    low_m       REAL NOT NULL,
    high_m      REAL NOT NULL,
    distractors INTEGER NOT NULL
) STRICT;

CREATE TABLE questions (                 -- of questionnaires, rating, confidence, reasons
    stage    TEXT NOT NULL REFERENCES stages (name),
    question TEXT NOT NULL,
    position INTEGER NOT NULL,
    kind     TEXT NOT NULL,              -- scale, choice, choices, number, text
    text     TEXT NOT NULL,
    low      REAL,
    high     REAL,
    options  TEXT,                       -- JSON array of {id, text}
    labels   TEXT,                       -- of a scale's steps, or of its ends: JSON array; NULL: none
    PRIMARY KEY (stage, question)
) STRICT, WITHOUT ROWID;

CREATE TABLE scores (                    -- of questionnaires
    stage    TEXT NOT NULL REFERENCES stages (name),
    name     TEXT NOT NULL,
    position INTEGER NOT NULL,
    items    TEXT NOT NULL,              -- JSON array of question ids
    reversed TEXT NOT NULL,              -- JSON array
    mean     INTEGER NOT NULL CHECK (mean IN (0, 1)),
    factor   REAL NOT NULL,
    offset_  REAL NOT NULL,
    PRIMARY KEY (stage, name)
) STRICT, WITHOUT ROWID;

-- Who took part.
CREATE TABLE participants (
    id               TEXT PRIMARY KEY,
    number           INTEGER NOT NULL UNIQUE,
    language         TEXT NOT NULL,
    status           TEXT NOT NULL DEFAULT 'active' CHECK (status IN ('active', 'excluded', 'dropped')),
    reason           TEXT,               -- of exclusion or dropping out
    registered_utc_s REAL NOT NULL,
    token            TEXT,               -- drawn at random: stands for the person in withdrawals; NULL before the
                                         -- first session of who was registered before version 5
    CHECK ((status = 'active') = (reason IS NULL))
) STRICT, WITHOUT ROWID;

CREATE TABLE participant_groups (
    participant TEXT NOT NULL REFERENCES participants (id),
    factor      TEXT NOT NULL,
    level       TEXT NOT NULL,
    PRIMARY KEY (participant, factor)
) STRICT, WITHOUT ROWID;

CREATE TABLE participant_fields (        -- age, gender, ...: the answers of stages about the participant
    participant TEXT NOT NULL REFERENCES participants (id),
    field       TEXT NOT NULL,
    value       REAL,
    text        TEXT,
    PRIMARY KEY (participant, field)
) STRICT, WITHOUT ROWID;

CREATE TABLE withdrawals (               -- nothing of the person is left but that there was one
    id    INTEGER PRIMARY KEY,
    utc_s REAL NOT NULL,
    token TEXT,                          -- the participant's: copies elsewhere are erased by it; NULL before version 5
    cleared INTEGER NOT NULL DEFAULT 1 CHECK (cleared IN (0, 1)) -- 0: free pages and log still hold traces
) STRICT;

-- What was planned.
CREATE TABLE plans (
    participant TEXT PRIMARY KEY REFERENCES participants (id),
    seed        TEXT NOT NULL,
    hash        TEXT NOT NULL,
    json        TEXT NOT NULL,
    locked_hash TEXT                     -- of the locked set that the plan was made from
) STRICT, WITHOUT ROWID;

CREATE TABLE trials (
    participant    TEXT NOT NULL REFERENCES plans (participant),
    trial_index    INTEGER NOT NULL,
    stage          TEXT NOT NULL REFERENCES stages (name),
    kind           TEXT NOT NULL,
    practice       INTEGER NOT NULL CHECK (practice IN (0, 1)),
    attempt        INTEGER NOT NULL,
    page           INTEGER NOT NULL,
    layout         TEXT REFERENCES layouts (name),
    distance       TEXT REFERENCES distances (name),
    target_id      TEXT,                 -- the item; NULL on pages
    target_x_m     REAL,
    target_y_m     REAL,
    target_z_m     REAL,
    check_kind     TEXT CHECK (check_kind IN ('number', 'catch', 'repeat')),
    check_stimulus INTEGER,
    check_expected REAL,
    check_of_trial INTEGER,
    visibility     TEXT,                 -- JSON: what is seen of each ball
    angles         TEXT,                 -- JSON: how far the distractors look from the target
    PRIMARY KEY (participant, trial_index)
) STRICT, WITHOUT ROWID;

CREATE TABLE trial_values (              -- what a trial's kind plans beside: its declaration says what and of which type
    participant TEXT NOT NULL,
    trial_index INTEGER NOT NULL,
    name        TEXT NOT NULL,
    value       REAL,
    text        TEXT,
    PRIMARY KEY (participant, trial_index, name),
    FOREIGN KEY (participant, trial_index) REFERENCES trials (participant, trial_index),
    CHECK ((value IS NULL) <> (text IS NULL))
) STRICT, WITHOUT ROWID;

CREATE TABLE trial_stimuli (
    participant TEXT NOT NULL,
    trial_index INTEGER NOT NULL,
    position    INTEGER NOT NULL,        -- as shown, from 0; pairwise: 0 left, 1 right
    system      TEXT NOT NULL REFERENCES systems (name),
    item        TEXT NOT NULL,
    scored      INTEGER NOT NULL CHECK (scored IN (0, 1)),
    clip        INTEGER NOT NULL DEFAULT 0, -- which of the system's clips for the item, from 0
    PRIMARY KEY (participant, trial_index, position),
    FOREIGN KEY (participant, trial_index) REFERENCES trials (participant, trial_index)
) STRICT, WITHOUT ROWID;

-- What happened.
CREATE TABLE sessions (
    id              INTEGER PRIMARY KEY,
    participant     TEXT NOT NULL REFERENCES plans (participant),
    station         TEXT NOT NULL,
    station_details TEXT NOT NULL,
    synthetic       INTEGER NOT NULL CHECK (synthetic IN (0, 1)),
    program_version TEXT NOT NULL,
    avatar_hash     TEXT NOT NULL,
    started_utc_s   REAL NOT NULL,
    ended_utc_s     REAL,
    outcome         TEXT CHECK (outcome IN ('finished', 'quit', 'aborted', 'declined', 'excluded')),
    UNIQUE (id, participant),
    CHECK ((ended_utc_s IS NULL) = (outcome IS NULL))
) STRICT;

CREATE TABLE locked_changes (            -- what was changed in a study under way
    id      INTEGER PRIMARY KEY,
    utc_s   REAL NOT NULL,
    what    TEXT NOT NULL,               -- JSON
    reason  TEXT
) STRICT;

CREATE INDEX sessions_of_participant ON sessions (participant);

CREATE TABLE consents (
    participant TEXT NOT NULL REFERENCES participants (id),
    stage       TEXT NOT NULL REFERENCES stages (name),
    session     INTEGER NOT NULL REFERENCES sessions (id),
    agreed      INTEGER NOT NULL CHECK (agreed IN (0, 1)),
    utc_s       REAL NOT NULL,
    language    TEXT NOT NULL,
    text        TEXT NOT NULL,           -- what was agreed to
    PRIMARY KEY (participant, stage, session)
) STRICT, WITHOUT ROWID;

CREATE TABLE session_properties (
    session INTEGER NOT NULL REFERENCES sessions (id),
    name    TEXT NOT NULL,
    value   TEXT NOT NULL,
    PRIMARY KEY (session, name)
) STRICT, WITHOUT ROWID;

CREATE TABLE responses (
    id               INTEGER PRIMARY KEY,
    participant      TEXT NOT NULL,
    trial_index      INTEGER NOT NULL,
    session          INTEGER NOT NULL,
    status           TEXT NOT NULL CHECK (status IN ('answered', 'timed_out', 'skipped')),
    check_passed     INTEGER CHECK (check_passed IN (0, 1)),
    onset_s          REAL NOT NULL,
    onset_utc_s      REAL NOT NULL,
    motion_end_s     REAL NOT NULL,
    motion_end_utc_s REAL NOT NULL,
    answered_s       REAL NOT NULL,
    answered_utc_s   REAL NOT NULL,
    response_time_s  REAL NOT NULL,
    paused_s         REAL NOT NULL,
    replays          INTEGER NOT NULL,
    pauses           INTEGER NOT NULL,
    begun_before     INTEGER NOT NULL CHECK (begun_before IN (0, 1)),
    reason           TEXT,
    input            TEXT NOT NULL,
    head_x_m         REAL NOT NULL,
    head_y_m         REAL NOT NULL,
    head_z_m         REAL NOT NULL,
    head_qw          REAL NOT NULL,
    head_qx          REAL NOT NULL,
    head_qy          REAL NOT NULL,
    head_qz          REAL NOT NULL,
    ray_x_m          REAL,
    ray_y_m          REAL,
    ray_z_m          REAL,
    ray_dx           REAL,
    ray_dy           REAL,
    ray_dz           REAL,
    superseded       TEXT,               -- why the trial was done again; NULL: the answer that counts
    superseded_utc_s REAL,
    viewer_x_m       REAL,               -- where the participant was asked to stand
    viewer_z_m       REAL,
    viewer_heading_deg REAL,
    hash             TEXT,               -- SHA-256 of the answer's content; NULL before version 5
    FOREIGN KEY (participant, trial_index) REFERENCES trials (participant, trial_index),
    FOREIGN KEY (session, participant) REFERENCES sessions (id, participant),
    CHECK ((superseded IS NULL) = (superseded_utc_s IS NULL))
) STRICT;

-- A trial has one answer that counts.
CREATE UNIQUE INDEX responses_that_count ON responses (participant, trial_index) WHERE superseded IS NULL;

CREATE INDEX responses_of_participant ON responses (participant, session);

CREATE TABLE response_stimuli (
    response  INTEGER NOT NULL REFERENCES responses (id),
    position  INTEGER NOT NULL,          -- as in trial_stimuli
    clip_file TEXT NOT NULL,
    clip_hash TEXT NOT NULL,
    plays     INTEGER NOT NULL,          -- to the end
    author       TEXT,                   -- who made the clip, and in which trial of theirs: as the manifest says
    author_trial INTEGER,
    PRIMARY KEY (response, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE answers (
    response INTEGER NOT NULL REFERENCES responses (id),
    position INTEGER NOT NULL,           -- order within the response
    question TEXT NOT NULL,              -- rating, preference, confidence, reasons, consent, or a question's id
    stimulus INTEGER,                    -- ratings: which, as in trial_stimuli
    value    REAL,
    text     TEXT,
    PRIMARY KEY (response, position)
) STRICT, WITHOUT ROWID;

CREATE TABLE response_values (           -- what a response's kind keeps beside answers: likewise
    response INTEGER NOT NULL REFERENCES responses (id),
    name     TEXT NOT NULL,
    value    REAL,
    text     TEXT,
    PRIMARY KEY (response, name),
    CHECK ((value IS NULL) <> (text IS NULL))
) STRICT, WITHOUT ROWID;

CREATE TABLE events (
    id          INTEGER PRIMARY KEY,
    session     INTEGER NOT NULL REFERENCES sessions (id),
    kind        TEXT NOT NULL,
    trial_index INTEGER,
    time_s      REAL NOT NULL,
    utc_s       REAL NOT NULL,
    detail      TEXT NOT NULL
) STRICT;

CREATE INDEX events_of_session ON events (session);

-- Tracked frames, packed: tracking_blocks.hpp says how. Frames of a block belong to one trial or to none.
CREATE TABLE tracking_blocks (
    id                   INTEGER PRIMARY KEY,
    session              INTEGER NOT NULL REFERENCES sessions (id),
    trial_index          INTEGER,
    first_frame          INTEGER NOT NULL,
    frames               INTEGER NOT NULL,
    first_display_time_s REAL NOT NULL,
    last_display_time_s  REAL NOT NULL,
    data                 BLOB NOT NULL,
    UNIQUE (session, first_frame)
) STRICT;

CREATE INDEX tracking_of_trial ON tracking_blocks (session, trial_index);

CREATE TABLE hand_joints (
    session INTEGER NOT NULL REFERENCES sessions (id),
    frame   INTEGER NOT NULL,
    hand    TEXT NOT NULL CHECK (hand IN ('left', 'right')),
    joints  BLOB NOT NULL,
    flags   BLOB NOT NULL,
    UNIQUE (session, frame, hand),
    CHECK (length(joints) = 32 * length(flags))
) STRICT;

CREATE TABLE trial_tracking (
    session               INTEGER NOT NULL REFERENCES sessions (id),
    trial_index           INTEGER NOT NULL,
    frames                INTEGER NOT NULL,
    dropped_frames        INTEGER NOT NULL,
    samples_missing       INTEGER NOT NULL,
    max_off_place_m       REAL NOT NULL,
    head_untracked_frames INTEGER NOT NULL,
    first_display_time_s  REAL NOT NULL,
    last_display_time_s   REAL NOT NULL,
    PRIMARY KEY (session, trial_index)
) STRICT, WITHOUT ROWID;
