// The buttons and fields at the foot of the operator's panel.
#pragma once

#include "app/operator/operator_request.hpp"
#include "app/operator/operator_view.hpp"
#include "panel_pen.hpp"

namespace deixis::app {

/// Pixels; the same in every state but where a reason is asked for.
[[nodiscard]] float controlsHeight(const PanelPen& pen, const OperatorControls& controls);

/// Draws where ImGui's cursor stands.
void drawControls(const PanelPen& pen, const OperatorView& view, OperatorControls& controls, double now_s);

}  // namespace deixis::app
