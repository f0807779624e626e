// What a study is, as its TOML file says it. Documented key by key in docs/study-file.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"

namespace deixis::studies {

struct Range {
    double low = 0.0;
    double high = 0.0;
};

/// Where the participant stands in one layout, in the avatar's frame.
struct Layout {
    std::string name;  ///< "across" or "side-by-side"
    double viewer_x_m = 0.0;
    double viewer_z_m = 0.0;
    double heading_deg =
        0.0;  ///< 0 looks along +z (as the avatar does), 180 looks back at it; positive towards +x
};

/// The half-cylinder before the avatar from which targets and distractors are drawn (Deichler et al.
/// 2023, 2.4.3).
struct TargetSpace {
    int count = 100;
    Range height_m{};
    Range arc_deg{};  ///< azimuth; 0 straight ahead of the avatar, positive to its left (+x)
    Range radius_m{};
    std::string fit_manifest{};  ///< path (resolved) of a manifest whose targets give the three ranges, which
                                 ///< then are empty until fitTargetSpace() fills them; empty: as written
    double ball_diameter_m = 0.0;
    int distractors = 2;
    Range distractor_distance_m{};  ///< centre to centre, from the target
};

/// One of the systems compared. Exactly one of `generator` and `manifest` is set.
struct SystemSource {
    std::string name;
    std::string generator{};  ///< name of a built-in generator
    std::string
        manifest{};  ///< path of a manifest of clips; written relative to the study file, here resolved
};

/// Stage 1: single-stimulus rating.
struct RatingStage {
    int items = 5;  ///< targets per system
    int practice = 0;
    int break_every = 0;  ///< trials between breaks; 0: none
    int max_replays = 0;
    std::string layout = "across";
    std::string question;
    std::vector<std::string> labels;  ///< one per scale step, lowest first
    std::string instructions;
    std::string practice_instructions{};
};

/// Stage 2: referential game.
struct GameStage {
    int items = 10;
    int practice = 0;
    int break_every = 0;
    int max_replays = 0;
    std::vector<std::string> layouts;
    std::string question;
    std::string instructions;
    std::string practice_instructions{};
};

/// How the avatar meets the eyes of a participant in a headset, see placementFor().
enum class EyeLevel : unsigned char { measured, raise, scale };

/// What becomes of a trial in which the session was interrupted before its answer (a pause, a headset taken
/// off, tracking lost): it starts over from its clip, or goes on where it was. A clip that was interrupted
/// always starts over.
enum class AfterInterruption : unsigned char { resume, repeat };

/// [headset]: what only concerns participants in a headset.
struct HeadsetOptions {
    EyeLevel eye_level = EyeLevel::measured;
    double assumed_eye_height_m = 1.65;  ///< where the runtime knows no floor; the operator is told
    double place_tolerance_m = 0.30;     ///< farther from the layout's place the participant is asked back
    bool record_gaze = false;            ///< where the runtime offers it
    bool record_hands = false;           ///< joints of tracked hands, where the runtime offers them
};

struct Study {
    std::string name;
    std::string title;
    std::string description{};
    std::string reference{};
    std::uint64_t seed = 1;
    double eye_height_m = 1.65;  ///< standing eye height of a desktop participant
    double inter_trial_s = 0.6;  ///< pause between an answer and the next clip
    std::string welcome;
    std::string break_text;
    std::string goodbye;
    double alpha = 0.01;  ///< for the report's tests
    TargetSpace targets{};
    std::vector<Layout> layouts;
    std::vector<SystemSource> systems;
    RatingStage rating{};
    GameStage game{};
    AfterInterruption after_interruption = AfterInterruption::resume;
    HeadsetOptions headset{};

    std::filesystem::path file{};  ///< where it was read from
    std::string hash{};            ///< SHA-256 of the file's bytes

    [[nodiscard]] const Layout* findLayout(std::string_view name) const;
};

/// Reads and checks a study file. Every error names file, line and key, what was found and what was expected;
/// an unknown key is an error.
[[nodiscard]] Result<Study> loadStudy(const std::filesystem::path& path);

/// Every key that a study file may have, dotted ("targets.count"; tables of a list as "layouts.name"), in the
/// order of docs/study-file.md.
[[nodiscard]] std::vector<std::string> studyKeys();

}  // namespace deixis::studies
