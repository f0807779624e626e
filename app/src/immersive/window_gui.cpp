#include "window_gui.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_opengl3.h>

#include <array>
#include <cmath>
#include <utility>

#include "renderer/fonts.hpp"

namespace deixis::app {

namespace {

// Latin, and the dashes, quotes, ellipsis and trade mark that device names and messages may have.
constexpr std::array<ImWchar, 7> letters{0x20, 0xFF, 0x2010, 0x2026, 0x2122, 0x2122, 0};

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
    const auto add = [&](const std::string& file, float size) {
        return fonts.AddFontFromFileTTF(file.c_str(), std::round(size * scale), nullptr, letters.data());
    };
    regular_ = add(renderer::regularFontFile(), 18.0F);  // the first is the one in use
    small_ = add(renderer::regularFontFile(), 15.0F);
    bold_ = add(renderer::boldFontFile(), 18.0F);
    large_ = add(renderer::boldFontFile(), 28.0F);
    ImGui_ImplOpenGL3_DestroyDeviceObjects();  // the letters among them; made anew with the next frame

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
    if (const float scale = contentScale(window_); scale != scale_) setUp(scale);
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
}

void WindowGui::endFrame() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace deixis::app
