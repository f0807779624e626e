// The lines that are drawn are the lines that were laid out: boards of all shipped studies, in their
// languages, with the fonts themselves.
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "../studies/panel_fixture.hpp"
#include "../studies/session_study.hpp"
#include "app/clips/study_setup.hpp"
#include "app/window/frame_scene.hpp"
#include "board_layout.hpp"
#include "board_painter.hpp"
#include "paths.hpp"
#include "studies/simulation/simulated_participant.hpp"
#include "studies/station/notice.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

renderer::BoardFonts loadFonts() {
    auto fonts = renderer::BoardFonts::load();
    REQUIRE_MESSAGE(fonts.has_value(), (fonts ? std::string() : fonts.error().text()));
    return std::move(*fonts);
}

std::string allWords(const std::string& code) {
    std::string all;
    const LanguageTable words = languageTable(code);
    for (const auto& [key, english] : languageKeys()) all += words(key);
    return all;
}

/// As the renderer draws it.
double pixelsPerMetre(const renderer::Board& board) {
    return std::min(1400.0, 2040.0 / std::max(board.width_m, board.height_m));
}

/// Its lines as they were laid out, each in its box, none made smaller.
void checkDrawn(const renderer::PlacedText& placed, const renderer::FittedText& fitted) {
    CAPTURE(*placed.text);
    CHECK(fitted.key.pixels == placed.key.pixels);
    const auto lines = std::count(placed.text->begin(), placed.text->end(), '\n') + 1;
    CHECK(static_cast<long>(fitted.lines.size()) == static_cast<long>(lines));
    int outside = 0;
    for (std::size_t i = 0; i < fitted.lines.size(); ++i)
        if (fitted.left[i] < placed.low.x - 1.0F ||
            fitted.left[i] + fitted.lines[i].width > placed.high.x + 1.5F)
            ++outside;
    CHECK(outside == 0);
    CHECK(fitted.top >= placed.low.y - 1.0F);
    CHECK(fitted.top + fitted.height() <= placed.high.y + 1.5F);
}

void checkDrawn(const Panel& panel, renderer::BoardFonts& fonts) {
    PresentedFrame frame;
    frame.panel = panel;
    const renderer::Board board = app::sceneFromFrame(frame, {}).boards.at(0);
    const double scale = pixelsPerMetre(board);
    (void)renderer::requireBoardFonts(board, scale, fonts);
    const renderer::BoardLayout layout(board, scale, fonts);
    for (const renderer::BoardText& text : board.texts)
        checkDrawn(layout.text(text), layout.fittedText(text));
    for (const renderer::BoardSlider& slider : board.sliders)
        for (std::size_t i = 0; i < slider.labels.size(); ++i)
            checkDrawn(layout.label(slider, i), layout.fittedLabel(slider, i));
    for (const renderer::BoardButton& button : board.buttons) {
        const renderer::PlacedText placed = layout.label(button);
        const renderer::FittedText label = layout.fittedLabel(button);
        CAPTURE(button.label);
        CHECK(label.lines.size() <= 1);
        for (const renderer::TextLine& line : label.lines)
            CHECK(line.width <= placed.high.x - placed.low.x + 1.5F);
        CHECK(label.key.pixels >= static_cast<int>(0.69 * placed.key.pixels));
    }
}

/// Still for a moment: what the participant sees of the avatar does not matter here.
class ShortClip : public ClipSource {
  public:
    [[nodiscard]] const motion::Clip& clip(const Stimulus& /*stimulus*/) const override { return clip_; }
    [[nodiscard]] const std::string* project(const Stimulus& /*stimulus*/) const override {
        return &project_;
    }

  private:
    motion::Clip clip_ = handClip(0.2);
    std::string project_ = "{}";
};

/// Every board of one participant's first session that is not like another one.
std::vector<Panel> boardsOf(const app::StudySetup& setup) {
    const auto plan = buildPlan(setup.study, setup.targets, "P01", 1, assignGroups(setup.study, {}, 1));
    REQUIRE_MESSAGE(plan.has_value(), (plan ? std::string() : plan.error().text()));
    const motion::Skeleton& avatar = motion::referenceHumanoid();
    const motion::LocalPose idle = motion::relaxedPose(avatar);
    const ShortClip clips;
    SimulatedParameters parameters;
    parameters.reaction_mean_s = 0.1;
    parameters.reaction_sd_s = 0.01;
    SimulatedStation station(parameters, avatar, 1);
    SessionRunner session(setup.study, *plan, clips, avatar, idle, {}, true,
                          setup.study.words("station_desktop_controls"));
    std::vector<Panel> boards;
    std::set<std::string> known;
    for (int i = 0; i < 200000 && session.outcome() == SessionOutcome::running; ++i) {
        const SessionStep step = session.step(station.beginFrame());
        for (const auto& panel : {step.frame.panel, step.frame.sign}) {
            if (!panel) continue;
            std::string content;
            for (const PanelText& text : panel->texts) content += text.text + "|";
            for (const PanelButton& button : panel->buttons)
                content += button.label + "," + button.caption + "|";
            if (known.insert(content).second) boards.push_back(*panel);
        }
        (void)session.shown(station.present(step.frame));
    }
    CHECK_MESSAGE(!station.failure(), (station.failure() ? station.failure()->text() : std::string()));
    CHECK(session.outcome() == SessionOutcome::finished);
    return boards;
}

}  // namespace

TEST_SUITE("immersive/board_text") {
    TEST_CASE("each character is drawn as wide as the layout takes it to be") {
        renderer::BoardFonts fonts = loadFonts();
        std::string all = "ÀßþÿŁőŻżĞşΑΩαωЯяіїё–—‘’“”•…‰€™−≈漢字ㄱㅎ";
        for (char c = ' '; c <= '~'; ++c) all += c;
        for (const std::string& code : languageCodes()) all += allWords(code);
        const int pixels = 100;
        (void)fonts.require({{false, pixels}, {true, pixels}}, all);
        for (const bool bold : {false, true}) {
            const ImFont& font = *fonts.font({bold, pixels});
            int wrong = 0;
            for (const char* at = all.data(); at < all.data() + all.size();) {
                const char* end = renderer::afterCharacter(at, all.data() + all.size());
                const double drawn = renderer::textWidth(font, pixels, at, end);
                if (*at != '\n' && std::abs(drawn - textWidth(std::string(at, end), pixels, bold)) > 0.01)
                    ++wrong;
                at = end;
            }
            CHECK(wrong == 0);
        }
    }

    TEST_CASE(
        "every board of every shipped study, in each language: nothing overlaps, leaves its board or wraps "
        "again") {
        for (const std::string& code : languageCodes()) {
            renderer::BoardFonts fonts = loadFonts();
            (void)fonts.require({}, allWords(code));
            std::size_t boards = 0;
            for (const auto& file :
                 std::filesystem::directory_iterator(deixis::tests::sourceDir() / "assets/data/studies")) {
                CAPTURE(code);
                CAPTURE(file.path().stem().string());
                const auto setup = app::loadStudySetup(file.path().string(), code);
                REQUIRE_MESSAGE(setup.has_value(), (setup ? std::string() : setup.error().text()));
                for (const Panel& panel : boardsOf(*setup)) {
                    ++boards;
                    checkTidy(panel, 0.065);
                    checkDrawn(panel, fonts);
                }
            }
            CHECK(boards > 40);
        }
    }

    TEST_CASE("parallel ratings of two to six movements, and notices, are drawn as laid out") {
        for (const std::string& code : languageCodes()) {
            CAPTURE(code);
            const LanguageTable words = languageTable(code);
            renderer::BoardFonts fonts = loadFonts();
            (void)fonts.require({}, allWords(code));
            RandomTexts texts(words, 21);
            for (std::size_t count = 2; count <= 6; ++count)
                for (const int labels : {2, 3, 5}) {
                    Scale scale{ScaleKind::slider, 0, 100, {}};
                    for (int i = 0; i < labels; ++i) scale.labels.push_back(texts(1, 2));
                    ParallelBoard content{texts(4, 9), scale};
                    content.stimuli.resize(count);
                    content.hint = words("rate_all");
                    const Panel panel = parallelPanel(content, words);
                    checkTidy(panel, 0.1);
                    checkDrawn(panel, fonts);
                }
            for (const char* key :
                 {"notice_saving", "notice_place", "feedback_wrong", "station_tracking_lost"})
                for (const double line_m : {0.023, 0.046}) checkDrawn(noticePanel(words(key), line_m), fonts);
        }
    }
}
