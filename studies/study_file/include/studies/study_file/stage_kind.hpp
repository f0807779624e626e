// What the kinds of stages declare: everything that planner, session, store, export, power and analysis
// need to know about a kind. Declarations are in studies/trials/KIND/declaration.cpp; how a kind's stages are
// read from a study file is beside them in reading.cpp.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "studies/study_file/kept_values.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

/// How what is measured is analysed.
enum class AnswerKind : unsigned char {
    accuracy,   ///< right or wrong, among this many balls
    rating,     ///< a number of one stimulus
    preference  ///< -2 clearly the left stimulus .. 2 clearly the right one
};

struct DeclaredMeasure {
    std::string_view
        question;  ///< whose answers they are (Answer::question); empty: whether the choice was right
    AnswerKind kind = AnswerKind::rating;
    std::string_view name;  ///< in tables and report; empty: Stage::measure
    /// A quantity that is measured rather than answered on a scale, in this unit: 0 is exact, and its
    /// question's low and high only bound it. Empty: it is not.
    std::string_view unit{};
};

/// In which order a trial shows its stimuli.
enum class Arrangement : unsigned char {
    listed,
    shuffled,
    sides  ///< left and right, evenly over the trials of a pair
};

struct StageDeclaration {
    std::string_view name;  ///< in study files, plans and databases
    /// Beside those that every stage has, and every stage with trials.
    std::span<const std::string_view> keys{};

    bool answered = true;       ///< else it is a page that is only read
    bool is_break = false;      ///< a page that is not read again
    bool asks_consent = false;  ///< a no ends the session, and is asked again before all else
    bool in_pages = false;      ///< Trial::page counts up, see `pages`
    /// How many units a stage without clips has; null: none.
    int (*pages)(const Stage& stage) = nullptr;

    // Stages that show clips.
    int min_stimuli = 0;  ///< of a trial; 0: no clips
    int max_stimuli = 0;
    /// What a trial shows of this many systems (indices): the levels of the factor "system".
    std::vector<std::vector<int>> (*shown)(int systems) = nullptr;
    Arrangement arrangement = Arrangement::listed;
    bool placed = false;          ///< the target of an item must have a place in the room
    bool balls = false;           ///< the target is shown among distractors: there is a factor "distance"
    bool in_studio = false;       ///< done in the studio's page; its clips are not shown
    bool right_or_wrong = false;  ///< there are wrong answers, so that practice may have a criterion
    std::span<const CheckKind> checks{};  ///< attention checks that it may have

    /// All that is asked, under the names that the answers have.
    std::vector<Question> (*questions)(const Stage& stage, const LanguageTable& words) = nullptr;
    std::span<const DeclaredMeasure> measures{};

    // What is kept of a trial as planned, and of a response, beside what every kind keeps. A kind in which an
    // answer can be wrong keeps a truth `correct` of each choice.
    KeptFields trial_values{};
    KeptFields response_values{};

    [[nodiscard]] bool showsClips() const { return max_stimuli > 0; }
    [[nodiscard]] bool has(std::string_view key) const;
    /// Each stimulus is answered by itself; else the trial is answered once.
    [[nodiscard]] bool answersEach() const { return arrangement != Arrangement::sides; }
};

[[nodiscard]] const StageDeclaration& declarationOf(StageKind kind);
/// By its name; null if there is no such kind.
[[nodiscard]] const StageDeclaration* findDeclaration(std::string_view name);
/// All, in the order of the registry.
[[nodiscard]] std::span<const StageDeclaration* const> allDeclarations();

// What several kinds declare.
/// Trials of one stimulus: each system is a level.
[[nodiscard]] std::vector<std::vector<int>> eachByItself(int systems);
/// What is asked of each stimulus that is rated: Stage::question, on Stage::scale.
[[nodiscard]] std::vector<Question> ratingQuestion(const Stage& stage, const LanguageTable& words);

}  // namespace deixis::studies
