#include "studies/simulation/simulated_participant.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "simulated_room.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

/// A page of movements to be played: while one plays, no button can be pressed.
struct PlayPage {
    Room& room;
    std::vector<motion::Clip> clips;
    bool pair = false;
    std::vector<int> plays = std::vector<int>(clips.size(), 0);
    std::function<void(Panel&, bool all_played)> open{};

    void enable() const {
        const bool all = std::all_of(plays.begin(), plays.end(), [](int times) { return times > 0; });
        open(*room.frame.panel, all);
    }
    /// True when `done` came about.
    bool run(const std::function<bool()>& done) {
        for (int guard = 0; guard < 20; ++guard) {
            enable();
            std::optional<std::size_t> asked;
            const auto come = [&] {
                enable();
                for (std::size_t i = 0; i < clips.size(); ++i)
                    if (room.wasPressed(button_id::first_play + static_cast<int>(i))) asked = i;
                return asked.has_value() || done();
            };
            if (!room.until(come)) return false;
            if (!asked) return true;
            const std::size_t played = *asked;
            std::erase(room.pressed, button_id::first_play + static_cast<int>(played));
            for (PanelButton& button : room.frame.panel->buttons) button.enabled = false;
            for (PanelSlider& slider : room.frame.panel->sliders) slider.enabled = false;
            room.wait(0.4);
            room.play(clips[played], pair && played == 1);
            room.frame.avatar_joints = Room::idle();
            if (pair) room.frame.right_avatar_joints = Room::idle();
            ++plays[played];
            for (PanelButton& button : room.frame.panel->buttons)
                button.enabled = button.role == ButtonRole::play;
            asked.reset();
        }
        return false;
    }
};

/// Which of the five, from clearly left to clearly right.
int prefer(const motion::Clip& left, const motion::Clip& right, std::uint64_t seed,
           const SimulatedParameters& parameters) {
    Room room(seed, parameters);
    room.frame.right_avatar_joints = Room::idle();
    BoardByHand board;
    board.button(button_id::first_play, ButtonRole::play, "Left");
    board.button(button_id::first_play + 1, ButtonRole::play, "Right");
    board.row();
    for (int i = 0; i < 5; ++i) board.button(button_id::first_rating + i, ButtonRole::option, "words", false);
    room.frame.panel = board.panel;
    PlayPage page{room, {left, right}, true};
    page.open = [](Panel& panel, bool all_played) {
        for (PanelButton& button : panel.buttons)
            if (button.role == ButtonRole::option) button.enabled = all_played;
    };
    REQUIRE(page.run([&room] { return !room.pressed.empty(); }));
    CHECK(page.plays == std::vector<int>{1, 1});
    return room.pressed.front() - button_id::first_rating;
}

/// Balls before an avatar that has pointed at the first of them.
struct Game {
    explicit Game(std::uint64_t seed, const SimulatedParameters& parameters, const std::vector<Vec3>& places)
        : room(seed, parameters) {
        for (const Vec3& place : places) room.frame.balls.push_back({place, 0.05, BallLook::waiting});
        room.watch(stiff());
        for (BallView& ball : room.frame.balls) ball.look = BallLook::selectable;
    }
    int choose() {
        REQUIRE(room.until([this] { return !room.balls.empty(); }));
        const int chosen = room.balls.front();
        room.frame.balls[static_cast<std::size_t>(chosen)].look = BallLook::chosen;
        return chosen;
    }
    Room room;
};

}  // namespace

TEST_SUITE("studies/simulated_participant") {
    TEST_CASE("it gives the number that a sign asks for, and only for that movement") {
        for (const int asked : {1, 2, 3}) {
            SimulatedParameters exact;
            exact.rating_noise_within = 0.0;
            Room room(4, exact);
            room.watch(natural());
            const int usual = rateBySteps(room, 1, 5);
            REQUIRE(usual > 3);
            room.frame.avatar_joints = Room::idle();
            room.wait(0.6);
            // "Movement 3": another number comes before it.
            room.frame.sign = signSaying("Movement 3, please rate it", std::to_string(asked));
            room.play(natural());
            room.frame.sign.reset();
            room.wait(0.1);
            CHECK(rateBySteps(room, 1, 5) == asked);
            room.watch(natural());
            CHECK(rateBySteps(room, 1, 5) == usual);
            room.watch(natural());
            room.frame.sign = signSaying("", std::to_string(asked));
            room.wait(0.2);
            CHECK(rateBySlider(room, 0, 10) == asked);
        }
    }

    TEST_CASE("who lapses in attention rates as if there had been no sign") {
        const auto rate = [](double lapses, bool sign, std::uint64_t seed) {
            SimulatedParameters parameters;
            parameters.attention_lapse_rate = lapses;
            Room room(seed, parameters);
            room.frame.panel.reset();
            room.wait(0.6);
            if (sign) room.frame.sign = signSaying("Please rate this movement: 1");
            room.play(natural());
            room.frame.sign.reset();
            return rateBySteps(room, 1, 5);
        };
        int heeded = 0;
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            CHECK(rate(1.0, true, seed) == rate(1.0, false, seed));
            CHECK(rate(0.0, true, seed) == 1);
            if (rate(0.5, true, seed) == 1) ++heeded;
        }
        CHECK(heeded > 10);
        CHECK(heeded < 32);
    }

    TEST_CASE("on a page of several movements it plays each once and sets the slider of each as it moved") {
        double natural_mean = 0.0;
        double stiff_mean = 0.0;
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            CAPTURE(seed);
            Room room(seed);
            BoardByHand board;
            board.button(button_id::go_on, ButtonRole::go_on, "Confirm", false);
            board.row();
            for (int i = 0; i < 3; ++i) {
                board.button(button_id::first_play + i, ButtonRole::play, "Play");
                board.slider(button_id::first_slider + i, 0, 100);
                board.row();
            }
            room.frame.panel = board.panel;
            PlayPage page{room, {natural(), stiff(), natural()}};
            page.open = [seed](Panel& panel, bool all_played) {
                bool all_set = true;
                for (PanelSlider& slider : panel.sliders) {
                    slider.enabled = all_played || seed % 2 == 0;
                    all_set = all_set && slider.value.has_value();
                }
                panel.buttons.front().enabled = all_played && all_set;
            };
            REQUIRE(page.run([&room] { return room.wasPressed(button_id::go_on); }));
            CHECK(page.plays == std::vector<int>{1, 1, 1});
            CHECK(room.misses == 0);
            natural_mean +=
                (*room.frame.panel->sliders[0].value + *room.frame.panel->sliders[2].value) / 20.0;
            stiff_mean += *room.frame.panel->sliders[1].value / 10.0;
        }
        CHECK(natural_mean > stiff_mean + 15.0);
    }

    TEST_CASE("of a pair it prefers the side that moved more naturally, whichever side it is") {
        int for_natural = 0;
        int against = 0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            const int left = 2 - prefer(natural(), stiff(), seed, {});
            const int right = prefer(stiff(), natural(), seed, {}) - 2;
            for_natural += (left > 0 ? 1 : 0) + (right > 0 ? 1 : 0);
            against += (left < 0 ? 1 : 0) + (right < 0 ? 1 : 0);
        }
        CHECK(for_natural >= 30);
        CHECK(against <= 5);
    }

    TEST_CASE("the zones of a preference: no difference, a slight one, a clear one") {
        SimulatedParameters exact;
        exact.rating_noise_within = 0.0;
        CHECK(prefer(natural(), natural(), 1, exact) == 2);
        CHECK(prefer(natural(), stiff(), 1, exact) == 0);
        exact.preference_clear_zone = 5.0;
        CHECK(prefer(natural(), stiff(), 1, exact) == 1);
        CHECK(prefer(stiff(), natural(), 1, exact) == 3);
        exact.preference_tie_zone = 5.0;
        CHECK(prefer(natural(), stiff(), 1, exact) == 2);
    }

    TEST_CASE("it finds the ball pointed at among any number, and lets a chosen or revealed one be") {
        SimulatedParameters exact;
        exact.observer.noise_rad = 0.0;
        exact.observer.lapse_rate = 0.0;
        for (int distractors = 0; distractors <= 8; ++distractors) {
            CAPTURE(distractors);
            std::vector<Vec3> places;
            for (int i = 0; i < distractors; ++i)
                places.push_back(target + 0.3 * Vec3(std::cos(0.7 * i), std::sin(0.7 * i), 0.0));
            const int at = distractors / 2;
            places.insert(places.begin() + at, target);
            Game game(2, exact, places);
            CHECK(game.choose() == at);
            game.room.wait(3.0);
            game.room.frame.balls[0].look = BallLook::revealed;
            game.room.wait(3.0);
            CHECK(game.room.balls.size() == 1);
            CHECK(game.room.misses == 0);
        }
    }

    TEST_CASE("it is the surer of its choice the clearer the next ball was out of the way") {
        const auto sureness = [](double apart_m, std::uint64_t seed, double noise) {
            SimulatedParameters parameters;
            parameters.observer.lapse_rate = 0.0;
            parameters.observer.noise_rad = radiansFromDegrees(0.5);
            parameters.confidence_noise_within = noise;
            std::vector<Vec3> places{target};
            if (apart_m > 0.0) places.push_back(target + Vec3(apart_m, 0.0, 0.0));
            Game game(seed, parameters, places);
            game.choose();
            game.room.wait(0.4);
            // As it may stand in a study: the balls are still there.
            return rateBySteps(game.room, 1, 7);
        };
        double near = 0.0;
        double far = 0.0;
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            near += sureness(0.12, seed, 0.5) / 20.0;
            far += sureness(0.8, seed, 0.5) / 20.0;
        }
        CHECK(far > near + 1.0);
        CHECK(sureness(0.0, 1, 0.0) == 7);  // nothing to mistake it for
    }

    TEST_CASE("a choice made at random is made without confidence") {
        SimulatedParameters parameters;
        parameters.observer.lapse_rate = 1.0;
        parameters.confidence_noise_within = 0.0;
        Game game(1, parameters, {target, target + Vec3(0.8, 0.0, 0.0)});
        game.choose();
        game.room.wait(0.4);
        CHECK(rateBySteps(game.room, 1, 5) == 1);
    }

    TEST_CASE("after a game, a rating is again one of the movement seen") {
        SimulatedParameters parameters;
        parameters.observer.lapse_rate = 1.0;  // a confidence would be 1
        parameters.confidence_noise_within = 0.0;
        parameters.rating_base = 5.0;  // a rating 5
        parameters.rating_noise_within = 0.0;
        Game game(1, parameters, {target, target + Vec3(0.8, 0.0, 0.0)});
        game.choose();
        game.room.wait(0.4);
        game.room.frame.balls.clear();
        game.room.watch(natural());
        CHECK(rateBySteps(game.room, 1, 5) == 5);
    }

    TEST_CASE("its ray meets the chosen ball first, also where another stands in front of it") {
        PresentedFrame frame;
        frame.avatar_joints = Room::idle();
        frame.stage_from_viewer = {{0.0, 0.0, 3.4}, no_rotation};
        frame.viewer_place = "across";
        // From the hand's place, the first ball stands exactly behind the second and the third just beside.
        const Vec3 hand(0.2, 1.15, 3.05);
        const Vec3 direction = glm::normalize(Vec3(-0.3, 0.05, -1.0));
        frame.balls = {{hand + 1.6 * direction, 0.05, BallLook::waiting},
                       {hand + 1.2 * direction, 0.05, BallLook::waiting},
                       {hand + 1.2 * direction + Vec3(0.1, 0.0, 0.0), 0.05, BallLook::waiting}};
        SimulatedParameters parameters;
        parameters.observer.lapse_rate = 1.0;
        std::array<int, 3> chosen{0, 0, 0};
        for (std::uint64_t seed = 1; seed <= 40; ++seed) {
            SimulatedParticipant participant(parameters, motion::referenceHumanoid(), seed);
            for (BallView& ball : frame.balls) ball.look = BallLook::waiting;
            participant.see(frame, 0.0);
            for (BallView& ball : frame.balls) ball.look = BallLook::selectable;
            std::optional<Ray> before;
            bool selected = false;
            for (int i = 1; i < 300 && !selected; ++i) {
                const InputFrame input = participant.act(i / 30.0);
                if (input.select) {
                    selected = true;
                    REQUIRE(input.pointer.has_value());
                    REQUIRE(before.has_value());
                    CHECK(glm::length(before->direction - input.pointer->direction) < 1e-12);
                    std::size_t met = 3;
                    double nearest_m = 1e9;
                    for (std::size_t place = 0; place < 3; ++place) {
                        const double distance_m =
                            distanceToSphere(*input.pointer, frame.balls[place].centre, 0.05);
                        if (distance_m < 0.0 || distance_m >= nearest_m) continue;
                        nearest_m = distance_m;
                        met = place;
                    }
                    REQUIRE(met < 3);
                    ++chosen[met];
                }
                before = input.pointer;
                participant.see(frame, i / 30.0);
            }
            CHECK(selected);
        }
        // Random places: were the hidden ball out of reach, its share would go to the one in front.
        for (const int times : chosen) CHECK(times >= 6);
    }
}
