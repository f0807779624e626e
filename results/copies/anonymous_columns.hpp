// What becomes of each column of the database in a copy that is given away.
#pragma once

#include <array>
#include <string_view>

namespace deixis::results {

/// Columns, separated by ", ". One that stands in none of the lists stops the copy: whoever adds a column
/// decides.
struct ColumnHandling {
    const char* table;
    const char* kept;
    const char* clock = "";     ///< seconds on the station's clock: counted from the session's start
    const char* utc = "";       ///< seconds since 1970: likewise
    const char* left_out = "";  ///< NULL, or nothing (0, "") where there must be something
    const char* made = "";      ///< by rules of their own (anonymous_copy.cpp)
};

inline constexpr std::array<ColumnHandling, 25> column_handling{{
    {"study", "id, name, title, hash, alpha, ball_diameter_m, analysis", "", "", "", "source, locked_hash"},
    {"stages", "position, name, kind, sitting, practice_of, measure, scale_low, scale_high, question"},
    {"systems", "position, name, generator, levels", "", "", "", "manifest"},
    {"layouts", "position, name, viewer_x_m, viewer_z_m, heading_deg"},
    {"distances", "position, name, low_m, high_m, distractors"},
    {"questions", "stage, question, position, kind, text, low, high, options, labels"},
    {"scores", "stage, name, position, items, reversed, mean, factor, offset_"},
    {"participants", "language, status", "", "", "registered_utc_s, token", "id, number, reason"},
    {"participant_groups", "factor, level", "", "", "", "participant"},
    {"participant_fields", "field, value", "", "", "", "participant, text"},
    {"plans", "seed", "", "", "", "participant, hash, json, locked_hash"},
    {"trials",
     "trial_index, stage, kind, practice, attempt, page, layout, distance, target_id, target_x_m, "
     "target_y_m, "
     "target_z_m, check_kind, check_stimulus, check_expected, check_of_trial, visibility, angles",
     "", "", "", "participant"},
    {"trial_values", "trial_index, name, value, text", "", "", "", "participant"},
    {"trial_stimuli", "trial_index, position, system, item, scored, clip", "", "", "", "participant"},
    {"sessions", "station, synthetic, program_version, avatar_hash, outcome", "",
     "started_utc_s, ended_utc_s", "station_details", "id, participant"},
    {"session_properties", "name", "", "", "", "session, value"},
    {"consents", "stage, agreed, language, text", "", "utc_s", "", "participant, session"},
    {"responses",
     "trial_index, status, check_passed, response_time_s, paused_s, replays, pauses, "
     "begun_before, input, head_x_m, head_y_m, head_z_m, head_qw, head_qx, head_qy, head_qz, ray_x_m, "
     "ray_y_m, ray_z_m, ray_dx, ray_dy, ray_dz, viewer_x_m, viewer_z_m, viewer_heading_deg",
     "onset_s, motion_end_s, answered_s", "onset_utc_s, motion_end_utc_s, answered_utc_s, superseded_utc_s",
     "", "id, participant, session, reason, superseded, hash"},
    {"response_stimuli", "position, clip_hash, plays, author_trial", "", "", "",
     "response, clip_file, author"},
    {"answers", "position, question, stimulus, value", "", "", "", "response, text"},
    {"response_values", "name, value, text", "", "", "", "response"},
    {"events", "kind, trial_index", "time_s", "utc_s", "", "id, session, detail"},
    {"tracking_blocks", "trial_index, first_frame, frames", "first_display_time_s, last_display_time_s", "",
     "", "id, session, data"},
    {"hand_joints", "frame, hand, joints, flags", "", "", "", "session"},
    {"trial_tracking",
     "trial_index, frames, dropped_frames, samples_missing, max_off_place_m, head_untracked_frames",
     "first_display_time_s, last_display_time_s", "", "", "session"},
}};

/// Of who declined consent no more is kept.
inline constexpr std::string_view tables_of_decline =
    "participants, participant_groups, plans, trials, trial_values, trial_stimuli, sessions, consents";

/// Whose details the program or its station worded, without names of devices or what an experimenter typed.
inline constexpr std::string_view events_kept_whole =
    "stage_start, instructions_read, stimulus_onset, motion_end, replay, feedback, check_failed, warned, "
    "practice_met, practice_failed, practice_answer, excluded, pause, resume, early_select, off_place, "
    "back_on_place, pointer_lost, pointer_found, recentre, placement, pointing_hand, xr_state, sound";

/// What stations say of themselves; left out are the eyes' distance, which is a person's, and drivers.
inline constexpr std::string_view properties_kept =
    "program_commit, program_uncommitted_changes, program_build_type, program_compiler, program_libraries, "
    "program_built_on, operating_system, runtime, runtime_version, system, refresh_rate_hz, eye_picture_px, "
    "space, stereo, depth_layer, visibility_mask, eye_gaze, hand_joints, assumed_eye_height_m";

}  // namespace deixis::results
