// Pages and signs, where boards stand, and what a ray meets on them.
#include <cmath>
#include <glm/geometric.hpp>

#include "panel_fixture.hpp"
#include "studies/session/session.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

Vec3 centreOf(const Panel& panel) {
    return transformPoint(panel.stage_from_panel, {panel.width_m / 2.0, panel.height_m / 2.0, 0.0});
}

Vec3 centreOf(const Panel& panel, const PanelRect& box) {
    return transformPoint(panel.stage_from_panel, {box.x + box.width / 2.0, box.y + box.height / 2.0, 0.0});
}

Ray towards(const Vec3& eye, const Vec3& point) {
    return {eye, glm::normalize(point - eye)};
}

bool hides(const Panel& panel, const Vec3& eye, const Vec3& point) {
    const auto hit = meetPanel(panel, towards(eye, point));
    return hit && hit->distance_m < glm::length(point - eye);
}

/// A viewer 3.4 m before the avatar, looking at it.
const Pose across{{0.0, 0.0, 3.4}, yawRotation(0.0)};

Panel ratingBoard() {
    RatingBoard board{"How natural is this?", {ScaleKind::slider, 0, 100, {"bad", "good"}}};
    board.confirm = ButtonSpec{"Confirm", button_id::go_on};
    board.replay = ButtonSpec{"Show again", button_id::replay};
    return ratingPanel(board);
}

Panel parallelBoard(std::size_t count) {
    ParallelBoard board{"Rate each.",
                        {ScaleKind::slider, 0, 100, {"bad", "poor", "fair", "good", "excellent"}}};
    board.stimuli.resize(count);
    return parallelPanel(board, LanguageTable::english());
}

}  // namespace

TEST_SUITE("studies/panel_layout") {
    TEST_CASE("pages and signs stay tidy with short and long texts in all four languages") {
        for (const std::string& code : languageCodes()) {
            const LanguageTable words = languageTable(code);
            RandomTexts texts(words, 5);
            for (int round = 0; round < 200; ++round) {
                CAPTURE(code);
                CAPTURE(round);
                std::vector<ButtonSpec> buttons{{texts(1, 3), 1}};
                for (int i = texts.between(0, 2); i > 0; --i) buttons.push_back({texts(1, 4), 1 + i});
                const Panel page =
                    messagePanel(texts(1, 5), texts(1, texts.flip() ? 20 : 150),
                                 texts.flip() ? texts(1, 15) : "", buttons, texts.flip() ? 0.5 : -1.0);
                checkTidy(page, 0.13);
                CHECK(page.buttons.size() == buttons.size());
                checkTidy(signPanel(texts(1, 6), texts.flip() ? "4" : ""), 0.0);
            }
        }
    }

    TEST_CASE("a page has its title on top, then text, emphasis and buttons, with a bar below them") {
        const Panel page = messagePanel("Title", "Body", "Emphasis",
                                        {{"I agree", button_id::agree, ButtonRole::go_on, false},
                                         {"I do not agree", button_id::decline, ButtonRole::leave}},
                                        0.25);
        REQUIRE(page.texts.size() == 3);
        CHECK(page.texts[0].text == "Title");
        CHECK(page.texts[0].box.y > page.texts[1].box.y);
        CHECK(page.texts[1].box.y > page.texts[2].box.y);
        REQUIRE(page.buttons.size() == 2);
        CHECK(page.buttons[0].box.y + page.buttons[0].box.height < page.texts[2].box.y);
        CHECK(page.buttons[0].box.x < page.buttons[1].box.x);
        CHECK_FALSE(page.buttons[0].enabled);
        CHECK(page.buttons[1].role == ButtonRole::leave);
        CHECK(page.progress == 0.25);
        CHECK(page.height_m > messagePanel("Title", "Body", "Emphasis", {{"a", 1}}, -1.0).height_m);
    }

    TEST_CASE("consent forms of a thousand characters stay within the board's height in all four languages") {
        for (const std::string& code : languageCodes()) {
            CAPTURE(code);
            const LanguageTable words = languageTable(code);
            const std::string& sentence = words("paused_tracking_text");
            std::string body;
            while (textWidth(body, 1.0) < 450.0) body += sentence + " ";
            const Panel page = messagePanel(words("consent_title"), body, "",
                                            {{words("agree"), 7}, {words("decline"), 8}}, 0.1);
            CHECK(page.height_m <= 1.1);
            checkTidy(page, 0.13);
        }
    }

    TEST_CASE("a line at the foot of a page is laid out with the page, under its buttons, in any language") {
        for (const std::string& code : languageCodes()) {
            CAPTURE(code);
            const LanguageTable words = languageTable(code);
            for (const char* key : {"station_desktop_controls", "station_headset_hint"}) {
                const Panel page = messagePanel(words("paused_title"), words("paused_text"), "",
                                                {{words("resume"), 1}}, 0.5, words(key));
                checkTidy(page, 0.13);
                const PanelText& foot = page.texts.back();
                // Where a line ends, spaces are left out.
                const auto letters = [](std::string text) {
                    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
                    return text;
                };
                CHECK(letters(unwrapped(foot.text)) == letters(words(key)));
                CHECK(foot.faint);
                CHECK(foot.box.y + foot.box.height < page.buttons[0].box.y);
            }
        }
    }

    TEST_CASE(
        "every enabled button, slider and field is met by a ray through its centre, and nothing disabled") {
        const LanguageTable& words = LanguageTable::english();
        Question number;
        number.kind = QuestionKind::number;
        Question text;
        text.kind = QuestionKind::text;
        Question scale;
        QuestionnaireBoard questions;
        questions.questions = {&number, &text, &scale};
        questions.buttons = {{"Continue", 1, ButtonRole::go_on, false}};
        PairwiseBoard pair{"Which?"};
        pair.can_answer = true;
        using Stand = Pose (*)(const Panel&, const Pose&, double);
        for (const Stand stand : {Stand(messagePose), Stand(lecternPose), Stand(deskPose)})
            for (Panel panel :
                 {ratingBoard(), parallelBoard(2), parallelBoard(6), pairwisePanel(pair, words),
                  gamePanel("Where?", ButtonSpec{"Show again", 4}), questionnairePanel(questions, words),
                  messagePanel("a", "b", "c", {{"d", 1}, {"e", 2, ButtonRole::other, false}}, 0.5)}) {
                panel.stage_from_panel = stand(panel, across, 1.62);
                const Vec3 eye(0.1, 1.6, 3.5);
                const auto met = [&](const PanelRect& box) {
                    const auto hit = meetPanel(panel, towards(eye, centreOf(panel, box)));
                    REQUIRE(hit.has_value());
                    return *hit;
                };
                for (std::size_t i = 0; i < panel.buttons.size(); ++i)
                    CHECK(met(panel.buttons[i].box).button ==
                          (panel.buttons[i].enabled ? static_cast<int>(i) : -1));
                for (std::size_t i = 0; i < panel.sliders.size(); ++i) {
                    const PanelHit hit = met(panel.sliders[i].box);
                    CHECK(hit.slider == static_cast<int>(i));
                    CHECK(hit.button == -1);
                    const PanelRect& box = panel.sliders[i].box;
                    CHECK(hit.x_m == doctest::Approx(box.x + box.width / 2.0));
                }
                for (std::size_t i = 0; i < panel.fields.size(); ++i)
                    CHECK(met(panel.fields[i].box).field == static_cast<int>(i));
                for (PanelSlider& slider : panel.sliders) slider.enabled = false;
                for (PanelField& field : panel.fields) field.enabled = false;
                for (const PanelSlider& slider : panel.sliders) CHECK(met(slider.box).slider == -1);
                for (const PanelField& field : panel.fields) CHECK(met(field.box).field == -1);
                CHECK_FALSE(meetPanel(panel, towards(eye, eye + Vec3(0.0, 1.0, 0.2))).has_value());
            }
    }

    TEST_CASE(
        "each value of a slider is what is read back at its place, and the ends hold beyond the track") {
        for (const auto& [low, high] : {std::pair{0, 100}, {1, 7}, {-50, 50}, {0, 1}}) {
            PanelSlider slider;
            slider.box = {0.07, 0.1, 1.4, 0.16};
            slider.low = low;
            slider.high = high;
            const PanelRect track = slider.track();
            for (int value = low; value <= high; ++value) {
                const double x = track.x + track.width * (value - low) / (high - low);
                CHECK(slider.valueAt(x) == value);
                if (value < high) CHECK(slider.valueAt(x + 0.49 * track.width / (high - low)) == value);
            }
            CHECK(slider.valueAt(-3.0) == low);
            CHECK(slider.valueAt(3.0) == high);
        }
    }

    TEST_CASE("a dragged ray keeps its place along the board when it has left the board") {
        Panel panel = ratingBoard();
        panel.stage_from_panel = lecternPose(panel, across, 1.62);
        const Vec3 eye(0.0, 1.6, 3.4);
        for (const double x : {-0.5, 0.0, 0.7, 1.55, 2.2}) {
            const Vec3 above = transformPoint(panel.stage_from_panel, {x, panel.height_m + 0.3, 0.0});
            CHECK_FALSE(meetPanel(panel, towards(eye, above)).has_value());
            const auto along = alongPanel(panel, towards(eye, above));
            REQUIRE(along.has_value());
            CHECK(*along == doctest::Approx(x));
        }
        CHECK_FALSE(alongPanel(panel, towards(eye, eye + Vec3(0.0, 1.0, 1.0))).has_value());
    }

    TEST_CASE(
        "boards that are open while clips play leave the avatar free from the hips up and face the eyes") {
        // Hips, hands before the chest, head of a person of 1.75 m who stands at the origin.
        const std::vector<Vec3> body{{0.0, 1.0, 0.1}, {0.3, 1.1, 0.4}, {-0.3, 1.1, 0.4}, {0.0, 1.65, 0.1}};
        for (const double eye_m : {1.5, 1.62, 1.8})
            for (Panel panel : {ratingBoard(), parallelBoard(3), parallelBoard(6),
                                pairwisePanel({"Which?"}, LanguageTable::english())}) {
                CAPTURE(eye_m);
                CAPTURE(panel.height_m);
                panel.stage_from_panel = benchPose(panel, across, eye_m);
                const Vec3 eye = across.position + Vec3(0.0, eye_m, 0.0);
                for (const Vec3& point : body) CHECK_FALSE(hides(panel, eye, point));
                const Vec3 facing = panel.stage_from_panel.orientation * Vec3(0.0, 0.0, 1.0);
                CHECK(glm::dot(facing, glm::normalize(eye - centreOf(panel))) > 0.97);
                CHECK(glm::length(eye - centreOf(panel)) < 2.3);
            }
    }

    TEST_CASE(
        "boards of the game turn aside from balls before and behind them, and no farther than they must") {
        const Panel asks = gamePanel("Which ball did the avatar point at?", ButtonSpec{"Show again", 4});
        const Panel sure =
            ratingPanel({"How sure are you?", {ScaleKind::steps, 1, 5, {"not at all", "fully"}}});
        const Pose beside{{-0.6, 0.0, -0.95}, yawRotation(radiansFromDegrees(195.0))};
        Random random(3);
        int turned = 0;
        int far_aside = 0;
        for (const Pose& viewer : {across, beside})
            for (int round = 0; round < 300; ++round) {
                CAPTURE(round);
                // A target and two distractors 20 to 40 cm from it, as in the shipped study.
                std::vector<BallView> balls(3);
                const double arc = random.uniform(radiansFromDegrees(-85.0), radiansFromDegrees(85.0));
                const double radius_m = random.uniform(1.9, 2.2);
                for (BallView& ball : balls) {
                    ball.radius_m = 0.05;
                    const Vec3 off(random.normal(), random.normal(), random.normal());
                    const double away_m = &ball == balls.data() ? 0.0 : random.uniform(0.2, 0.4);
                    ball.centre =
                        Vec3(radius_m * std::sin(arc), random.uniform(0.3, 1.9), radius_m * std::cos(arc));
                    if (&ball != balls.data()) ball.centre = balls[0].centre + away_m * glm::normalize(off);
                }
                const Vec3 eye = viewer.position + Vec3(0.0, 1.62, 0.0);
                const auto overlapped = [&](const Panel& panel) {
                    return std::any_of(balls.begin(), balls.end(), [&](const BallView& ball) {
                        const Vec3 side = ball.radius_m * glm::normalize(glm::cross(ball.centre - eye, up));
                        for (const Vec3& point : {ball.centre, ball.centre + side, ball.centre - side})
                            if (meetPanel(panel, towards(eye, point))) return true;
                        return false;
                    });
                };
                Panel panel = asks;
                panel.stage_from_panel = deskPose(panel, viewer, 1.62);
                const bool would = overlapped(panel);
                const Vec3 without = centreOf(panel);
                panel.stage_from_panel = deskPoseBesideBalls(panel, viewer, 1.62, balls);
                CHECK_FALSE(overlapped(panel));
                const bool moved = glm::length(centreOf(panel) - without) > 1e-9;
                CHECK_MESSAGE((moved || !would), "it overlaps a ball and stays");
                if (moved) ++turned;
                panel = sure;
                const auto place = poseBesideBalls(panel, viewer, 1.62, balls);
                REQUIRE(place.has_value());
                panel.stage_from_panel = *place;
                CHECK_FALSE(overlapped(panel));
                const Vec3 centre = centreOf(panel);
                CHECK_MESSAGE(std::hypot(centre.x, centre.z) > 0.4, "it stands in the avatar");
                const auto bearing = [&](const Pose& pose) {
                    panel.stage_from_panel = pose;
                    const Vec3 seen = transformPoint(inverse(viewer), centreOf(panel));
                    return std::atan2(seen.x, -seen.z);
                };
                const double moved_rad =
                    std::abs(bearing(*place) - bearing(lecternPose(panel, viewer, 1.62)));
                if (moved_rad > radiansFromDegrees(30.0)) ++far_aside;
            }
        CHECK_MESSAGE(far_aside < 150, far_aside);
        CHECK(turned > 5);
        CHECK(turned < 300);
        Panel panel = asks;
        panel.stage_from_panel = deskPose(panel, across, 1.62);
        CHECK(deskPoseBesideBalls(panel, across, 1.62, {}).position == panel.stage_from_panel.position);
        CHECK(poseBesideBalls(panel, across, 1.62, {})->position ==
              lecternPose(panel, across, 1.62).position);
    }

    TEST_CASE("no board reaches into the floor before a seated person") {
        for (Panel panel : {ratingBoard(), parallelBoard(6),
                            messagePanel("a", std::string(3000, 'x'), "", {{"b", 1}}, 0.5)})
            for (const auto stand : {&messagePose, &lecternPose, &benchPose, &deskPose}) {
                panel.stage_from_panel = stand(panel, across, 1.1);
                CHECK(panel.stage_from_panel.position.y > 0.1);
            }
    }

    TEST_CASE("a sign stands above the avatar's head and is read squarely from wherever the viewer stands") {
        Panel sign = signPanel("Please rate this movement:", "4");
        const Vec3 head(0.0, 1.6, 0.0);
        for (const double bearing : {0.0, 1.0, 2.0, 3.1, -2.0, -0.7})
            for (const double eye_m : {1.2, 1.6, 1.9}) {
                const Vec3 eye(2.0 * std::sin(bearing), eye_m, 2.0 * std::cos(bearing));
                sign.stage_from_panel = signPose(sign, head, eye);
                const Vec3 centre = centreOf(sign);
                CHECK(glm::length(Vec3(centre.x, 0.0, centre.z)) < 1e-9);
                const Vec3 facing = sign.stage_from_panel.orientation * Vec3(0.0, 0.0, 1.0);
                CHECK(glm::dot(facing, glm::normalize(eye - centre)) > 1.0 - 1e-9);
                // Upright: its right hand side is level.
                const Vec3 right = sign.stage_from_panel.orientation * Vec3(1.0, 0.0, 0.0);
                CHECK(std::abs(right.y) < 1e-12);
                CHECK(glm::dot(sign.stage_from_panel.orientation * Vec3(0.0, 1.0, 0.0), up) > 0.7);
                for (const double x : {0.0, sign.width_m}) {
                    const Vec3 corner = transformPoint(sign.stage_from_panel, {x, 0.0, 0.0});
                    CHECK(corner.y > head.y + 0.2);
                }
                CHECK_FALSE(hides(sign, eye, head));
            }
    }
}
