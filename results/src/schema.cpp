#include "schema.hpp"

namespace deixis::results {

namespace {

constexpr const char* version_1 = R"sql(
CREATE TABLE study (
    id           INTEGER PRIMARY KEY CHECK (id = 1), -- one study a database
    name         TEXT NOT NULL,
    title        TEXT NOT NULL,
    hash         TEXT NOT NULL,
    source       TEXT,
    alpha        REAL NOT NULL,
    rating_steps INTEGER NOT NULL
) STRICT;

CREATE TABLE systems (
    position  INTEGER PRIMARY KEY,
    name      TEXT NOT NULL UNIQUE,
    generator TEXT,
    manifest  TEXT
) STRICT;

CREATE TABLE layouts (
    position    INTEGER PRIMARY KEY,
    name        TEXT NOT NULL UNIQUE,
    viewer_x_m  REAL NOT NULL,
    viewer_z_m  REAL NOT NULL,
    heading_deg REAL NOT NULL
) STRICT;

CREATE TABLE participants (
    id TEXT PRIMARY KEY
) STRICT, WITHOUT ROWID;

CREATE TABLE plans (
    participant TEXT PRIMARY KEY REFERENCES participants (id),
    seed        TEXT NOT NULL,
    hash        TEXT NOT NULL,
    json        TEXT NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE trials (
    participant  TEXT NOT NULL REFERENCES plans (participant),
    trial_index  INTEGER NOT NULL,
    stage        TEXT NOT NULL CHECK (stage IN ('naturalness', 'game')),
    practice     INTEGER NOT NULL CHECK (practice IN (0, 1)),
    system       TEXT NOT NULL REFERENCES systems (name),
    target_id    TEXT NOT NULL,
    layout       TEXT NOT NULL REFERENCES layouts (name),
    target_x_m   REAL NOT NULL,
    target_y_m   REAL NOT NULL,
    target_z_m   REAL NOT NULL,
    distractors  TEXT NOT NULL,
    balls        TEXT,
    target_place INTEGER,
    PRIMARY KEY (participant, trial_index),
    CHECK ((stage = 'game') = (balls IS NOT NULL)),
    CHECK ((stage = 'game') = (target_place IS NOT NULL))
) STRICT, WITHOUT ROWID;

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
    outcome         TEXT CHECK (outcome IN ('finished', 'quit')),
    UNIQUE (id, participant),
    CHECK ((ended_utc_s IS NULL) = (outcome IS NULL))
) STRICT;

CREATE TABLE responses (
    id               INTEGER PRIMARY KEY,
    participant      TEXT NOT NULL,
    trial_index      INTEGER NOT NULL,
    session          INTEGER NOT NULL,
    clip_file        TEXT NOT NULL,
    clip_hash        TEXT NOT NULL,
    rating           INTEGER,
    chosen_place     INTEGER,
    correct          INTEGER CHECK (correct IN (0, 1)),
    onset_s          REAL NOT NULL,
    onset_utc_s      REAL NOT NULL,
    motion_end_s     REAL NOT NULL,
    motion_end_utc_s REAL NOT NULL,
    answered_s       REAL NOT NULL,
    answered_utc_s   REAL NOT NULL,
    response_time_s  REAL NOT NULL,
    replays          INTEGER NOT NULL,
    pauses           INTEGER NOT NULL,
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
    UNIQUE (participant, trial_index),
    FOREIGN KEY (participant, trial_index) REFERENCES trials (participant, trial_index),
    FOREIGN KEY (session, participant) REFERENCES sessions (id, participant),
    CHECK ((rating IS NULL) <> (chosen_place IS NULL)),
    CHECK ((chosen_place IS NULL) = (correct IS NULL))
) STRICT;

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
)sql";

constexpr const char* version_2 = R"sql(
CREATE TABLE session_properties (
    session INTEGER NOT NULL REFERENCES sessions (id),
    name    TEXT NOT NULL,
    value   TEXT NOT NULL,
    PRIMARY KEY (session, name)
) STRICT, WITHOUT ROWID;

-- With a row number of its own, not WITHOUT ROWID: rows this long are then written in less space and time.
CREATE TABLE tracking (
    session        INTEGER NOT NULL REFERENCES sessions (id),
    frame          INTEGER NOT NULL,
    trial_index    INTEGER,
    display_time_s REAL NOT NULL,
    begun_s        REAL NOT NULL,
    submitted_s    REAL NOT NULL,
    dropped_frames INTEGER NOT NULL,
    rendered       INTEGER NOT NULL CHECK (rendered IN (0, 1)),
    off_place_m    REAL NOT NULL,
    head_validity INTEGER NOT NULL,
    head_x_m REAL, head_y_m REAL, head_z_m REAL, head_qw REAL, head_qx REAL, head_qy REAL, head_qz REAL,
    left_aim_validity INTEGER NOT NULL,
    left_aim_x_m REAL, left_aim_y_m REAL, left_aim_z_m REAL,
    left_aim_qw REAL, left_aim_qx REAL, left_aim_qy REAL, left_aim_qz REAL,
    right_aim_validity INTEGER NOT NULL,
    right_aim_x_m REAL, right_aim_y_m REAL, right_aim_z_m REAL,
    right_aim_qw REAL, right_aim_qx REAL, right_aim_qy REAL, right_aim_qz REAL,
    left_grip_validity INTEGER NOT NULL,
    left_grip_x_m REAL, left_grip_y_m REAL, left_grip_z_m REAL,
    left_grip_qw REAL, left_grip_qx REAL, left_grip_qy REAL, left_grip_qz REAL,
    right_grip_validity INTEGER NOT NULL,
    right_grip_x_m REAL, right_grip_y_m REAL, right_grip_z_m REAL,
    right_grip_qw REAL, right_grip_qx REAL, right_grip_qy REAL, right_grip_qz REAL,
    gaze_validity INTEGER,
    gaze_x_m REAL, gaze_y_m REAL, gaze_z_m REAL, gaze_qw REAL, gaze_qx REAL, gaze_qy REAL, gaze_qz REAL,
    UNIQUE (session, frame)
) STRICT;

CREATE INDEX tracking_of_trial ON tracking (session, trial_index);

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

ALTER TABLE responses ADD COLUMN paused_s REAL NOT NULL DEFAULT 0.0;
-- Version 1 kept it only as what the response time lacks.
UPDATE responses SET paused_s = max(0.0, round(answered_s - motion_end_s - response_time_s, 6));
)sql";

constexpr const char* newest_views = R"sql(
DROP VIEW IF EXISTS responses_flat;

CREATE VIEW responses_flat AS
SELECT r.participant, r.trial_index, t.stage, t.practice, t.system, t.layout, t.target_id,
       r.rating, r.chosen_place, t.target_place, r.correct, r.response_time_s, r.replays, r.pauses, r.paused_s,
       r.input, k.dropped_frames, k.samples_missing, k.max_off_place_m,
       r.clip_file, r.clip_hash,
       t.target_x_m, t.target_y_m, t.target_z_m, t.distractors, t.balls,
       l.viewer_x_m, l.viewer_z_m, l.heading_deg,
       r.onset_s, r.motion_end_s, r.answered_s, r.onset_utc_s, r.motion_end_utc_s, r.answered_utc_s,
       strftime('%Y-%m-%dT%H:%M:%fZ', r.answered_utc_s, 'unixepoch') AS answered_utc,
       r.head_x_m, r.head_y_m, r.head_z_m, r.head_qw, r.head_qx, r.head_qy, r.head_qz,
       r.ray_x_m, r.ray_y_m, r.ray_z_m, r.ray_dx, r.ray_dy, r.ray_dz,
       r.session, s.station, s.station_details, s.synthetic, s.program_version, s.avatar_hash
  FROM responses AS r
  JOIN trials AS t ON t.participant = r.participant AND t.trial_index = r.trial_index
  JOIN sessions AS s ON s.id = r.session
  JOIN layouts AS l ON l.name = t.layout
  LEFT JOIN trial_tracking AS k ON k.session = r.session AND k.trial_index = r.trial_index
 ORDER BY r.participant, r.trial_index;
)sql";

}  // namespace

std::vector<const char*> schemaSteps(int from_version) {
    std::vector<const char*> steps;
    if (from_version < 1) steps.push_back(version_1);
    if (from_version < 2) steps.push_back(version_2);
    if (from_version < schema_version) steps.push_back(newest_views);
    return steps;
}

}  // namespace deixis::results
