// The panel of the experimenter's window: what it shows, and what was clicked.
#pragma once

#include <optional>

#include "../window_gui.hpp"
#include "operator_window.hpp"

namespace deixis::app {

struct PanelClicks {
    bool pause = false;
    bool recentre = false;
    bool end = false;
};

/// Draws between WindowGui::beginFrame() and endFrame(), at this place (pixels, y down). `end_question`: how
/// much of the time for asking a second time to end is left, 0..1; none: not asked.
[[nodiscard]] PanelClicks drawOperatorPanel(const WindowGui& gui, ImVec2 corner, ImVec2 size,
                                            const OperatorView& view, std::optional<double> end_question);

}  // namespace deixis::app
