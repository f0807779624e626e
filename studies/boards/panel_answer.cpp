#include <algorithm>
#include <array>

#include "panel_build.hpp"
#include "studies/boards/button_ids.hpp"
#include "studies/boards/panel_layout.hpp"

namespace deixis::studies {

namespace {

constexpr double row_gap_m = 0.014;
constexpr double play_width_m = 0.2;  // with its words as a caption
constexpr double play_height_m = 0.15;
constexpr double value_m = 0.1;        // of a slider's value in numbers, so that a check's number can be set
constexpr double many_height_m = 0.1;  // four rows and more, one under the other

const std::string& playWord(PlayState state, const LanguageTable& words) {
    switch (state) {
        case PlayState::playing:
            return words("playing");
        case PlayState::played:
            return words("play_again");
        case PlayState::unplayed:
            break;
    }
    return words("play");
}

/// "A", "B", ...
std::string letter(std::size_t i) {
    return {static_cast<char>('A' + static_cast<int>(i))};
}

/// The room that the words of a play button take after its letter, whichever it is.
double widestPlayLabel(const LanguageTable& words) {
    double width_m = 0.0;
    for (const PlayState state : {PlayState::unplayed, PlayState::playing, PlayState::played})
        width_m = std::max(width_m, panel::buttonWidth("A  " + playWord(state, words), ButtonRole::play));
    return width_m;
}

void markPlay(PanelButton& button, const StimulusView& stimulus) {
    button.role = ButtonRole::play;
    button.chosen = stimulus.state == PlayState::playing;
}

double columnWidth(double inner_m, std::size_t columns) {
    const auto count = static_cast<double>(columns);
    return (inner_m - (count - 1.0) * panel::gap_m) / count;
}

/// Rows one under the other, or two columns where these leave room for the scale and the board gets lower.
struct Grid {
    std::size_t columns = 1;
    std::size_t rows = 1;
    double height_m = panel::button_height_m;
};

Grid gridOf(const ParallelBoard& board, double inner_m) {
    const std::size_t count = board.stimuli.size();
    const double scale_m = columnWidth(inner_m, 2) - play_width_m - panel::button_gap_m;
    const bool narrow = (board.scale.kind == ScaleKind::slider || board.scale.steps() <= 5) &&
                        panel::labelsFit(board.scale, scale_m);
    if (count > 3 && narrow) return {2, (count + 1) / 2, play_height_m};
    return {1, count, count > 3 ? many_height_m : panel::button_height_m};
}

}  // namespace

Panel ratingPanel(const RatingBoard& board) {
    panel::Builder made(panel::wide_m);
    made.question(board.question, "", board.replay);
    const panel::ScalePart scale{board.scale, button_id::first_rating, button_id::first_slider, board.value,
                                 board.enabled};
    const double top = made.top();
    if (board.confirm && board.scale.kind == ScaleKind::slider) {
        const double button_m = panel::buttonWidth(board.confirm->label, board.confirm->role);
        made.scale(scale, panel::margin_m, top, made.inner() - button_m - panel::gap_m);
        made.button(*board.confirm, panel::wide_m - panel::margin_m - button_m, top, button_m,
                    panel::button_height_m);
    } else {
        made.advance(made.scale(scale, panel::margin_m, top, made.inner()));
        if (board.confirm)
            made.buttons({*board.confirm}, panel::margin_m, made.top(), made.inner(), panel::button_height_m,
                         true);
    }
    return made.finish();
}

Panel gamePanel(const std::string& question, const std::optional<ButtonSpec>& replay) {
    panel::Builder made(1.0);
    made.question(question, "", replay);
    return made.finish();
}

Panel parallelPanel(const ParallelBoard& board, const LanguageTable& words) {
    panel::Builder made(panel::wide_m);
    made.question(board.question, board.hint,
                  ButtonSpec{words("confirm"), button_id::go_on, ButtonRole::go_on, board.can_confirm});
    const Grid grid = gridOf(board, made.inner());
    const bool captions = grid.columns > 1;
    const double column_m = columnWidth(made.inner(), grid.columns);
    const double play_m = captions ? play_width_m : widestPlayLabel(words);
    // Beside its slider, or under the thumb where there is no room beside it.
    const double beside_m = board.scale.kind == ScaleKind::slider && !captions ? value_m : 0.0;
    const double scale_m = column_m - play_m - panel::button_gap_m - beside_m;
    const auto scaleLeft = [&](std::size_t column) {
        return panel::margin_m + static_cast<double>(column) * (column_m + panel::gap_m) + play_m +
               panel::button_gap_m;
    };

    double labels_m = 0.0;
    for (std::size_t column = 0; column < grid.columns; ++column)
        labels_m = std::max(labels_m, made.scaleLabels(board.scale, scaleLeft(column), made.top(), scale_m));
    if (labels_m > 0.0) made.advance(labels_m, row_gap_m);

    for (std::size_t row = 0; row < grid.rows; ++row) {
        double row_m = grid.height_m;
        for (std::size_t column = 0; column < grid.columns; ++column) {
            const std::size_t i = column * grid.rows + row;  // A, B, C downwards
            if (i >= board.stimuli.size()) continue;
            const StimulusView& stimulus = board.stimuli[i];
            const std::string& word = playWord(stimulus.state, words);
            const int place = static_cast<int>(i);
            const double left = scaleLeft(column);
            made.button({captions ? letter(i) : letter(i) + "  " + word, button_id::first_play + place,
                         ButtonRole::play, stimulus.can_play},
                        left - panel::button_gap_m - play_m, made.top(), play_m, grid.height_m);
            markPlay(made.lastButton(), stimulus);
            if (captions) made.lastButton().caption = word;
            row_m = std::max(
                row_m,
                made.scale({board.scale, button_id::first_option + 100 * place,
                            button_id::first_slider + place, stimulus.value, stimulus.can_rate, false, false,
                            captions && board.scale.kind == ScaleKind::slider ? panel::slider_height_m
                                                                              : grid.height_m},
                           left, made.top(), scale_m));
            if (board.scale.kind == ScaleKind::slider && stimulus.value)
                made.sliderValue(*stimulus.value, value_m, !captions);
        }
        made.advance(row_m, row_gap_m);
    }
    return made.finish();
}

Panel pairwisePanel(const PairwiseBoard& board, const LanguageTable& words) {
    panel::Builder made(panel::wide_m);
    const double play_m = std::max(panel::buttonWidth(words("left"), ButtonRole::play),
                                   panel::buttonWidth(words("right"), ButtonRole::play));
    const auto play = [&](const StimulusView& stimulus, const char* side, int place, double x) {
        made.button({words(side), button_id::first_play + place, ButtonRole::play, stimulus.can_play}, x,
                    made.top(), play_m, panel::caption_height_m);
        made.lastButton().caption = playWord(stimulus.state, words);
        markPlay(made.lastButton(), stimulus);
    };
    play(board.left, "left", 0, panel::margin_m);
    play(board.right, "right", 1, panel::wide_m - panel::margin_m - play_m);

    const double text_m = made.inner() - 2.0 * (play_m + panel::gap_m);
    const double left = panel::margin_m + play_m + panel::gap_m;
    const double question_m =
        made.text(board.question, left, made.top(), text_m, {panel::question_size_m, true, true});
    const double hint_m = made.text(board.hint, left, made.top() - question_m - row_gap_m, text_m,
                                    {panel::label_size_m, false, true, true});
    made.advance(std::max(panel::caption_height_m, question_m + row_gap_m + hint_m));

    constexpr std::array<const char*, 5> preferences{"prefer_left_clearly", "prefer_left_slightly",
                                                     "prefer_neither", "prefer_right_slightly",
                                                     "prefer_right_clearly"};
    constexpr auto count = static_cast<double>(preferences.size());
    constexpr double between_m = 0.016;
    const double option_m = (made.inner() - (count - 1.0) * between_m) / count;
    for (std::size_t i = 0; i < preferences.size(); ++i) {
        const int place = static_cast<int>(i);
        made.button(
            {words(preferences[i]), button_id::first_rating + place, ButtonRole::option, board.can_answer},
            panel::margin_m + place * (option_m + between_m), made.top(), option_m, panel::button_height_m);
        made.lastButton().chosen = board.preference == place - 2;
    }
    return made.finish();
}

}  // namespace deixis::studies
