#include "operator_controls.hpp"

#include <utility>

namespace deixis::app {

namespace {

constexpr float button_height = 38.0F;
constexpr float button_gap = 8.0F;
constexpr float question_lines = 86.0F;  ///< title, what it means on two lines

class Controls {
  public:
    Controls(const PanelPen& pen, const OperatorView& view, OperatorControls& controls, double now_s)
        : pen_(pen),
          view_(view),
          controls_(controls),
          now_s_(now_s),
          half_(0.5F * (pen.width() - pen.px(button_gap))),
          high_(pen.px(button_height)) {}

    void draw() {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {pen_.px(button_gap), pen_.px(button_gap)});
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                            {pen_.px(10.0F), 0.5F * (high_ - pen_.gui().regular()->FontSize)});
        bool typing = false;
        if (controls_.question() == OperatorControls::Question::none) {
            typing = note();
            buttons();
        } else {
            typing = question();
        }
        controls_.setTyping(typing);
        ImGui::PopStyleVar(2);
    }

  private:
    const PanelPen& pen_;
    const OperatorView& view_;
    OperatorControls& controls_;
    double now_s_;
    float half_, high_;

    [[nodiscard]] bool button(const char* label, float across) const {
        return ImGui::Button(label, {across, high_});
    }

    bool note() {
        const float add = pen_.px(64.0F);
        ImGui::SetNextItemWidth(pen_.width() - add - pen_.px(button_gap));
        const bool entered =
            ImGui::InputTextWithHint("##note", "Note for the record", controls_.note().data(),
                                     controls_.note().size(), ImGuiInputTextFlags_EnterReturnsTrue);
        const bool typing = ImGui::IsItemActive();
        ImGui::SameLine();
        if (button("Add", add) || entered) controls_.addNote();
        return typing;
    }

    void buttons() {
        const float first = view_.has_place ? half_ : pen_.width();
        if (view_.paused) {
            if (button("Resume (P)", first)) controls_.resume();
        } else if (button("Pause (P)", first)) {
            controls_.pause();
        }
        if (view_.has_place) {
            ImGui::SameLine();
            if (button("Recentre (R)", half_)) controls_.recentre();
        }
        if (const auto left = controls_.repeatLeft(now_s_)) {
            if (really("repeat", "Really repeat?", "The old answer is kept and marked.", pen_.width(), *left))
                controls_.repeatLast(now_s_);
        } else {
            if (button("Repeat last trial", half_)) controls_.repeatLast(now_s_);
            ImGui::SameLine();
            if (button("Skip trial\u2026", half_)) controls_.ask(OperatorControls::Question::skip);
        }
        if (const auto left = controls_.endLeft(now_s_)) {
            if (really("end", "Really end?", "The answers so far are kept; it can be resumed.", pen_.width(),
                       *left))
                controls_.end(now_s_);
        } else {
            if (button("Abort session\u2026", half_)) controls_.ask(OperatorControls::Question::abort);
            ImGui::SameLine();
            if (button("End session", half_)) controls_.end(now_s_);
        }
    }

    bool question() {
        const bool skips = controls_.question() == OperatorControls::Question::skip;
        const float top = ImGui::GetCursorPosY();
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {pen_.px(button_gap), pen_.px(PanelPen::line_gap)});
        pen_.write(pen_.gui().bold(), look::text, skips ? "Skip this trial?" : "Abort the session?");
        pen_.write(pen_.gui().small(), look::faint,
                   skips ? "It gets no answer. The reason is kept with it."
                         : "The participant then counts as a drop-out. The answers so far and the reason are "
                           "kept.");
        ImGui::PopStyleVar();
        ImGui::SetCursorPosY(top + pen_.px(question_lines));
        ImGui::SetNextItemWidth(pen_.width());
        const float place = ImGui::GetCursorPosY();
        if (askedAnew()) ImGui::SetKeyboardFocusHere();
        const bool entered =
            ImGui::InputTextWithHint("##reason", "Reason (required)", controls_.reason().data(),
                                     controls_.reason().size(), ImGuiInputTextFlags_EnterReturnsTrue);
        const bool typing = ImGui::IsItemActive();
        if (entered && !controls_.answered()) lastAsked() = -1;  // the field takes the keyboard again
        ImGui::SetCursorPosY(place + high_ + pen_.px(button_gap));
        const bool ready = controls_.answered();
        ImGui::BeginDisabled(!ready);
        bool pressed = false;
        if (const auto left = controls_.abortLeft(now_s_))
            pressed = really("abort", "Really abort?", "Press once more.", half_, *left);
        else
            pressed = button(skips ? "Skip trial" : "Abort session", half_);
        ImGui::EndDisabled();
        ImGui::SameLine();
        if (button("Back (Esc)", half_))
            controls_.leaveQuestion();
        else if (pressed || entered)
            controls_.answer(now_s_);
        return typing;
    }

    // The picture in which the question was shown last.
    static int& lastAsked() { return *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("question"), -1); }

    // Whether the question that is shown was not there in the picture before.
    static bool askedAnew() {
        const int before = std::exchange(lastAsked(), ImGui::GetFrameCount());
        return before != ImGui::GetFrameCount() - 1;
    }

    // A question in a button's place; the time for the second press runs out along its foot.
    [[nodiscard]] bool really(const char* id, const char* question, const char* meaning, float across,
                              double left) const {
        ImGui::PushID(id);
        ImGui::PushStyleColor(ImGuiCol_Button, look::danger);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, look::danger_hovered);
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, look::danger);
        const bool pressed = button("##really", across);
        ImGui::PopStyleColor(3);
        ImGui::PopID();
        const ImVec2 low = ImGui::GetItemRectMin();
        const ImVec2 high = ImGui::GetItemRectMax();
        PanelPen::centredOver(pen_.gui().bold(), question, low.y + pen_.px(1.0F));
        PanelPen::centredOver(pen_.gui().small(), meaning, low.y + pen_.px(18.0F));
        const float inset = ImGui::GetStyle().FrameRounding;
        const float run = (high.x - low.x - 2.0F * inset) * static_cast<float>(left);
        ImGui::GetWindowDrawList()->AddRectFilled({low.x + inset, high.y - pen_.px(4.0F)},
                                                  {low.x + inset + run, high.y - pen_.px(2.0F)}, look::text);
        return pressed;
    }
};

}  // namespace

float controlsHeight(const PanelPen& pen, const OperatorControls& controls) {
    const float row = pen.px(button_height) + pen.px(button_gap);
    if (controls.question() == OperatorControls::Question::none) return 4.0F * row - pen.px(button_gap);
    return pen.px(question_lines) + 2.0F * row - pen.px(button_gap);
}

void drawControls(const PanelPen& pen, const OperatorView& view, OperatorControls& controls, double now_s) {
    Controls(pen, view, controls, now_s).draw();
}

}  // namespace deixis::app
