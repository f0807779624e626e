-- From version 2 to 3, beside migration_3.cpp: what version 2 holds, in tables renamed to before_3_..., into the tables
-- of version 3. Each stage becomes two (practice is a stage of its own), a rating becomes an answer.

INSERT INTO study SELECT id, name, title, hash, source, alpha, NULL FROM before_3_study;

INSERT INTO systems SELECT position, name, generator, manifest, '{}' FROM before_3_systems;
INSERT INTO layouts SELECT * FROM before_3_layouts;

CREATE TEMP TABLE stage_names (position, stage, practice, name, kind, practice_of);
INSERT INTO stage_names VALUES
    (0, 'naturalness', 1, 'naturalness-practice', 'rating', 'naturalness'),
    (1, 'naturalness', 0, 'naturalness', 'rating', NULL),
    (2, 'game', 1, 'game-practice', 'referential-game', 'game'),
    (3, 'game', 0, 'game', 'referential-game', NULL);

INSERT INTO stages
SELECT n.position, n.name, n.kind, 1, n.practice_of, iif(n.kind = 'rating', 'naturalness', NULL),
       iif(n.kind = 'rating', 1, NULL), iif(n.kind = 'rating', s.rating_steps, NULL), NULL
  FROM stage_names AS n, before_3_study AS s
 WHERE EXISTS (SELECT 1 FROM before_3_trials AS t WHERE t.stage = n.stage AND t.practice = n.practice);
INSERT INTO questions
SELECT name, 'rating', 0, 'scale', '', scale_low, scale_high, NULL FROM stages WHERE kind = 'rating';

INSERT INTO trials
SELECT t.participant, t.trial_index, n.name, n.kind, t.practice, 0, 0, t.layout, NULL,
       t.target_id, t.target_x_m, t.target_y_m, t.target_z_m,
       iif(t.stage = 'game', t.distractors, NULL), t.balls, t.target_place, NULL, NULL, NULL, NULL
  FROM before_3_trials AS t JOIN stage_names AS n ON n.stage = t.stage AND n.practice = t.practice;
INSERT INTO trial_stimuli
SELECT participant, trial_index, 0, system, target_id, NOT practice FROM before_3_trials;

INSERT INTO sessions SELECT * FROM before_3_sessions;
INSERT INTO session_properties SELECT * FROM before_3_session_properties;

INSERT INTO responses
SELECT id, participant, trial_index, session, 'answered', chosen_place, correct, NULL,
       onset_s, onset_utc_s, motion_end_s, motion_end_utc_s, answered_s, answered_utc_s,
       response_time_s, paused_s, replays, pauses, 0, NULL, input,
       head_x_m, head_y_m, head_z_m, head_qw, head_qx, head_qy, head_qz,
       ray_x_m, ray_y_m, ray_z_m, ray_dx, ray_dy, ray_dz, NULL, NULL
  FROM before_3_responses;
INSERT INTO response_stimuli SELECT id, 0, clip_file, clip_hash, replays + 1 FROM before_3_responses;
INSERT INTO answers
SELECT id, 0, 'rating', 0, rating, NULL FROM before_3_responses WHERE rating IS NOT NULL;

INSERT INTO events SELECT * FROM before_3_events;
INSERT INTO hand_joints SELECT * FROM before_3_hand_joints;
INSERT INTO trial_tracking SELECT * FROM before_3_trial_tracking;

DROP TABLE stage_names;
