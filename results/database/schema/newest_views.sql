-- One row for each answer to a question or rating, and one for each response without any (a choice of the game
-- without confidence, a skipped trial): everything in it.
CREATE VIEW responses_flat AS
SELECT p.id AS participant, p.number AS participant_number,
       -- As who counts is told everywhere (standing.hpp): without consent nobody is active.
       CASE WHEN p.status = 'active' AND EXISTS
                 (SELECT 1 FROM consents AS c WHERE c.participant = p.id AND c.agreed = 0 AND c.session =
                  (SELECT max(o.session) FROM consents AS o WHERE o.participant = c.participant AND o.stage = c.stage))
            THEN 'dropped' ELSE p.status END AS participant_status,
       r.trial_index, t.stage, t.kind, t.practice, t.attempt, r.status,
       a.question, CASE WHEN t.kind <> 'pairwise' THEN s.position END AS stimulus, s.system, s.item,
       coalesce(s.scored, 0) AS scored,
       a.value, a.text,
       (SELECT CAST(v.value AS INTEGER) FROM response_values AS v WHERE v.response = r.id AND v.name = 'chosen_place')
           AS chosen_place,
       (SELECT CAST(v.value AS INTEGER) FROM trial_values AS v WHERE v.participant = t.participant
           AND v.trial_index = t.trial_index AND v.name = 'target_place') AS target_place,
       (SELECT CAST(v.value AS INTEGER) FROM response_values AS v WHERE v.response = r.id AND v.name = 'correct')
           AS correct,
       t.check_kind, r.check_passed,
       t.layout, t.distance, t.target_id, r.response_time_s, r.replays, x.plays, r.pauses, r.paused_s,
       r.begun_before, r.input, k.dropped_frames, k.samples_missing, k.max_off_place_m,
       s.clip, x.clip_file, x.clip_hash, x.author, x.author_trial,
       t.target_x_m, t.target_y_m, t.target_z_m,
       (SELECT v.text FROM trial_values AS v WHERE v.participant = t.participant AND v.trial_index = t.trial_index
           AND v.name = 'distractors') AS distractors,
       (SELECT v.text FROM trial_values AS v WHERE v.participant = t.participant AND v.trial_index = t.trial_index
           AND v.name = 'balls') AS balls,
       coalesce(r.viewer_x_m, l.viewer_x_m) AS viewer_x_m, coalesce(r.viewer_z_m, l.viewer_z_m) AS viewer_z_m,
       coalesce(r.viewer_heading_deg, l.heading_deg) AS heading_deg,
       r.onset_s, r.motion_end_s, r.answered_s, r.onset_utc_s, r.motion_end_utc_s, r.answered_utc_s,
       strftime('%Y-%m-%dT%H:%M:%fZ', r.answered_utc_s, 'unixepoch') AS answered_utc,
       r.head_x_m, r.head_y_m, r.head_z_m, r.head_qw, r.head_qx, r.head_qy, r.head_qz,
       r.ray_x_m, r.ray_y_m, r.ray_z_m, r.ray_dx, r.ray_dy, r.ray_dz,
       r.session, e.station, e.station_details, e.synthetic, e.program_version, e.avatar_hash, r.id AS response,
       o.system AS other_system             -- pairwise: stood right; `system` stood left
  FROM responses AS r
  JOIN participants AS p ON p.id = r.participant
  JOIN trials AS t ON t.participant = r.participant AND t.trial_index = r.trial_index
  JOIN sessions AS e ON e.id = r.session
  LEFT JOIN answers AS a ON a.response = r.id
  LEFT JOIN trial_stimuli AS s ON s.participant = r.participant AND s.trial_index = r.trial_index
        AND (s.position = a.stimulus OR (a.stimulus IS NULL AND s.position = 0))
  LEFT JOIN trial_stimuli AS o ON o.participant = r.participant AND o.trial_index = r.trial_index
        AND o.position = 1 AND t.kind = 'pairwise'
  LEFT JOIN response_stimuli AS x ON x.response = r.id AND x.position = s.position AND t.kind <> 'pairwise'
  LEFT JOIN layouts AS l ON l.name = t.layout
  LEFT JOIN trial_tracking AS k ON k.session = r.session AND k.trial_index = r.trial_index
 WHERE r.superseded IS NULL
 ORDER BY r.participant, r.trial_index, a.position;
