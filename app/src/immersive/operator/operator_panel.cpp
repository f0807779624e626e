#include "operator_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "operator_words.hpp"

namespace deixis::app {

namespace {

// Lengths are in units of WindowGui::scale().
constexpr float margin = 20.0F;  // at the right with room for a scroll bar
constexpr float section_gap = 12.0F;
constexpr float line_gap = 5.0F;
constexpr float button_height = 40.0F;
constexpr float button_gap = 8.0F;
constexpr float light_radius = 6.0F;

class Panel {
  public:
    Panel(const WindowGui& gui, const OperatorView& view, ImVec2 size)
        : gui_(gui), view_(view), size_(size), width_(size.x - 2.0F * px(margin)) {}

    [[nodiscard]] PanelClicks draw(ImVec2 corner, std::optional<double> end_question) const {
        const float edge = std::max(1.0F, gui_.scale());
        ImGui::SetNextWindowPos(corner);
        ImGui::SetNextWindowSize(size_);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {px(margin), px(margin)});
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(8.0F), px(line_gap)});
        ImGui::Begin("operator", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
        ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + edge, corner.y + size_.y}, look::edge);
        // What can be pressed stays in sight, whatever there is to tell. The scroll bar has the margin.
        const float told_height = size_.y - 2.0F * px(margin) - buttonsHeight() - px(section_gap);
        ImGui::BeginChild("told", {width_ + 0.5F * px(margin), std::max(1.0F, told_height)}, false,
                          ImGuiWindowFlags_NoNav);
        participant();
        session();
        headset();
        warnings();
        ImGui::EndChild();
        ImGui::SetCursorPosY(size_.y - px(margin) - buttonsHeight());
        const PanelClicks clicks = buttons(end_question);
        ImGui::End();
        ImGui::PopStyleVar(4);
        return clicks;
    }

  private:
    const WindowGui& gui_;
    const OperatorView& view_;
    ImVec2 size_;
    float width_;  // of what is written

    [[nodiscard]] float px(float length) const { return length * gui_.scale(); }

    static float widthOf(ImFont* font, std::string_view text) {
        return font->CalcTextSizeA(font->FontSize, 1e9F, 0.0F, text.data(), text.data() + text.size()).x;
    }

    // On one line.
    static void writeLine(ImFont* font, ImU32 colour, std::string_view text) {
        ImGui::PushFont(font);
        ImGui::PushStyleColor(ImGuiCol_Text, colour);
        ImGui::TextUnformatted(text.data(), text.data() + text.size());
        ImGui::PopStyleColor();
        ImGui::PopFont();
    }

    // On as many lines as it needs.
    void write(ImFont* font, ImU32 colour, std::string_view text) const {
        ImGui::PushTextWrapPos(width_);
        writeLine(font, colour, text);
        ImGui::PopTextWrapPos();
    }

    // Against the right edge of the line last written, or on a line of its own where that is too full.
    void writeRight(ImFont* font, ImU32 colour, std::string_view text, float left_width) const {
        const float place = width_ - widthOf(font, text);
        if (left_width + px(12.0F) > place) {
            write(font, colour, text);
            return;
        }
        ImGui::SameLine(place);
        writeLine(font, colour, text);
    }

    // A line with a name at its left and a value at its right.
    void row(std::string_view name, ImFont* font, ImU32 colour, std::string_view value) const {
        write(gui_.regular(), look::faint, name);
        writeRight(font, colour, value, widthOf(gui_.regular(), name));
    }

    void gap(float height) const { ImGui::Dummy({1.0F, std::max(1.0F, px(height - line_gap))}); }

    void section(std::string_view title) const {
        gap(section_gap);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width_, at.y + std::max(1.0F, gui_.scale())},
                                                  look::edge);
        gap(section_gap);
        write(gui_.small(), look::faint, title);
    }

    void bar(double share, float height, ImU32 colour) const {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float full = width_;
        const float round = 0.5F * px(height);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled(at, {at.x + full, at.y + px(height)}, look::edge, round);
        const float filled = full * static_cast<float>(std::clamp(share, 0.0, 1.0));
        if (filled >= 2.0F * round) list.AddRectFilled(at, {at.x + filled, at.y + px(height)}, colour, round);
        ImGui::Dummy({full, px(height)});
    }

    void participant() const {
        const std::string elapsed = elapsedInWords(view_.elapsed_s);
        const float own = widthOf(gui_.large(), view_.participant);
        const float beside = widthOf(gui_.large(), elapsed) + px(12.0F);
        write(gui_.small(), look::faint, "Participant");
        if (own + beside <= width_) {
            writeRight(gui_.small(), look::faint, "Elapsed", widthOf(gui_.small(), "Participant"));
            write(gui_.large(), look::text, view_.participant);
            writeRight(gui_.large(), look::text, elapsed, own);
        } else {
            write(gui_.bold(), look::text, view_.participant);
            row("Elapsed", gui_.bold(), look::text, elapsed);
        }
    }

    void session() const {
        section("Session");
        if (view_.status.empty()) {
            write(gui_.regular(), look::text, "Not begun yet");
            return;
        }
        const StudyProgress progress = studyProgress(view_.status);
        write(gui_.bold(), look::text, progress.stage);
        if (const auto done = progress.done()) {
            writeRight(gui_.bold(), look::text, fmt::format("{} of {}", progress.trial, progress.trials),
                       widthOf(gui_.bold(), progress.stage));
            bar(*done, 6.0F, look::good);
            gap(line_gap + 2.0F);
        }
        write(gui_.regular(), view_.paused ? look::warning : look::text,
              progress.remark.empty() ? stateInWords(view_.state) : progress.remark);
    }

    void headset() const {
        section("Headset");
        write(gui_.regular(), look::text, view_.headset);
        const HeadsetWords state = headsetInWords(view_.headset_state);
        light(state.in_use, state.in_use ? look::good : look::warning);
        write(gui_.regular(), state.in_use ? look::text : look::warning, state.words);
        gap(line_gap + 4.0F);
        row("Frames per second", gui_.bold(), look::text, fmt::format("{:.0f}", view_.frames_per_s));
        row("Dropped frames", gui_.bold(), look::text, fmt::format("{}", view_.dropped_frames));
        distance();
        gap(line_gap + 6.0F);
        tracking();
    }

    void distance() const {
        if (!view_.head_tracked) {
            row("From the place", gui_.bold(), look::faint, "not known");
            return;
        }
        const bool off = view_.off_place_m > view_.place_tolerance_m;
        row("From the place", gui_.bold(), off ? look::warning : look::text,
            distanceInWords(view_.off_place_m));
        if (off)
            write(gui_.small(), look::warning,
                  fmt::format("Farther than {}: the participant is asked back.",
                              distanceInWords(view_.place_tolerance_m)));
    }

    // A disc where it is lit, a ring where not: colour alone does not tell it. The line goes on behind it.
    void light(bool lit, ImU32 colour) const {
        const float line = ImGui::GetTextLineHeight();
        const float radius = px(light_radius);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const ImVec2 centre{at.x + radius, at.y + 0.5F * line + 0.5F * gui_.scale()};
        ImDrawList& list = *ImGui::GetWindowDrawList();
        if (lit)
            list.AddCircleFilled(centre, radius, colour);
        else
            list.AddCircle(centre, radius - 0.5F * px(2.0F), colour, 0, px(2.0F));
        ImGui::Dummy({2.0F * radius, line});
        ImGui::SameLine();
    }

    void tracking() const {
        write(gui_.regular(), look::faint, "Tracked");
        const char* const ray = view_.ray_hand == 'L' ? "Ray from the left" : "Ray from the right";
        writeRight(gui_.regular(), look::ray, ray, widthOf(gui_.regular(), "Tracked"));
        tracked("Head", view_.head_tracked, 0.0F);
        tracked("Left", view_.left_tracked, 0.36F);
        tracked("Right", view_.right_tracked, 0.70F);
    }

    void tracked(std::string_view name, bool is, float place) const {
        if (place > 0.0F) ImGui::SameLine(place * width_);
        light(is, is ? look::good : look::warning);
        writeLine(gui_.regular(), is ? look::text : look::warning, name);
    }

    void warnings() const {
        if (view_.warnings.empty()) return;
        section("Please note");
        for (const std::string& warning : view_.warnings) {
            gap(line_gap);
            const ImVec2 at = ImGui::GetCursorScreenPos();
            ImGui::Indent(px(14.0F));
            write(gui_.regular(), look::warning, warning);
            ImGui::Unindent(px(14.0F));
            const float foot = ImGui::GetItemRectMax().y;
            ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + px(3.0F)}, {at.x + px(3.0F), foot},
                                                      look::warning, px(1.5F));
        }
    }

    [[nodiscard]] float buttonsHeight() const { return 2.0F * px(button_height) + px(button_gap); }

    PanelClicks buttons(std::optional<double> end_question) const {
        PanelClicks clicks;
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(button_gap), px(button_gap)});
        const float half = 0.5F * (width_ - px(button_gap));
        if (view_.paused)
            hint("The participant resumes on the board.", half);
        else
            clicks.pause = ImGui::Button("Pause (P)", {half, px(button_height)});
        ImGui::SameLine();
        clicks.recentre = ImGui::Button("Recentre (R)", {half, px(button_height)});
        clicks.end = endButton(end_question);
        ImGui::PopStyleVar();
        return clicks;
    }

    void hint(std::string_view text, float across) const {
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImFont* font = gui_.small();
        const ImVec2 size =
            font->CalcTextSizeA(font->FontSize, across, across, text.data(), text.data() + text.size());
        ImGui::GetWindowDrawList()->AddText(font, font->FontSize,
                                            {at.x, at.y + 0.5F * (px(button_height) - size.y)}, look::faint,
                                            text.data(), text.data() + text.size(), across);
        ImGui::Dummy({across, px(button_height)});
    }

    // Its own question takes its place; the time for the second press runs out along its foot.
    bool endButton(std::optional<double> question) const {
        const ImVec2 size{width_, px(button_height)};
        if (!question) return ImGui::Button("End session", size);
        ImGui::PushStyleColor(ImGuiCol_Button, look::danger);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, look::danger_hovered);
        ImGui::PushStyleColor(ImGuiCol_ButtonActive, look::danger);
        const bool pressed = ImGui::Button("##really end", size);
        ImGui::PopStyleColor(3);
        const ImVec2 low = ImGui::GetItemRectMin();
        const ImVec2 high = ImGui::GetItemRectMax();
        writeCentred(gui_.bold(), "Really end?", low.y + px(1.0F));
        writeCentred(gui_.small(), "The answers so far are kept.", low.y + px(18.0F));
        const float inset = ImGui::GetStyle().FrameRounding;
        const float run = (high.x - low.x - 2.0F * inset) * static_cast<float>(*question);
        ImGui::GetWindowDrawList()->AddRectFilled({low.x + inset, high.y - px(4.0F)},
                                                  {low.x + inset + run, high.y - px(2.0F)}, look::text);
        return pressed;
    }

    // Over what was drawn last.
    void writeCentred(ImFont* font, std::string_view text, float top) const {
        const ImVec2 low = ImGui::GetItemRectMin();
        ImGui::GetWindowDrawList()->AddText(font, font->FontSize,
                                            {low.x + 0.5F * (width_ - widthOf(font, text)), top}, look::text,
                                            text.data(), text.data() + text.size());
    }
};

}  // namespace

PanelClicks drawOperatorPanel(const WindowGui& gui, ImVec2 corner, ImVec2 size, const OperatorView& view,
                              std::optional<double> end_question) {
    return Panel(gui, view, size).draw(corner, end_question);
}

}  // namespace deixis::app
