#include "panel_layout.hpp"

#include <array>

#include "panel_build.hpp"

namespace deixis::studies {

namespace {

struct Measure {
    double width_m;
    double body_size_m;
};

Panel messageOf(const Measure& measure, const std::string& title, const std::string& body,
                const std::string& emphasis, const std::vector<ButtonSpec>& buttons, double progress) {
    panel::Builder board(measure.width_m);
    board.paragraph(title, {panel::title_size_m, true});
    board.paragraph(body, {measure.body_size_m});
    board.paragraph(emphasis, {measure.body_size_m, true});
    board.advance(0.0, panel::gap_m / 2.0);
    board.buttons(buttons, panel::margin_m, board.top(), board.inner(), panel::button_height_m, true);
    return board.finish(progress);
}

}  // namespace

Panel messagePanel(const std::string& title, const std::string& body, const std::string& emphasis,
                   const std::vector<ButtonSpec>& buttons, double progress) {
    constexpr double comfortable_height_m = 1.0;
    constexpr std::array<Measure, 5> measures{
        {{1.1, 0.046}, {1.3, 0.046}, {1.5, 0.046}, {1.6, 0.04}, {1.6, 0.036}}};
    Panel made;
    for (const Measure& measure : measures) {
        made = messageOf(measure, title, body, emphasis, buttons, progress);
        if (made.height_m <= comfortable_height_m) break;
    }
    return made;
}

Panel signPanel(const std::string& sentence, const std::string& large) {
    panel::Builder board(0.8);
    board.paragraph(sentence, {0.07, true, true});
    board.paragraph(large, {0.16, true, true});
    return board.finish();
}

}  // namespace deixis::studies
