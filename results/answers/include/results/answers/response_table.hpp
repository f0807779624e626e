// The answers of a database as a flat table: what the analysis works on.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "results/answers/observers.hpp"
#include "studies/study_file/leave_out_rule.hpp"

namespace deixis::results {

enum class MeasureKind : unsigned char {
    accuracy,   ///< of the game: 1 correct, 0 wrong
    rating,     ///< on a scale; also confidence
    preference  ///< of a pair: -2 clearly the left one .. 2 clearly the right one
};

/// What was measured, in one stage or in several of the same measure.
struct Measure {
    std::string name;  ///< "accuracy", "confidence", "preference", or Stage::measure
    MeasureKind kind = MeasureKind::rating;
    double low = 0.0;  ///< of the scale
    double high = 1.0;
    int balls = 0;      ///< accuracy: shown in a trial, the most there are; 0 else
    int planned = 0;    ///< values planned, of participants who count; confidence: as many as choices
    int min_balls = 0;  ///< likewise, the fewest
    /// Within which a difference counts as none that matters, declared before; 0: none was.
    double equivalence_bound = 0.0;
    bool surveyed = false;  ///< of a questionnaire: each system is rated once, as a whole
    std::string unit{};     ///< of a quantity that was measured: "cm"; empty: of a scale. Then `high` is the
                            ///< answers' own end, rounded up
};

/// What answers or participants differ in, and its levels in the order of the tables.
struct Factor {
    std::string name;
    std::vector<std::string> levels{};
};

/// One value. Practice and attention checks are never among them.
struct ResponseRow {
    std::string participant;
    std::string measure;
    std::string system;
    std::string layout{};
    std::string distance{};
    std::string target_id{};
    int trial = -1;  ///< place among the participant's trials, from 0; -1: not known
    double value = 0.0;
    std::string other_system{};    ///< preference: `system` stood left, this one right
    double response_time_s = 0.0;  ///< 0 if it is not known, or nothing was answered
    bool synthetic = false;        ///< answered by a simulated participant
    std::string station{};         ///< at which kind of station; empty if it is not known
    int pauses = 0;                ///< the trial was interrupted this often
    /// Levels of ResponseTable::within, in its order; empty if a level is not known.
    std::vector<std::string> within{};
    int balls = 0;  ///< accuracy: shown in this trial; 0: not known
    /// Why there is no choice: "timed_out" (it counts as wrong) or "skipped" (of
    /// ResponseTable::skipped_rows only); empty if there is one.
    std::string unanswered{};
    int author_trial = 0;    ///< in which of its author's trials the clip was made, from 1; 0: not known
    std::string marked{};    ///< why the trial is in doubt; empty: it is not
    std::string excluded{};  ///< why the participant is left out; of ResponseTable::left_out_rows only
};

/// A choice in the game with the balls it was made among, positions in the avatar's frame.
struct ChoiceRow {
    std::string participant;
    std::string system;
    std::string target_id;
    std::vector<Vec3> balls{};  ///< centres in the order in which they were shown
    int target_place = 0;       ///< which of `balls`
    int chosen_place = 0;       ///< likewise
    double head_x_m = 0.0;      ///< where the participant stood at the answer
    double head_z_m = 0.0;
    std::string station{};  ///< at which kind, as of the rows
    /// The smallest angle from the target to a distractor, as the avatar's eyes see it and as the
    /// participant's do from the layout's place for the station; degrees, none if they were not kept.
    std::optional<double> avatar_angle_deg{};
    std::optional<double> participant_angle_deg{};
    std::string layout{};
};

/// The sessions of one kind of station.
struct StationUse {
    std::string kind;
    std::string details;
    bool synthetic = false;
    int sessions = 0;
};

/// Whose answers are left out, and why.
struct LeftOut {
    std::string participant;
    bool dropped = false;  ///< left the study; else excluded
    std::string reason;
};

/// Attention checks of one kind in one stage, over all participants, the excluded ones too.
struct CheckCount {
    std::string stage;
    std::string kind;  ///< "number", "catch", "repeat"
    int passed = 0;
    int failed = 0;
};

/// A questionnaire's score of one participant.
struct ScoreRow {
    std::string participant;
    std::string stage;
    std::string score;
    double value = 0.0;
};

/// What a participant told of themselves: a number, or which option was chosen. Free text is not among them.
struct FieldRow {
    std::string participant;
    std::string field;
    std::optional<double> number{};
    std::string option{};
};

/// One of the data of several studies that are analysed together.
struct DataOrigin {
    std::string study;  ///< the group that its participants are
    std::string data;   ///< as ResponseTable::database
    std::string title;
    std::string study_hash;    ///< empty if the answers come without a study file
    std::string answers_hash;  ///< answersHash() of these data alone
    int schema_version = 0;    ///< as ResponseTable::schema_version
    std::vector<std::string> program_versions{};
    std::vector<std::string> operating_systems{};
    std::vector<std::string> avatar_hashes{};
    int people = 0;     ///< participants who count and answered
    int simulated = 0;  ///< likewise, simulated ones
    int answers = 0;
    int left_out = 0;
    int withdrawn = 0;
};

struct ResponseTable {
    std::string study_name;
    std::string study_title;
    std::string study_hash;  ///< empty if the answers come without a study file
    double alpha = 0.01;
    std::vector<std::string> systems{};  ///< in the study file's order
    /// Of them those whose clips the program made by a generator of its own: all synthetic.
    std::vector<std::string> built_in_systems{};
    /// By system: what its manifest says was done to the clips ("learned-from-synthetic"); those of which
    /// nothing is said are not in it. None: a database from before this was kept.
    std::optional<std::map<std::string, std::string>> processing{};
    /// Systems that the study does not compare, and why. analyse() takes them out of `systems`, and their
    /// answers out of all rows into aside_rows.
    std::map<std::string, std::string> not_compared{};
    std::vector<ResponseRow> aside_rows{};
    std::vector<std::string> layouts{};    ///< of scored trials, likewise
    std::vector<std::string> distances{};  ///< likewise
    std::vector<Factor> within{};          ///< further within-participants factors
    std::vector<Measure> measures{};       ///< accuracy first, then in the order of the stages
    int planned_participants =
        0;  ///< those left out are not counted; 0: not known, as of one kind of station
    /// Participant, measure: values planned. Empty if the answers come without a study.
    std::map<std::string, std::map<std::string, int>> planned_answers{};
    int withdrawn = 0;
    std::vector<LeftOut> left_out{};
    std::vector<CheckCount> checks{};
    std::vector<ScoreRow> scores{};
    /// Stages with the same scores of the same questions, in their order: before and after.
    std::vector<std::vector<std::string>> repeated_questionnaires{};
    std::vector<FieldRow> fields{};                   ///< of participants who count
    std::map<std::string, double> session_minutes{};  ///< likewise: all sessions of each together
    std::vector<Factor> between{};                    ///< between-participants factors
    std::map<std::string, std::map<std::string, std::string>> groups{};  ///< participant, factor: level
    std::set<std::string> failed_checks{};  ///< participants who count and failed an attention check
    std::string database{};                 ///< file names without their folders, joined by ", "
    int schema_version = 0;                 ///< of the database as it lies there; 0: not a database file
    std::vector<DataOrigin> origins{};      ///< of several studies (joinData()); empty of one
    std::vector<StationUse> stations{};
    bool stations_together = false;               ///< the study says so
    bool by_ratings = false;                      ///< likewise: single ratings are tested, too
    std::map<std::string, double> equivalence{};  ///< bounds by measure, which the study declares
    studies::LeaveOutRule leave_out{};            ///< which the study declares; left_out has whom it concerns
    std::vector<std::string> program_versions{};  ///< that recorded the sessions, in order of their text
    std::vector<std::string> operating_systems{};  ///< on which they were recorded, likewise; none: not kept
    std::vector<std::string> avatar_hashes{};      ///< likewise
    std::vector<std::string> notes{};              ///< on how the file was read, for the reader of the report
    std::vector<ResponseRow> rows{};  ///< of participants who count; ordered by participant, then trial
    /// Likewise, of participants who are excluded or dropped out but did not refuse their consent.
    std::vector<ResponseRow> left_out_rows{};
    /// Choices that the experimenter skipped, of participants who count; `value` is 0.
    std::vector<ResponseRow> skipped_rows{};
    std::vector<ChoiceRow> choices{};  ///< of participants who count, where the balls are known
    /// By its id, where each target stands in the avatar's frame; of studies that measure a quantity in a
    /// unit.
    std::map<std::string, Vec3> target_positions{};
    /// Choices with the arms that they were made after, where the clips are available; whoever reads them
    /// adds them (the reading of a database does not).
    std::vector<ObservedChoice> watched{};
};

/// The within-participants factors that the rows differ in: "layout", "distance", then ResponseTable::within.
[[nodiscard]] std::vector<Factor> withinFactors(const ResponseTable& table);

/// Adds a level that a factor does not have yet, and a factor that is not there yet.
void addLevel(std::vector<Factor>& factors, const std::string& name, const std::string& level);

/// A row's level of one of them; empty if it has none.
[[nodiscard]] std::string levelOf(const ResponseTable& table, const ResponseRow& row,
                                  const std::string& factor);

/// One table of several of the same study, in their order; what a study declares is the first one's. Fails,
/// naming the files, where the studies differ or a participant stands in two of them.
[[nodiscard]] Result<ResponseTable> joinTables(std::vector<ResponseTable> tables);

/// SHA-256 of the answers that are analysed, whatever files they stand in.
[[nodiscard]] std::string answersHash(const ResponseTable& table);

/// Reads a database made by Store; changes nothing in it or beside it. Errors: no such file, not one of ours,
/// a newer version, no study in it yet, no answers in it yet.
[[nodiscard]] Result<ResponseTable> loadResponses(const std::filesystem::path& database);

}  // namespace deixis::results
