-- From version 1 to 2.
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
