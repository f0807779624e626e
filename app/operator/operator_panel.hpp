// The panel of the experimenter's window: what it tells, and over its foot the buttons and fields.
#pragma once

#include "app/operator/operator_request.hpp"
#include "app/operator/operator_view.hpp"
#include "app/window/window_gui.hpp"

namespace deixis::app {

/// Draws between WindowGui::beginFrame() and endFrame(), at this place (pixels, y down). What is pressed and
/// typed goes to the controls. `now_s`: on the controls' clock.
void drawOperatorPanel(const WindowGui& gui, ImVec2 corner, ImVec2 size, const OperatorView& view,
                       OperatorControls& controls, double now_s);

}  // namespace deixis::app
