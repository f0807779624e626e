#include "studies/boards/panel_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "panel_build.hpp"
#include "studies/station/notice.hpp"
#include "studies/texts/text_layout.hpp"

namespace deixis::studies {

namespace {

struct Measure {
    double width_m;
    double body_size_m;
};

Panel messageOf(const Measure& measure, const std::string& title, const std::string& body,
                const std::string& emphasis, const std::vector<ButtonSpec>& buttons, double progress,
                const std::string& foot) {
    panel::Builder board(measure.width_m);
    board.paragraph(title, {panel::title_size_m, true});
    board.paragraph(body, {measure.body_size_m});
    board.paragraph(emphasis, {measure.body_size_m, true});
    board.advance(0.0, panel::gap_m / 2.0);
    board.advance(
        board.buttons(buttons, panel::margin_m, board.top(), board.inner(), panel::button_height_m, true));
    board.paragraph(foot, {panel::label_size_m, false, true, true});
    return board.finish(progress);
}

}  // namespace

Panel messagePanel(const std::string& title, const std::string& body, const std::string& emphasis,
                   const std::vector<ButtonSpec>& buttons, double progress, const std::string& foot) {
    constexpr double comfortable_height_m = 1.0;
    constexpr std::array<Measure, 5> measures{
        {{1.1, 0.046}, {1.3, 0.046}, {1.5, 0.046}, {1.6, 0.04}, {1.6, 0.036}}};
    Panel made;
    for (const Measure& measure : measures) {
        made = messageOf(measure, title, body, emphasis, buttons, progress, foot);
        if (made.height_m <= comfortable_height_m) break;
    }
    return made;
}

Panel noticePanel(const std::string& sentence, double line_m) {
    constexpr double inset = 0.9;  // lines, on either side
    Panel board;
    board.width_m =
        std::clamp(textWidth(sentence, line_m) + 2.0 * inset * line_m + 1e-6, 11.0 * line_m, 26.0 * line_m);
    PanelText text;
    const double width_m = board.width_m - 2.0 * inset * line_m;
    const auto lines = wrapText(sentence, line_m, width_m);
    const double height_m = static_cast<double>(std::max<std::size_t>(2, lines.size())) * line_m;
    board.height_m = height_m + 1.2 * line_m;
    text.box = {inset * line_m, 0.6 * line_m, width_m, height_m};
    text.text = fmt::format("{}", fmt::join(lines, "\n"));
    text.size_m = line_m;
    text.centred = true;
    text.level = true;
    board.texts.push_back(std::move(text));
    return board;
}

Panel signPanel(const std::string& sentence, const std::string& large) {
    panel::Builder board(0.8);
    board.paragraph(sentence, {0.07, true, true});
    board.paragraph(large, {0.16, true, true});
    return board.finish();
}

}  // namespace deixis::studies
