#include "operator_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "app/operator/operator_words.hpp"
#include "core/text.hpp"
#include "operator_controls.hpp"
#include "panel_pen.hpp"

namespace deixis::app {

namespace {

// Lengths are in units of WindowGui::scale().
constexpr float margin = 20.0F;  // at the right with room for a scroll bar
constexpr float stage_height = 24.0F;
constexpr float stage_bar = 64.0F;
constexpr int stages_in_sight = 8;
constexpr std::size_t events_in_sight = 6;
constexpr std::uintmax_t little_space_bytes = 1'000'000'000;
constexpr double usual_wait_s = 1.0;  // of an answer for the disk

class Panel {
  public:
    Panel(const WindowGui& gui, const OperatorView& view, OperatorControls& controls, ImVec2 size)
        : gui_(gui),
          view_(view),
          controls_(controls),
          size_(size),
          pen_(gui, size.x - 2.0F * margin * gui.scale()) {}

    void draw(ImVec2 corner, double now_s) const {
        const float edge = std::max(1.0F, gui_.scale());
        const float space = px(margin);
        ImGui::SetNextWindowPos(corner);
        ImGui::SetNextWindowSize(size_);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {space, space});
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {px(8.0F), px(PanelPen::line_gap)});
        ImGui::Begin("operator", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav);
        ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + edge, corner.y + size_.y}, look::edge);
        // What can be pressed stays in sight, whatever there is to tell. The scroll bar has the margin.
        const float foot = controlsHeight(pen_, controls_);
        const float told = size_.y - 2.0F * space - foot - px(PanelPen::section_gap);
        ImGui::BeginChild("told", {pen_.width() + 0.5F * space, std::max(1.0F, told)}, false,
                          ImGuiWindowFlags_NoNav);
        participant();
        warnings();
        now();
        device();
        storage();
        stages();
        events();
        ImGui::EndChild();
        ImGui::SetCursorPosY(size_.y - space - foot);
        drawControls(pen_, view_, controls_, now_s);
        ImGui::End();
        ImGui::PopStyleVar(4);
    }

  private:
    const WindowGui& gui_;
    const OperatorView& view_;
    OperatorControls& controls_;
    ImVec2 size_;
    PanelPen pen_;

    [[nodiscard]] float px(float length) const { return pen_.px(length); }

    void participant() const {
        const OperatorFeed& feed = view_.feed;
        const std::string elapsed = elapsedInWords(feed.elapsed_s);
        const float own = PanelPen::widthOf(gui_.large(), feed.participant);
        const float beside = PanelPen::widthOf(gui_.large(), elapsed) + px(12.0F);
        pen_.write(gui_.small(), look::faint, "Participant");
        if (own + beside <= pen_.width()) {
            pen_.right(gui_.small(), look::faint, "Elapsed", PanelPen::widthOf(gui_.small(), "Participant"));
            pen_.write(gui_.large(), look::text, feed.participant);
            pen_.right(gui_.large(), look::text, elapsed, own);
        } else {
            pen_.write(gui_.bold(), look::text, feed.participant);
            pen_.row("Elapsed", gui_.bold(), look::text, elapsed);
        }
        int done = 0;
        int of = 0;
        for (const auto& stage : feed.progress.stages)
            if (stage.of > 0) {
                done += stage.done;
                of += stage.of;
            }
        if (of == 0) return;
        pen_.row("Time left", gui_.bold(), feed.left_s ? look::text : look::faint,
                 timeLeftInWords(feed.left_s));
        pen_.row("Answered", gui_.bold(), look::text, fmt::format("{} of {}", done, of));
        pen_.bar(static_cast<double>(done) / of, 6.0F, look::good);
    }

    void warnings() const {
        const bool full = view_.feed.disk_free_bytes && *view_.feed.disk_free_bytes < little_space_bytes;
        const std::string& failure = view_.feed.failure;
        if (view_.warnings.empty() && !full && failure.empty()) return;
        pen_.section("Please note");
        if (!failure.empty())
            pen_.warning("The session stops, because answers can no longer be saved: " + failure);
        if (full)
            pen_.warning(
                fmt::format("Only {} are free on the disk of the database. Make room before it is full: the "
                            "session ends when nothing more can be saved.",
                            bytesInWords(*view_.feed.disk_free_bytes)));
        for (const std::string& warning : view_.warnings) pen_.warning(warning);
    }

    void now() const {
        pen_.section("Now");
        if (view_.status.part.empty()) {
            pen_.write(gui_.regular(), look::text, "Not begun yet");
            return;
        }
        const studies::SessionStatus& status = view_.status;
        const std::string place =
            status.trials > 0 ? fmt::format("{} of {}", status.trial, status.trials) : "";
        const float left = pen_.width() - PanelPen::widthOf(gui_.bold(), place) - px(13.0F);
        const std::string stage = PanelPen::fitted(gui_.bold(), capitalised(status.part), left);
        pen_.write(gui_.bold(), look::text, stage);
        if (!place.empty()) pen_.right(gui_.bold(), look::text, place, PanelPen::widthOf(gui_.bold(), stage));
        pen_.write(gui_.regular(), view_.paused ? look::warning : look::text,
                   status.remark.empty() ? view_.doing : capitalised(status.remark));
        checks();
        trial();
    }

    void checks() const {
        const auto& progress = view_.feed.progress;
        if (progress.checks_passed + progress.checks_failed == 0) {
            pen_.row("Attention checks", gui_.regular(), look::faint, "none yet");
            return;
        }
        pen_.row("Attention checks", gui_.bold(), progress.checks_failed > 0 ? look::warning : look::text,
                 progress.checks_failed == 0
                     ? fmt::format("{} passed", progress.checks_passed)
                     : fmt::format("{} passed, {} failed", progress.checks_passed, progress.checks_failed));
    }

    // Whoever knows the condition may let the participant feel it: it is shown only on demand.
    void trial() const {
        ImGui::PushFont(gui_.small());
        const bool shown = controls_.trialShown();
        if (ImGui::Button(shown ? "Hide trial" : "Show trial (you will know the condition)"))
            controls_.showTrial(!shown);
        ImGui::PopFont();
        if (!shown) return;
        const std::string& words = view_.feed.progress.trial;
        pen_.write(gui_.regular(), words.empty() ? look::faint : look::text,
                   words.empty() ? "No trial is running." : words);
    }

    void stages() const {
        const auto& stages = view_.feed.progress.stages;
        if (stages.empty()) return;
        pen_.section("Stages");
        const auto count = static_cast<int>(stages.size());
        if (count <= stages_in_sight) {
            for (const auto& stage : stages) stageLine(pen_, stage);
            return;
        }
        // A list of its own, which follows the stage that is under way.
        ImGui::BeginChild("stages",
                          {pen_.width(), (static_cast<float>(stages_in_sight) + 0.5F) * px(stage_height)},
                          false, ImGuiWindowFlags_NoNav);
        const PanelPen narrow(gui_, pen_.width() - ImGui::GetStyle().ScrollbarSize - px(6.0F));
        int& followed = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("followed"), -1);
        for (int i = 0; i < count; ++i) {
            const auto& stage = stages[static_cast<std::size_t>(i)];
            stageLine(narrow, stage);
            if (!stage.current || followed == i) continue;
            ImGui::SetScrollHereY(0.5F);
            followed = i;
        }
        ImGui::EndChild();
    }

    // Name, bar and count.
    void stageLine(const PanelPen& pen, const studies::StageProgress& stage) const {
        const bool page = stage.of == 0;
        const bool done = stage.done >= std::max(1, stage.of);
        ImFont* font = stage.current ? gui_.bold() : gui_.regular();
        const ImU32 colour = done && !stage.current ? look::faint : look::text;
        std::string count = fmt::format("{} / {}", stage.done, stage.of);
        if (page) count = done ? "read" : "page";
        const float counts = std::max(PanelPen::widthOf(font, count), pen.px(66.0F));
        const float bar = pen.width() - counts - pen.px(stage_bar);
        const float room = page ? pen.width() - PanelPen::widthOf(font, count) : bar;
        const std::string name = PanelPen::fitted(font, stage.name, room - pen.px(10.0F));
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float top = ImGui::GetCursorPosY();
        PanelPen::line(font, colour, name);
        if (name != stage.name && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", stage.name.c_str());
        if (!page)
            pen.barAt({at.x + bar, at.y + 0.5F * (font->FontSize - pen.px(4.0F)) + pen.px(1.0F)},
                      pen.px(stage_bar), static_cast<double>(stage.done) / stage.of, 5.0F,
                      stage.current ? look::good : look::button_hovered);
        ImGui::SameLine(pen.width() - PanelPen::widthOf(font, count));
        PanelPen::line(font, page ? look::faint : colour, count);
        ImGui::SetCursorPosY(top + pen.px(stage_height));
    }

    void device() const {
        pen_.section(view_.device_kind);
        pen_.write(gui_.regular(), look::text, view_.device);
        const bool in_use = view_.device_state.in_use;
        pen_.light(in_use, in_use ? look::good : look::warning);
        pen_.write(gui_.regular(), in_use ? look::text : look::warning, view_.device_state.words);
        pen_.row("Frames", gui_.bold(), look::text,
                 fmt::format("{:.0f} per second, {} dropped", view_.frames_per_s, view_.dropped_frames));
        if (view_.has_place) distance();
        if (view_.tracked.empty()) {
            pen_.row("Pointer", gui_.bold(), look::text, view_.pointer);
            return;
        }
        pen_.write(gui_.regular(), look::faint, "Tracked");
        pen_.right(gui_.regular(), look::ray, view_.pointer, PanelPen::widthOf(gui_.regular(), "Tracked"));
        float place = 0.0F;
        for (const TrackedDevice& one : view_.tracked) {
            if (place > 0.0F) ImGui::SameLine(place * pen_.width());
            pen_.light(one.tracked, one.tracked ? look::good : look::warning);
            PanelPen::line(gui_.regular(), one.tracked ? look::text : look::warning, one.name);
            place += 0.35F;
        }
    }

    void distance() const {
        if (!view_.off_place_m) {
            pen_.row("From the place", gui_.bold(), look::faint, "not known");
            return;
        }
        const bool off = *view_.off_place_m > view_.place_tolerance_m;
        pen_.row("From the place", gui_.bold(), off ? look::warning : look::text,
                 distanceInWords(*view_.off_place_m));
        if (off)
            pen_.write(gui_.small(), look::warning,
                       fmt::format("Farther than {}: the participant is asked to step back.",
                                   distanceInWords(view_.place_tolerance_m)));
    }

    void storage() const {
        const OperatorFeed& feed = view_.feed;
        const bool waits = feed.waiting_s > usual_wait_s;
        const bool failed = !feed.failure.empty();
        pen_.row("Answers", gui_.bold(), waits || failed ? look::warning : look::text,
                 failed  ? "no longer saved"
                 : waits ? fmt::format("waiting for the disk, {:.0f} s", feed.waiting_s)
                         : "on the disk");
        const bool known = feed.disk_free_bytes.has_value();
        const bool little = known && *feed.disk_free_bytes < little_space_bytes;
        pen_.row("Free on the disk", gui_.bold(),
                 !known   ? look::faint
                 : little ? look::warning
                          : look::text,
                 known ? bytesInWords(*feed.disk_free_bytes) : "not known");
    }

    void events() const {
        const auto& events = view_.feed.events;
        if (events.empty()) return;
        pen_.section("Latest");
        std::size_t told = 0;
        for (auto event = events.rbegin(); event != events.rend() && told < events_in_sight;
             ++event, ++told) {
            const std::string time = elapsedInWords(event->elapsed_s);
            PanelPen::line(gui_.small(), look::faint, time);
            ImGui::SameLine(std::max(px(52.0F), PanelPen::widthOf(gui_.small(), time) + px(8.0F)));
            pen_.write(gui_.small(), look::text, eventInWords(*event));
        }
    }
};

}  // namespace

void drawOperatorPanel(const WindowGui& gui, ImVec2 corner, ImVec2 size, const OperatorView& view,
                       OperatorControls& controls, double now_s) {
    Panel(gui, view, controls, size).draw(corner, now_s);
}

}  // namespace deixis::app
