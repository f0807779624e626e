#include "scale_answer.hpp"

#include <utility>

namespace deixis::studies {

ScaleAnswer::ScaleAnswer(SessionCore& core, const std::string& question, const Scale& scale)
    : core_(core), question_(question), scale_(scale) {}

Panel ScaleAnswer::board() const {
    RatingBoard board;
    board.question = question_;
    board.scale = scale_;
    board.value = value_;
    board.replay = replay_;
    if (slider())
        board.confirm =
            ButtonSpec{core_.words()("confirm"), button_id::go_on, ButtonRole::go_on, value_.has_value()};
    return ratingPanel(board);
}

void ScaleAnswer::open(const InputFrame& input, std::optional<ButtonSpec> replay, PanelPlace place) {
    replay_ = std::move(replay);
    core_.openPanel(board(), input, std::move(place));
}

std::optional<ScaleGiven> ScaleAnswer::step(const InputFrame& input, const Aim& met, const AnswerGate& gate,
                                            bool select) {
    if (!gate.accepts()) return std::nullopt;
    if (slider()) {
        if (const auto set = core_.view.drag(input, met, select)) {
            const bool first = !value_;
            value_ = set->value;
            if (first) core_.view.updatePanel(board());
        }
        if (!value_) return std::nullopt;
        if (select && met.button == button_id::go_on) return ScaleGiven{*value_, selectTime(input), "ray"};
        if (input.confirm && gate.admitsKey(input)) return ScaleGiven{*value_, keyTime(input), "key"};
        return std::nullopt;
    }
    const int place = met.button - button_id::first_rating;
    if (select && place >= 0 && place < scale_.steps())
        return ScaleGiven{scale_.low + place, selectTime(input), "ray"};
    if (input.digit && *input.digit >= scale_.low && *input.digit <= scale_.high && gate.admitsKey(input))
        return ScaleGiven{*input.digit, keyTime(input), "key"};
    return std::nullopt;
}

void ScaleAnswer::confirm(int value) {
    core_.view.confirmButton(slider() ? button_id::go_on : button_id::first_rating + value - scale_.low);
}

}  // namespace deixis::studies
