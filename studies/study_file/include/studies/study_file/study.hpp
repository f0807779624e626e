// A study as its TOML file describes it, in one language. Documented key by key in docs/study-file.md.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "motion/retarget/retarget.hpp"
#include "studies/study_file/leave_out_rule.hpp"
#include "studies/study_file/questionnaire.hpp"
#include "studies/study_file/scale.hpp"
#include "studies/texts/language.hpp"
#include "studies/trials/registry.hpp"

namespace deixis::studies {

struct Range {
    double low = 0.0;
    double high = 0.0;
};

/// A place on the floor where a participant stands, in the avatar's frame.
struct ViewerPlace {
    double x_m = 0.0;
    double z_m = 0.0;
    double heading_deg =
        0.0;  ///< 0 looks along +z (as the avatar does), 180 looks back at it; positive towards +x
};

/// Where the participant stands in one layout.
struct Layout {
    std::string name;  ///< "across", "side-by-side", or a study's own
    double viewer_x_m = 0.0;
    double viewer_z_m = 0.0;
    double heading_deg = 0.0;
    std::optional<ViewerPlace> desktop{};  ///< at a flat screen, where that is another place
};

/// How many distractors there are and how far from the target: one level of the factor "distance".
struct DistanceBand {
    std::string name;
    Range distance_m{};  ///< centre to centre, from the target
    int distractors = 2;
    /// How far from the target each distractor must look, in degrees: as the avatar's eyes see it, and as the
    /// participant's do from every place of a game's layouts (ballAngles()). None: the distance alone says.
    std::optional<Range> avatar_angle_deg{};
    std::optional<Range> participant_angle_deg{};
};

/// Where the items of a study come from: targets drawn from the half-cylinder before the avatar (Deichler et
/// al. 2023, 2.4.3), or the items of a lab's manifest.
struct TargetSpace {
    int count = 100;  ///< 0 before the manifest of `from_manifest` has been read
    Range height_m{};
    Range arc_deg{};  ///< azimuth; 0 straight ahead of the avatar, positive to its left (+x)
    Range radius_m{};
    std::string fit_manifest{};  ///< path (resolved) of a manifest whose targets give the three ranges, which
                                 ///< then are empty until fitTargetSpace() fills them; empty: as written
    std::string from_manifest{};  ///< path (resolved) of a manifest whose items are the study's; then there
                                  ///< are no ranges unless a game draws distractors
    std::string from_projects{};  ///< likewise: folder of the studio's projects, named ITEM.SYSTEM.json,
                                  ///< whose items are the study's, without places
    double ball_diameter_m = 0.1;
    bool clear_view = true;  ///< balls that a participant could not see are drawn again; else the bare rule
};

/// One of the systems. Exactly one of `generator`, `manifest` and `projects` is set.
struct SystemSource {
    std::string name;
    std::string generator{};  ///< name of a built-in generator
    std::string
        manifest{};  ///< path of a manifest of clips; written relative to the study file, here resolved
    std::string projects{};  ///< folder (resolved) of the studio's projects, of which the clips are made
    /// Projects only: false takes their poses, styles and motions out, so that they are what authors begin
    /// with.
    bool controls = true;
    /// Built-in generators only: how the pointing is held. None: as the generator does by itself.
    std::optional<double> hold_s{};
    std::optional<double> unsteadiness_m{};  ///< how far the fingertip wanders during the hold
    /// Manifests only: what their clips keep on the avatar, and whether hands of figures without fingers
    /// close with the index finger out while they point.
    motion::Keep keep = motion::Keep::joint_angles;
    bool pointing_fingers = false;
    /// Factors that are nested in the systems, for the analysis: {"hold": "long"}.
    std::map<std::string, std::string> levels{};
    bool compared = true;  ///< false: in no test, ranking or figure of the report, which shows it apart
    std::string remark{};  ///< of one that is not compared: what it is, and why
    /// Of a locked study: what the clips' manifest says was done to them (assets::ManifestRow::processing),
    /// in the order of the rows, each once; empty: nothing.
    std::string processing{};
};

/// A between-participants factor: each gets one level, see assignGroups(). Stages say for which levels they
/// are (Stage::when).
struct BetweenFactor {
    std::string name;
    std::vector<std::string> levels;
};

/// As in the file: "instructions", "parallel-rating", "referential-game", "break", ...
[[nodiscard]] std::string_view stageKindName(StageKind kind);
[[nodiscard]] std::optional<StageKind> stageKindFromName(std::string_view name);
/// Whether its units are trials that show clips.
[[nodiscard]] bool showsClips(StageKind kind);

/// How the levels of a within-participants factor meet the items.
enum class Crossing : unsigned char {
    crossed,  ///< every item meets every level
    nested    ///< an item has one level, which it keeps; the levels share the items out evenly
};

enum class BlockOrder : unsigned char {
    williams,  ///< rows of a Williams square, by the participant's number within the cell
    shuffled,
    listed  ///< as in the file
};

/// The trials of a stage: items x the crossed levels of system, layout and distance.
struct TrialDesign {
    int items = 1;  ///< a participant's; drawn from the targets, no target serves in two stages
    std::vector<std::string> systems{};    ///< of [[systems]]
    std::vector<std::string> layouts{};    ///< of [[layouts]]
    std::vector<std::string> distances{};  ///< of [[distances]]; game only
    Crossing system_meets = Crossing::crossed;
    Crossing layout_meets = Crossing::nested;
    Crossing distance_meets = Crossing::nested;
    /// Trials come in blocks of one level of this factor ("system", "layout", "distance"); empty: no blocks.
    std::string block_by{};
    BlockOrder block_order = BlockOrder::shuffled;
    int max_run_of_system = 0;  ///< of trials one after another; 0: no limit
    bool no_target_twice_running = false;
};

enum class CheckKind : unsigned char {
    number,       ///< a number to be given is shown in the scene partway through the clip
    catch_trial,  ///< game: a target that cannot be mistaken
    repeat        ///< a stimulus comes a second time
};
[[nodiscard]] std::string_view checkKindName(CheckKind kind);  ///< "number", "catch", "repeat"

enum class CheckRule : unsigned char {
    note,     ///< kept in the record, nothing else
    warn,     ///< and the participant is asked to pay attention
    exclude,  ///< and the participant's answers leave the analysis
    end       ///< and the session ends
};
[[nodiscard]] std::string_view checkRuleName(CheckRule rule);

/// Attention checks of a stage. A check leaves the analysis; a repeat is scored once, its first time.
struct AttentionChecks {
    CheckKind kind = CheckKind::number;
    int count = 1;           ///< for each participant
    double tolerance = 0.0;  ///< how far off a number or a repeated answer may be
    std::string distance{};  ///< catch: the band of its distractors
    CheckRule rule = CheckRule::note;
    int after_failures = 1;  ///< the rule holds from this many failures in the stage on
};

/// What a practice stage asks before it lets go.
struct Practice {
    std::string of;              ///< the stage that is practised
    double criterion = 0.0;      ///< share of correct choices wanted (game); 0: none
    int max_attempts = 1;        ///< of `items` trials each
    bool end_if_failed = false;  ///< the session ends where the last attempt fails, else it goes on
    std::string again_text{};    ///< page before a further attempt; required where there may be one
};

/// What a participant may do in a trial of authoring, and for how long.
struct AuthoringLimits {
    std::vector<std::string> keyframes_only{};  ///< systems with neither model nor styles
    int practice_per_block = 0;                 ///< the first trials of each block, which do not count
    double limit_s = 300.0;
    double practice_limit_s = 300.0;
    bool may_end_early = false;
    bool practice_may_end_early = false;
};

/// One stage, in the order of the file. What does not belong to its kind keeps its default.
struct Stage {
    std::string name;  ///< unique
    StageKind kind = StageKind::instructions;
    int session = 1;                            ///< the stages of session 2 wait for another visit
    std::map<std::string, std::string> when{};  ///< between factor -> level; empty: for everybody
    std::string text{};                         ///< the page's; of a stage with trials: none
    std::string emphasis{};                     ///< instructions: a line under the text, such as the question
    double minimum_s = 0.0;                     ///< instructions, break: no sooner can the page be left
    Questionnaire questionnaire{};
    bool about_participant = false;  ///< questionnaire: its answers are the participant's fields

    // Stages with trials.
    std::optional<Practice> practice{};  ///< set: the trials do not count; all else is as of practice->of
    TrialDesign design{};
    std::string measure{};  ///< what the answers are called in tables and report; "" for the game
    std::string question{};
    Scale scale{};        ///< rating, parallel rating
    bool muted = false;   ///< clips with sound are shown without it
    int plays = 1;        ///< how often a clip is shown before the answer opens
    int max_replays = 0;  ///< further ones, asked for by the participant. Parallel, pairwise: no limit
    int break_every = 0;  ///< trials between breaks; 0: none
    std::string break_text{};
    double break_minimum_s = 0.0;
    std::vector<AttentionChecks> checks{};
    bool feedback = false;                 ///< game: the target is shown after the choice
    double time_limit_s = 0.0;             ///< for the answer; 0: none
    std::optional<Question> confidence{};  ///< game: asked after the choice, on a scale
    std::optional<Question> reasons{};     ///< pairwise: asked after a preference that is not a tie
    AuthoringLimits authoring{};           ///< authoring

    [[nodiscard]] bool scored() const { return showsClips(kind) && !practice; }
};

/// How the avatar meets the eyes of a participant in a headset, see placementFor().
enum class EyeLevel : unsigned char { measured, raise, scale };

/// What becomes of a trial in which the session was interrupted before its answer (a pause, a headset taken
/// off, tracking lost): it starts over from its clip, or continues where it was. A clip that was interrupted
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

/// How far what a participant reads in one language can be trusted.
struct LanguageStatus {
    TextStatus words = TextStatus::unstated;  ///< the program's
    TextStatus texts = TextStatus::unstated;  ///< the study's
};

struct Study {
    std::string name;
    std::string title;
    std::string description{};
    std::string reference{};
    std::uint64_t seed = 1;
    std::vector<std::string> languages;           ///< codes; the first is the default
    LanguageTable words;                          ///< the program's, in `language`
    std::string language;                         ///< the one that all texts are in
    std::vector<LanguageStatus> language_status;  ///< of `languages`, in their order
    double eye_height_m = 1.65;                   ///< standing eye height of a desktop participant
    std::filesystem::path avatar{};               ///< glTF or VRM file; empty: Deixis's own
    /// To which `avatar` is scaled; none: as tall as its file has it.
    std::optional<double> avatar_height_m{};
    double inter_trial_s = 0.6;  ///< inter-trial interval: between an answer and the next clip
    AfterInterruption after_interruption = AfterInterruption::resume;
    double instructions_again_after_s = 3600.0;  ///< who comes back later than this reads them again
    double alpha = 0.01;                         ///< for the report's tests
    /// Bounds within which the report calls systems, levels and groups equivalent, by measure.
    std::map<std::string, double> equivalence{};
    LeaveOutRule leave_out{};        ///< whom the report's headline leaves out
    bool by_ratings = false;         ///< the report tests single ratings, too, beside participants' means
    bool stations_together = false;  ///< the report pools what was answered at desktops and in headsets
    TargetSpace targets{};
    std::vector<DistanceBand> distances{};
    std::vector<Layout> layouts;
    std::vector<SystemSource> systems;
    std::vector<BetweenFactor> between{};
    std::vector<Stage> stages;
    HeadsetOptions headset{};

    std::filesystem::path file{};  ///< where it was read from
    std::string source{};          ///< the file's text; stored with the data
    std::string hash{};            ///< SHA-256 of the file's bytes and of the questionnaire files it names
    std::vector<std::filesystem::path> questionnaire_files{};  ///< those it names, each once, in their order
    std::vector<std::filesystem::path> language_files{};       ///< of the program's words, likewise
    /// Where the study file says something that only other files can tell to be wrong, as "FILE:LINE: key":
    /// "study.avatar", "targets.fit_manifest", "targets.from_manifest", "targets.from_projects",
    /// "systems.NAME", "layouts.NAME".
    std::map<std::string, std::string> places{};

    /// Of `places`; the file if there is none.
    [[nodiscard]] std::string place(const std::string& key) const;
    [[nodiscard]] const Layout* findLayout(std::string_view name) const;
    [[nodiscard]] const DistanceBand* findDistance(std::string_view name) const;
    [[nodiscard]] const SystemSource* findSystem(std::string_view name) const;
    [[nodiscard]] const Stage* findStage(std::string_view name) const;
};

/// Where to find what a study file only names; files beside the study file come first.
struct StudyFolders {
    std::filesystem::path languages;       ///< LANGUAGE.toml
    std::filesystem::path questionnaires;  ///< NAME.toml
    /// Where `languages` were kept by an earlier program: LANGUAGE.toml of this one, which has the words that
    /// are new since.
    std::filesystem::path words_since{};
    std::filesystem::path speeches{};  ///< folders of projects that ship, by their names
};

/// Reads and checks a study file in all its languages; the texts of the result are in `language` (empty: the
/// first). Every problem is found and listed, in the order of the file: each names file, line and key, what
/// was found and what was expected; an unknown key is one, with a proposal.
[[nodiscard]] tl::expected<Study, std::vector<Error>> loadStudy(const std::filesystem::path& path,
                                                                const StudyFolders& folders,
                                                                const std::string& language = {});

/// Every key that a study file may have, dotted ("targets.count"; tables of a list as "layouts.name"), in the
/// order of docs/study-file.md.
[[nodiscard]] std::vector<std::string> studyKeys();

}  // namespace deixis::studies
