// Boards that a simulated participant fills in, made by hand.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "simulated_room.hpp"

using namespace deixis;
using namespace deixis::tests;

TEST_SUITE("studies/simulated_boards") {
    TEST_CASE("it waits on a page that cannot be left yet, then leaves it, and agrees to take part") {
        Room room(1);
        BoardByHand page;
        page.button(button_id::go_on, ButtonRole::go_on, "Weiter", false);
        room.frame.panel = page.panel;
        room.wait(20.0);
        CHECK(room.pressed.empty());
        CHECK(room.misses == 0);
        room.frame.panel->buttons.front().enabled = true;
        CHECK(room.until([&room] { return room.wasPressed(button_id::go_on); }, 4.0));

        BoardByHand consent;
        consent.button(button_id::decline, ButtonRole::leave, "I do not agree");
        consent.button(button_id::agree, ButtonRole::go_on, "I agree");
        room.frame.panel = consent.panel;
        room.pressed.clear();
        REQUIRE(room.until([&room] { return !room.pressed.empty(); }));
        CHECK(room.pressed == std::vector<int>{button_id::agree});
    }

    TEST_CASE("it fills in a whole page of questions, and only then leaves it") {
        for (const bool keyboard : {true, false}) {
            for (std::uint64_t seed = 1; seed <= 20; ++seed) {
                CAPTURE(keyboard);
                CAPTURE(seed);
                Room room(seed, {}, keyboard);
                BoardByHand board;
                board.steps(button_id::first_option, 0, 6);
                for (int i = 0; i < 3; ++i)
                    board.button(button_id::first_option + 100 + i, ButtonRole::option, "words");
                board.row();
                board.slider(button_id::first_field + 2, 0, 100);
                board.field(button_id::first_field + 3, "18 to 99");
                if (keyboard) {
                    board.field(button_id::first_field + 4, "Type your answer");
                } else {
                    board.panel.fields.front().enabled = false;
                    for (int key = 0; key <= 10; ++key)
                        board.button(button_id::first_option + 300 + key, ButtonRole::other,
                                     key < 10 ? std::to_string(key) : "Erase");
                }
                board.button(button_id::go_on, ButtonRole::go_on, "Continue");
                room.frame.panel = board.panel;
                room.on_press = [&room](int id) {
                    std::string& typed = room.frame.panel->fields.front().text;
                    const int key = id - button_id::first_option - 300;
                    if (key >= 0 && key <= 9) typed += std::to_string(key);
                    if (key == 10 && !typed.empty()) typed.pop_back();
                };
                REQUIRE(room.until([&room] { return room.wasPressed(button_id::go_on); }));
                const Panel& panel = *room.frame.panel;
                for (const int group : {0, 100}) {
                    CHECK(std::count_if(panel.buttons.begin(), panel.buttons.end(), [group](const auto& b) {
                              return b.chosen && b.id / 100 == (button_id::first_option + group) / 100;
                          }) == 1);
                }
                REQUIRE(panel.sliders.front().value.has_value());
                const std::string& number = panel.fields.front().text;
                REQUIRE(number.size() == 2);
                CHECK(std::stoi(number) >= 18);
                CHECK(std::stoi(number) <= 99);
                if (keyboard) CHECK(panel.fields.back().text == "simulated answer");
                CHECK(room.misses == 0);
            }
        }
    }

    TEST_CASE("without a keyboard it does not wait for words that it cannot type") {
        Room room(3, {}, false);
        BoardByHand board;
        board.field(button_id::first_field, "Type your answer");
        board.button(button_id::go_on, ButtonRole::go_on, "Continue");
        room.frame.panel = board.panel;
        REQUIRE(room.until([&room] { return !room.pressed.empty(); }));
        CHECK(room.pressed.front() == button_id::go_on);
        CHECK(room.frame.panel->fields.front().text.empty());
    }

    TEST_CASE("its answers to questions scatter around the middle, by a bias that stays its own") {
        double sum = 0.0;
        double squares_between = 0.0;
        constexpr int people = 60;
        for (std::uint64_t seed = 1; seed <= people; ++seed) {
            Room room(seed);
            BoardByHand board;
            for (int i = 0; i < 6; ++i) board.slider(button_id::first_field + i, 0, 100);
            board.button(button_id::go_on, ButtonRole::go_on, "Continue");
            room.frame.panel = board.panel;
            REQUIRE(room.until([&room] { return room.wasPressed(button_id::go_on); }));
            double mean = 0.0;
            for (const PanelSlider& slider : room.frame.panel->sliders) mean += *slider.value / 6.0;
            sum += mean;
            squares_between += (mean - 50.0) * (mean - 50.0);
        }
        CHECK(std::abs(sum / people - 50.0) < 8.0);  // SE 2.1
        // Means of six that share a bias: variance 15^2 + 15^2 / 6; without one it would be 6.1^2.
        CHECK(std::sqrt(squares_between / people) > 11.0);
        CHECK(std::sqrt(squares_between / people) < 21.0);
    }

    TEST_CASE("words of one width are read as a scale, others as options without an order") {
        const auto counted = [](double wider_m) {
            std::array<int, 5> times{};
            for (std::uint64_t seed = 1; seed <= 80; ++seed) {
                Room room(seed);
                BoardByHand board;
                for (int i = 0; i < 5; ++i)
                    board.button(button_id::first_option + i, ButtonRole::option, "words").box.width +=
                        i * wider_m;
                room.frame.panel = board.panel;
                REQUIRE(room.until([&room] { return !room.pressed.empty(); }));
                ++times[static_cast<std::size_t>(room.pressed.front() - button_id::first_option)];
            }
            return times;
        };
        const auto scale = counted(0.0);
        CHECK(scale[1] + scale[2] + scale[3] >= 70);
        for (const int times : counted(0.001)) CHECK(times >= 7);  // 16 expected, SD 3.6
    }

    TEST_CASE("the same judgement is spread over any scale: five steps, seven, eleven from 0, a slider") {
        int clamped = 0;
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            CAPTURE(seed);
            const auto seen = [seed] {
                Room room(seed);
                room.watch(seed % 2 == 0 ? natural() : stiff());
                return room;
            };
            Room of_five = seen();
            const int five = rateBySteps(of_five, 1, 5);
            Room of_seven = seen();
            const int seven = rateBySteps(of_seven, 1, 7);
            Room of_eleven = seen();
            const int eleven = rateBySteps(of_eleven, 0, 10);
            Room by_slider = seen();
            const double share = rateBySlider(by_slider, 0, 1000) / 1000.0;
            // Each is the slider's value to within half a step.
            CHECK(std::abs(five - (1.0 + 4.0 * share)) <= 0.5 + 0.01);
            CHECK(std::abs(seven - (1.0 + 6.0 * share)) <= 0.5 + 0.01);
            CHECK(std::abs(eleven - 10.0 * share) <= 0.5 + 0.01);
            CHECK(of_five.misses + of_seven.misses + of_eleven.misses + by_slider.misses == 0);
            if (share == 0.0 || share == 1.0) ++clamped;
        }
        CHECK(clamped < 15);
    }

    TEST_CASE("a slider is set with select held, and the ray rests on the value when it is let go") {
        int drags = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Room room(seed);
            room.watch(natural());
            BoardByHand board;
            board.slider(button_id::first_slider, 0, 100);
            room.frame.panel = board.panel;
            int held = 0;
            std::optional<int> first;
            REQUIRE(room.until([&] {
                if (room.input.select_held) ++held;
                const auto& value = room.frame.panel->sliders.front().value;
                if (value && !first) first = *value;
                return value && !room.input.select_held;
            }));
            if (held > 1) ++drags;
            const int value = *room.frame.panel->sliders.front().value;
            room.wait(3.0);
            CHECK(room.pressed.size() == 1);
            CHECK(*room.frame.panel->sliders.front().value == value);
            if (held == 1) CHECK(*first == value);
        }
        CHECK(drags >= 4);
        CHECK(drags <= 16);
    }
}
