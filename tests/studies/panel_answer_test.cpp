// Boards on which participants rate, compare and play.
#include "panel_fixture.hpp"
#include "studies/session/session.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

Scale steps(int low, int high, std::vector<std::string> labels = {}) {
    return {ScaleKind::steps, low, high, std::move(labels)};
}

Scale slider(int low, int high, std::vector<std::string> labels = {}) {
    return {ScaleKind::slider, low, high, std::move(labels)};
}

/// A scale with labels of up to three words: for each step, for the ends, or none.
Scale someScale(RandomTexts& texts) {
    Scale scale;
    scale.kind = texts.flip() ? ScaleKind::steps : ScaleKind::slider;
    const bool is_slider = scale.kind == ScaleKind::slider;
    scale.low = texts.between(-3, 1);
    scale.high = scale.low + (is_slider ? 100 : texts.between(1, 10));
    const int labels = is_slider ? texts.between(2, 6) : texts.flip() ? scale.steps() : 2;
    if (texts.between(0, 3) > 0)
        for (int i = 0; i < labels; ++i) scale.labels.push_back(texts(1, 3));
    return scale;
}

std::vector<int> counting(int first, int count) {
    std::vector<int> ids;
    for (int i = 0; i < count; ++i) ids.push_back(first + i);
    return ids;
}

}  // namespace

TEST_SUITE("studies/panel_answer") {
    TEST_CASE("boards of answers stay tidy with any scale and any texts in all four languages") {
        for (const std::string& code : languageCodes()) {
            const LanguageTable words = languageTable(code);
            RandomTexts texts(words, 11);
            for (int round = 0; round < 250; ++round) {
                CAPTURE(code);
                CAPTURE(round);
                RatingBoard rating{texts(1, 25), someScale(texts)};
                if (texts.flip()) rating.replay = ButtonSpec{words("show_again"), button_id::replay};
                if (rating.scale.kind == ScaleKind::slider)
                    rating.confirm = ButtonSpec{words("confirm"), button_id::go_on};
                checkTidy(ratingPanel(rating), 0.1);

                ParallelBoard parallel{texts(1, 25), someScale(texts)};
                parallel.stimuli.resize(static_cast<std::size_t>(texts.between(2, 6)));
                for (StimulusView& stimulus : parallel.stimuli)
                    stimulus.state = static_cast<PlayState>(texts.between(0, 2));
                if (texts.flip()) parallel.hint = texts(1, 12);
                checkTidy(parallelPanel(parallel, words), 0.065);

                PairwiseBoard pair{texts(1, 25)};
                if (texts.flip()) pair.hint = words("play_both");
                checkTidy(pairwisePanel(pair, words), 0.13);

                checkTidy(
                    gamePanel(texts(1, 25), texts.flip() ? std::optional(ButtonSpec{words("show_again"), 4})
                                                         : std::nullopt),
                    0.13);
            }
        }
    }

    TEST_CASE("a rating has a button for each step, lowest first, with the step's number and label") {
        const Panel panel =
            ratingPanel({"How natural?", steps(-2, 2, {"bad", "poor", "fair", "good", "excellent"}), 1, true,
                         ButtonSpec{"Show again", button_id::replay, ButtonRole::play}});
        CHECK(idsOf(panel, ButtonRole::option) == counting(button_id::first_rating, 5));
        CHECK(idsOf(panel, ButtonRole::play) == std::vector<int>{button_id::replay});
        double before = 0.0;
        for (int i = 0; i < 5; ++i) {
            const PanelButton* button = findButton(panel, button_id::first_rating + i);
            REQUIRE(button != nullptr);
            CHECK(button->label == std::to_string(i - 2));
            CHECK(button->chosen == (i == 3));
            CHECK(button->box.x > before);
            before = button->box.x + button->box.width;
        }
        CHECK(findButton(panel, button_id::first_rating + 1)->caption == "poor");
    }

    TEST_CASE("labels of steps stand in their buttons where they fit, else under them") {
        const Panel wordy =
            ratingPanel({"?", steps(1, 3, {"a label that is far too long for one line", "middle", "high"})});
        REQUIRE(wordy.texts.size() == 4);
        for (int i = 0; i < 3; ++i) {
            const PanelButton* button = findButton(wordy, button_id::first_rating + i);
            REQUIRE(button != nullptr);
            CHECK(button->caption.empty());
            const PanelText& label = wordy.texts[1 + static_cast<std::size_t>(i)];
            CHECK(label.box.y + label.box.height < button->box.y);
            CHECK(std::abs(label.box.x + label.box.width / 2.0 - button->box.x - button->box.width / 2.0) <
                  1e-9);
        }
        const Panel ends = ratingPanel({"?", steps(0, 10, {"not at all", "completely"})});
        REQUIRE(ends.texts.size() == 3);
        CHECK(ends.texts[1].text == "not at all");
        CHECK(ends.texts[1].box.x < findButton(ends, button_id::first_rating)->box.x + 0.01);
        const PanelButton* last = findButton(ends, button_id::first_rating + 10);
        CHECK(std::abs(ends.texts[2].box.x + ends.texts[2].box.width - last->box.x - last->box.width) < 1e-9);
        CHECK(ratingPanel({"?", steps(0, 10)}).texts.size() == 1);
    }

    TEST_CASE("up to eleven steps stand in one row, more in rows of about the same length") {
        const auto rowsOf = [](int high) {
            std::vector<double> rows;
            for (const PanelButton& button : ratingPanel({"?", steps(1, high)}).buttons)
                if (rows.empty() || std::abs(rows.back() - button.box.y) > 1e-9) rows.push_back(button.box.y);
            return rows.size();
        };
        CHECK(rowsOf(2) == 1);
        CHECK(rowsOf(11) == 1);
        CHECK(rowsOf(12) == 2);
        CHECK(rowsOf(22) == 2);
        CHECK(rowsOf(23) == 3);
        const Panel panel = ratingPanel({"?", steps(0, 20, {"low", "high"})});
        checkTidy(panel, 0.1);
        CHECK(idsOf(panel, ButtonRole::option) == counting(button_id::first_rating, 21));
        CHECK(panel.texts[1].text == "0: low");
        CHECK(panel.texts[2].text == "20: high");
    }

    TEST_CASE("a slider has its bounds, its value and its labels, and waits for a confirmation") {
        RatingBoard board{"How natural?", slider(0, 100, {"not at all", "completely"})};
        board.confirm = ButtonSpec{"Confirm", button_id::go_on, ButtonRole::go_on, false};
        const Panel untouched = ratingPanel(board);
        REQUIRE(untouched.sliders.size() == 1);
        CHECK(untouched.sliders[0].id == button_id::first_slider);
        CHECK(untouched.sliders[0].low == 0);
        CHECK(untouched.sliders[0].high == 100);
        CHECK_FALSE(untouched.sliders[0].value.has_value());
        CHECK(untouched.sliders[0].labels == board.scale.labels);
        REQUIRE(findButton(untouched, button_id::go_on) != nullptr);
        CHECK_FALSE(findButton(untouched, button_id::go_on)->enabled);
        board.value = 40;
        board.enabled = false;
        const Panel closed = ratingPanel(board);
        CHECK(closed.sliders[0].value == 40);
        CHECK_FALSE(closed.sliders[0].enabled);
    }

    TEST_CASE(
        "parallel ratings: each stimulus has its play button and its scale in one row, in reading order") {
        const LanguageTable& words = LanguageTable::english();
        for (const Scale& scale : {slider(0, 100, {"bad", "poor", "fair", "good", "excellent"}),
                                   slider(0, 10), steps(1, 5), steps(1, 9, {"low", "high"})})
            for (int count = 2; count <= 6; ++count) {
                CAPTURE(count);
                CAPTURE(scale.high);
                ParallelBoard board{"Rate each.", scale};
                board.stimuli.resize(static_cast<std::size_t>(count));
                board.stimuli[0].state = PlayState::playing;
                board.stimuli[1] = {PlayState::played, false, false, scale.low + 1};
                const Panel panel = parallelPanel(board, words);
                checkTidy(panel, 0.065);
                CHECK(panel.height_m <= 1.1);
                CHECK(idsOf(panel, ButtonRole::play).size() == static_cast<std::size_t>(count));
                for (int i = 0; i < count; ++i) {
                    const PanelButton* play = findButton(panel, button_id::first_play + i);
                    REQUIRE(play != nullptr);
                    CHECK(play->label.front() == static_cast<char>('A' + i));
                    CHECK(play->chosen == (i == 0));
                    CHECK(play->enabled == (i != 1));
                    const std::string all = play->label + " " + play->caption;
                    CHECK((all.find(i == 0   ? words("playing")
                                    : i == 1 ? words("play_again")
                                             : words("play")) != std::string::npos));
                    PanelRect answer;
                    if (scale.kind == ScaleKind::slider) {
                        const PanelSlider& one = panel.sliders[static_cast<std::size_t>(
                            std::find_if(
                                panel.sliders.begin(), panel.sliders.end(),
                                [&](const PanelSlider& s) { return s.id == button_id::first_slider + i; }) -
                            panel.sliders.begin())];
                        answer = one.box;
                        CHECK(one.enabled == (i != 1));
                        CHECK(one.value.has_value() == (i == 1));
                    } else {
                        const int first = button_id::first_option + 100 * i;
                        REQUIRE(findButton(panel, first + scale.steps() - 1) != nullptr);
                        answer = findButton(panel, first)->box;
                        CHECK(findButton(panel, first + 1)->chosen == (i == 1));
                        CHECK(findButton(panel, first)->enabled == (i != 1));
                    }
                    CHECK(answer.x > play->box.x + play->box.width);
                    const double middle = answer.y + answer.height / 2.0;
                    CHECK(middle > play->box.y);
                    CHECK(middle < play->box.y + play->box.height);
                }
                REQUIRE(findButton(panel, button_id::go_on) != nullptr);
                CHECK_FALSE(findButton(panel, button_id::go_on)->enabled);
                board.can_confirm = true;
                CHECK(findButton(parallelPanel(board, words), button_id::go_on)->enabled);
            }
    }

    TEST_CASE("four to six stimuli stand in two columns where the labels of their scale have room") {
        const auto columns = [](const Scale& scale, std::size_t count) {
            ParallelBoard board{"?", scale};
            board.stimuli.resize(count);
            std::vector<double> left;
            for (const PanelButton& button : parallelPanel(board, LanguageTable::english()).buttons)
                if (button.role == ButtonRole::play) left.push_back(button.box.x);
            std::sort(left.begin(), left.end());
            return std::unique(left.begin(), left.end()) - left.begin();
        };
        CHECK(columns(slider(0, 100, {"bad", "good"}), 3) == 1);
        CHECK(columns(slider(0, 100, {"bad", "good"}), 4) == 2);
        CHECK(columns(slider(0, 100), 6) == 2);
        CHECK(columns(slider(0, 100, {"bad", "poor", "fair", "good", "excellent"}), 6) == 1);
        CHECK(columns(steps(1, 5), 6) == 2);
        CHECK(columns(steps(1, 7), 6) == 1);
    }

    TEST_CASE("a play button keeps its place and size whatever its stimulus does") {
        for (const std::string& code : languageCodes()) {
            const LanguageTable words = languageTable(code);
            for (const int count : {2, 3, 4, 6}) {
                ParallelBoard board{"?", slider(0, 100)};
                board.stimuli.resize(static_cast<std::size_t>(count));
                const Panel before = parallelPanel(board, words);
                for (StimulusView& stimulus : board.stimuli) stimulus.state = PlayState::played;
                board.stimuli[1].state = PlayState::playing;
                const Panel after = parallelPanel(board, words);
                CHECK(before.height_m == after.height_m);
                for (std::size_t i = 0; i < before.buttons.size(); ++i) {
                    CHECK(before.buttons[i].box.x == after.buttons[i].box.x);
                    CHECK(before.buttons[i].box.y == after.buttons[i].box.y);
                    CHECK(before.buttons[i].box.width == after.buttons[i].box.width);
                }
            }
        }
    }

    TEST_CASE("a pair is played at its own side and answered from clearly left to clearly right") {
        const LanguageTable& words = LanguageTable::english();
        PairwiseBoard board{"Which points better?"};
        board.preference = 1;
        const Panel panel = pairwisePanel(board, words);
        const PanelButton* left = findButton(panel, button_id::first_play);
        const PanelButton* right = findButton(panel, button_id::first_play + 1);
        REQUIRE(left != nullptr);
        REQUIRE(right != nullptr);
        CHECK(left->label == "Left");
        CHECK(right->label == "Right");
        CHECK(left->box.x + left->box.width < panel.width_m / 2.0);
        CHECK(right->box.x > panel.width_m / 2.0);
        CHECK(idsOf(panel, ButtonRole::option) == counting(button_id::first_rating, 5));
        const PanelButton* clearly_left = findButton(panel, button_id::first_rating);
        CHECK(clearly_left->label == "Clearly left");
        CHECK_FALSE(clearly_left->enabled);
        CHECK(clearly_left->box.x < 0.1);
        CHECK(findButton(panel, button_id::first_rating + 3)->chosen);
        CHECK(findButton(panel, button_id::first_rating + 4)->label == "Clearly right");
        CHECK_FALSE(findButton(panel, button_id::first_rating + 2)->chosen);
    }
}
