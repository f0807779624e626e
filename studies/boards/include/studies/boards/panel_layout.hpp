// Boards in the world: what they say, how large they are, where they are, and what a ray hits on them.
//
// Sizes are comfortable to read in a headset at about 1.5 m: lines of at least 35 mm (1.3 degrees),
// buttons of at least 0.13 m (5 degrees), or 0.1 m for many in a row (0.065 m: more than seven steps for
// each of several stimuli). Boards are at most 1.6 m wide and, except for extremely long texts, 1.1 m
// high.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "studies/boards/panel_hit.hpp"
#include "studies/station/station.hpp"
#include "studies/study_file/questionnaire.hpp"
#include "studies/study_file/scale.hpp"
#include "studies/texts/language.hpp"

namespace deixis::studies {

struct ButtonSpec {
    std::string label;
    int id = 0;
    ButtonRole role = ButtonRole::other;
    bool enabled = true;
};

// Pages.

/// Title, body and (bold) emphasis above a row of buttons, and a faint line at the foot; as wide and high as
/// the text needs. No progress bar where `progress` is negative.
[[nodiscard]] Panel messagePanel(const std::string& title, const std::string& body,
                                 const std::string& emphasis, const std::vector<ButtonSpec>& buttons,
                                 double progress, const std::string& foot = {});

// Answers to one question.

/// A question answered on a scale: a rating, or a confidence.
struct RatingBoard {
    std::string question;
    Scale scale;
    std::optional<int> value{};           ///< set now
    bool enabled = true;                  ///< whether the scale takes a value
    std::optional<ButtonSpec> replay{};   ///< beside the question
    std::optional<ButtonSpec> confirm{};  ///< beside a slider, which needs one; under steps
};

/// Steps are buttons with their number from first_rating (the lowest) on, up to 11 in a row, role option; a
/// slider has the id first_slider.
[[nodiscard]] Panel ratingPanel(const RatingBoard& board);

/// The question of the game, and a button beside it if there is one.
[[nodiscard]] Panel gamePanel(const std::string& question, const std::optional<ButtonSpec>& replay);

enum class PlayState : unsigned char { unplayed, playing, played };

/// What can be played, and rated on a page of parallel rating.
struct StimulusView {
    PlayState state = PlayState::unplayed;
    bool can_play = true;  ///< not while another one plays
    bool can_rate = true;
    std::optional<int> value{};  ///< rated now
};

struct ParallelBoard {
    std::string question;
    Scale scale;
    std::vector<StimulusView> stimuli{};  ///< 2 to 6
    bool can_confirm = false;
    std::string hint{};  ///< a faint line under the question: what is still to be done; may be empty
};

/// For each stimulus, lettered from A: a play button (first_play + i) and a slider (first_slider + i) or
/// steps (first_option + 100 i + value - low); the labels once above each column. Confirm is go_on, beside
/// the question.
[[nodiscard]] Panel parallelPanel(const ParallelBoard& board, const LanguageTable& words);

struct PairwiseBoard {
    std::string question;
    StimulusView left{};  ///< `can_rate` and `value` are not read
    StimulusView right{};
    bool can_answer = false;
    std::optional<int> preference{};  ///< -2 clearly left .. 2 clearly right
    std::string hint{};
};

/// Play buttons first_play (left) and first_play + 1 (right) at either side of the question; under it five
/// options from first_rating (clearly left) to first_rating + 4 (clearly right).
[[nodiscard]] Panel pairwisePanel(const PairwiseBoard& board, const LanguageTable& words);

// Questionnaires.

/// The answer that a question has now.
struct AnswerView {
    std::optional<int> value{};  ///< scale
    std::vector<int> chosen{};   ///< choice, choices: places of the options
    std::string typed{};         ///< number, text
};

/// Keys of the pad that stands in for a keyboard under a number: first_option + 100 i + one of these.
namespace pad_key {
constexpr int zero = 0;  ///< the digits follow
constexpr int erase = 10;
constexpr int point = 11;  ///< only where fractions may be
constexpr int minus = 12;  ///< only where there are numbers below 0
}  // namespace pad_key

struct QuestionnaireBoard {
    std::string title{};
    std::string text{};  ///< how to answer
    std::vector<const Question*> questions{};
    std::vector<AnswerView> answers{};  ///< one for each question
    int active_field = -1;              ///< the question whose field takes what is typed; -1: none
    bool keyboard = true;               ///< without one numbers have a pad of keys, and texts only a field
    std::vector<ButtonSpec> buttons{};  ///< at the foot: "Continue"
    std::string missing{};              ///< a faint line above them, such as "Please answer all questions."
    int page = 0;                       ///< counted from 0
    int pages = 1;                      ///< told where there are several
    double progress = -1.0;
};

/// Question i of the page: the steps of a scale first_option + 100 i + value - low, the options of a choice
/// first_option + 100 i + place (all with role option, the present ones `chosen`), sliders and fields
/// first_field + i. Steps that all have a short label show it in place of their number.
[[nodiscard]] Panel questionnairePanel(const QuestionnaireBoard& board, const LanguageTable& words);

/// The questions of a questionnaire by pages: at most per_page, fewer where the board would grow too high.
/// Title and text stand on the first alone. Questions of text are left out without a keyboard.
[[nodiscard]] std::vector<std::vector<const Question*>> questionnairePages(const Questionnaire& questionnaire,
                                                                           bool keyboard,
                                                                           const LanguageTable& words);

// Signs.

/// A small board to be read only: a sentence and, under it, a short text in large letters. Either may be
/// empty.
[[nodiscard]] Panel signPanel(const std::string& sentence, const std::string& large);

/// Above the avatar's head, facing the viewer's eyes.
[[nodiscard]] Pose signPose(const Panel& sign, const Vec3& avatar_head, const Vec3& eyes);

// Where boards stand. All turn aside as far as an avatar that stands nearer than the panel would cover it.

/// Upright, 1.3 m before the viewer, its centre a little below the eyes: pages and questionnaires.
[[nodiscard]] Pose messagePose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m);

/// Low before the viewer and tilted up like a lectern: under the avatar's chest as seen from the viewer's
/// place, so that face and torso stay free. A high board stands lower and lies flatter. Ratings.
[[nodiscard]] Pose lecternPose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m);

/// Like it, but low enough that the avatar is free from the hips up, and so far away that all of it is in a
/// flat screen's view with the avatar's head and a sign above that: boards that are open while clips play
/// (parallel ratings, pairs).
[[nodiscard]] Pose benchPose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m);

/// Lower and nearer still: the game.
[[nodiscard]] Pose deskPose(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m);

/// The lectern's place, or the lower desk's, or turned aside by as much as it takes that it overlaps no ball
/// for the viewer's eyes. None where balls are all around.
[[nodiscard]] std::optional<Pose> poseBesideBalls(const Panel& panel, const Pose& stage_from_viewer,
                                                  double eye_height_m, const std::vector<BallView>& balls);

/// The same for the desk's place alone, where it would stand without balls if there is no other.
[[nodiscard]] Pose deskPoseBesideBalls(const Panel& panel, const Pose& stage_from_viewer, double eye_height_m,
                                       const std::vector<BallView>& balls);

// Pointing at them: studies/panel_hit.hpp, and

/// Where along the panel's +x the ray meets its plane, also beyond the board: a slider that is dragged
/// follows a ray that has left it. None for a ray that does not meet the plane.
[[nodiscard]] std::optional<double> alongPanel(const Panel& panel, const Ray& ray);

}  // namespace deixis::studies
