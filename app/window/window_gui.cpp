#include "app/window/window_gui.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "renderer/boards/fonts.hpp"

namespace deixis::app {

namespace {

// Latin, and the dashes, quotes, ellipsis and trade mark that device names and messages may have.
constexpr std::array<ImWchar, 7> common_letters{0x20, 0xFF, 0x2010, 0x2026, 0x2122, 0x2122, 0};

float contentScale(GLFWwindow* window) {
    float across = 1.0F;
    float down = 1.0F;
    glfwGetWindowContentScale(window, &across, &down);
    return across > 0.0F ? across : 1.0F;
}

void setColours(ImGuiStyle& style) {
    const std::array<std::pair<ImGuiCol, ImU32>, 16> colours{{
        {ImGuiCol_Text, look::text},
        {ImGuiCol_TextDisabled, look::faint},
        {ImGuiCol_WindowBg, look::background},
        {ImGuiCol_Border, look::edge},
        {ImGuiCol_FrameBg, look::edge},
        {ImGuiCol_FrameBgHovered, look::button},
        {ImGuiCol_FrameBgActive, look::button},
        {ImGuiCol_SliderGrab, look::good},
        {ImGuiCol_SliderGrabActive, look::warning},
        {ImGuiCol_Button, look::button},
        {ImGuiCol_ButtonHovered, look::button_hovered},
        {ImGuiCol_ButtonActive, look::button_held},
        {ImGuiCol_ScrollbarBg, look::background},
        {ImGuiCol_ScrollbarGrab, look::button},
        {ImGuiCol_ScrollbarGrabHovered, look::button_hovered},
        {ImGuiCol_ScrollbarGrabActive, look::button_hovered},
    }};
    for (const auto& [which, colour] : colours) style.Colors[which] = ImGui::ColorConvertU32ToFloat4(colour);
}

}  // namespace

WindowGui::WindowGui(GLFWwindow* window) : window_(window), context_(ImGui::CreateContext()) {
    makeCurrent();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 450 core");
    setUp(contentScale(window));
}

WindowGui::~WindowGui() {
    makeCurrent();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext(context_);
}

void WindowGui::makeCurrent() const {
    ImGui::SetCurrentContext(context_);
}

void WindowGui::setUp(float scale) {
    scale_ = scale;
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.Clear();
    ImFontGlyphRangesBuilder builder;
    builder.AddRanges(common_letters.data());
    for (const ImWchar letter : letters_) builder.AddChar(letter);
    ImVector<ImWchar> ranges;
    builder.BuildRanges(&ranges);
    const auto add = [&](bool bold, float size) {
        const std::string file = bold ? renderer::boldFontFile() : renderer::regularFontFile();
        const float pixels = std::round(size * scale);
        ImFont* font = fonts.AddFontFromFileTTF(file.c_str(), pixels, nullptr, ranges.Data);
        if (!letters_.empty()) {
            const std::string more =
                bold ? renderer::boldHangulFontFile() : renderer::regularHangulFontFile();
            ImFontConfig config;
            config.MergeMode = true;  // only what the first face lacks
            fonts.AddFontFromFileTTF(more.c_str(), renderer::hangul_size * pixels, &config, ranges.Data);
        }
        return font;
    };
    regular_ = add(false, 18.0F);  // the first is the one in use
    small_ = add(false, 15.0F);
    bold_ = add(true, 18.0F);
    large_ = add(true, 28.0F);
    fonts.Build();  // now, while the ranges are there
    has_letters_ = true;
    ImGui_ImplOpenGL3_DestroyDeviceObjects();  // the letters among them; made again with the next frame

    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    setColours(style);
    style.WindowRounding = 8.0F;
    style.FrameRounding = 6.0F;
    style.ScrollbarSize = 10.0F;
    style.ScaleAllSizes(scale);
}

void WindowGui::beginFrame() {
    makeCurrent();
    if (const float scale = contentScale(window_); scale != scale_ || !has_letters_) setUp(scale);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void WindowGui::require(std::string_view text) {
    const auto latin = [](char c) { return static_cast<unsigned char>(c) < 0xC4; };  // Latin-1 and below
    if (std::all_of(text.begin(), text.end(), latin)) return;
    ImFontGlyphRangesBuilder builder;
    builder.AddText(text.data(), text.data() + text.size());
    ImVector<ImWchar> ranges;
    builder.BuildRanges(&ranges);
    for (int i = 0; i + 1 < ranges.Size && ranges[i] != 0; i += 2)
        for (unsigned c = ranges[i]; c <= ranges[i + 1]; ++c)
            if (c > 0xFF && letters_.insert(static_cast<ImWchar>(c)).second) has_letters_ = false;
}

void WindowGui::endFrame() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace deixis::app
