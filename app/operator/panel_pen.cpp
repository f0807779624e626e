#include "panel_pen.hpp"

#include <algorithm>
#include <cstddef>

#include "core/text.hpp"

namespace deixis::app {

namespace {

constexpr float light_radius = 6.0F;

}  // namespace

float PanelPen::widthOf(ImFont* font, std::string_view text) {
    return font->CalcTextSizeA(font->FontSize, 1e9F, 0.0F, text.data(), text.data() + text.size()).x;
}

std::string PanelPen::fitted(ImFont* font, std::string_view text, float across) {
    if (widthOf(font, text) <= across) return std::string(text);
    constexpr std::string_view dots = "\u2026";
    const float left = across - widthOf(font, dots);
    std::size_t end = text.size();
    while (end > 0 && (continuesCharacter(text[end - 1]) || widthOf(font, text.substr(0, end)) > left)) --end;
    // Up to the beginning of a letter that no longer fits.
    while (end > 0 && end < text.size() && continuesCharacter(text[end])) --end;
    return std::string(text.substr(0, end)) + std::string(dots);
}

void PanelPen::line(ImFont* font, ImU32 colour, std::string_view text) {
    ImGui::PushFont(font);
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void PanelPen::write(ImFont* font, ImU32 colour, std::string_view text) const {
    ImGui::PushTextWrapPos(width_);
    line(font, colour, text);
    ImGui::PopTextWrapPos();
}

void PanelPen::right(ImFont* font, ImU32 colour, std::string_view text, float left_width) const {
    const float place = width_ - widthOf(font, text);
    if (left_width + px(12.0F) > place) {
        write(font, colour, text);
        return;
    }
    ImGui::SameLine(place);
    line(font, colour, text);
}

void PanelPen::row(std::string_view name, ImFont* font, ImU32 colour, std::string_view value) const {
    write(gui_.regular(), look::faint, name);
    right(font, colour, value, widthOf(gui_.regular(), name));
}

void PanelPen::gap(float height) const {
    ImGui::Dummy({1.0F, std::max(1.0F, px(height - line_gap))});
}

void PanelPen::section(std::string_view title) const {
    gap(section_gap);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + width_, at.y + std::max(1.0F, gui_.scale())},
                                              look::edge);
    gap(section_gap);
    write(gui_.small(), look::faint, title);
}

void PanelPen::bar(double share, float height, ImU32 colour) const {
    barAt(ImGui::GetCursorScreenPos(), width_, share, height, colour);
    ImGui::Dummy({width_, px(height)});
}

void PanelPen::barAt(ImVec2 at, float across, double share, float height, ImU32 colour) const {
    const float round = 0.5F * px(height);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + across, at.y + px(height)}, look::edge, round);
    // A beginning shows, however small.
    const float filled = std::max(2.0F * round, across * static_cast<float>(std::clamp(share, 0.0, 1.0)));
    if (share > 0.0) list.AddRectFilled(at, {at.x + filled, at.y + px(height)}, colour, round);
}

void PanelPen::light(bool lit, ImU32 colour) const {
    const float line_height = ImGui::GetTextLineHeight();
    const float radius = px(light_radius);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 centre{at.x + radius, at.y + 0.5F * line_height + 0.5F * gui_.scale()};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (lit)
        list.AddCircleFilled(centre, radius, colour);
    else
        list.AddCircle(centre, radius - 0.5F * px(2.0F), colour, 0, px(2.0F));
    ImGui::Dummy({2.0F * radius, line_height});
    ImGui::SameLine();
}

void PanelPen::warning(std::string_view text) const {
    gap(line_gap);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::Indent(px(14.0F));
    write(gui_.regular(), look::warning, text);
    ImGui::Unindent(px(14.0F));
    const float foot = ImGui::GetItemRectMax().y;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + px(3.0F)}, {at.x + px(3.0F), foot}, look::warning,
                                              px(1.5F));
}

void PanelPen::hint(std::string_view text, float across, float height) const {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImFont* font = gui_.small();
    const ImVec2 size =
        font->CalcTextSizeA(font->FontSize, across, across, text.data(), text.data() + text.size());
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {at.x, at.y + 0.5F * (height - size.y)},
                                        look::faint, text.data(), text.data() + text.size(), across);
    ImGui::Dummy({across, height});
}

void PanelPen::centredOver(ImFont* font, std::string_view text, float top) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize,
                                        {low.x + 0.5F * (high.x - low.x - widthOf(font, text)), top},
                                        look::text, text.data(), text.data() + text.size());
}

}  // namespace deixis::app
