// What is heard with a clip.
#include <doctest/doctest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "session_stages.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

/// Each clip lasts half a second, and its sound as long as told.
class SpokenClip : public ClipSource {
  public:
    explicit SpokenClip(double sound_s) : sound_{"speech.wav", sound_s} {}
    [[nodiscard]] const motion::Clip& clip(const Stimulus&) const override { return clip_; }
    [[nodiscard]] const ClipSound* sound(const Stimulus&) const override { return &sound_; }

  private:
    motion::Clip clip_ = handClip(0.5);
    ClipSound sound_;
};

struct Spoken : Driver {
    explicit Spoken(double sound_s = 0.5) : Driver(1, 0.5, false), spoken(sound_s) {}
    void begin() { session.emplace(study, plan, spoken, avatar, idle, left, keyboard); }
    SpokenClip spoken;
};

struct SpokenPair : Driver {
    SpokenPair() : Driver({pairStage()}), spoken(0.5) {
        add("pairs", 0, {"one", "two"});
        session.emplace(study, plan, spoken, avatar, idle, left, keyboard);
        wait(0.6);
    }
    SpokenClip spoken;
};

bool clipPlays(const Driver& driver) {
    return driver.state() == "playing" || driver.state() == "pointing";
}

}  // namespace

TEST_SUITE("studies/session_sound") {
    TEST_CASE("a sound is heard from its clip's first frame to its own end, and nowhere else") {
        Spoken driver(0.9);
        driver.begin();
        int heard = 0;
        while (!answersOpen(driver.frame)) {
            if (resting(driver.frame)) {
                driver.leavePage();
                continue;
            }
            driver.step();
            if (!driver.frame.sound) {
                const bool over =
                    heard > 0 && driver.time_s - driver.last(NoteKind::stimulus_onset).at.time_s >= 0.9;
                CHECK((over || !clipPlays(driver)));
                continue;
            }
            CHECK(clipPlays(driver));
            CHECK(driver.frame.sound->id == "speech.wav");
            const double since_s =
                heard == 0 ? 0.0 : driver.time_s - driver.last(NoteKind::stimulus_onset).at.time_s;
            CHECK(driver.frame.sound->time_s == doctest::Approx(since_s));
            ++heard;
            // Half a metre around a grown-up's mouth, at the origin.
            CHECK(std::abs(driver.frame.sound->mouth.y - 1.6) < 0.25);
            CHECK(driver.frame.sound->mouth.z > 0.0);
        }
        CHECK(heard == doctest::Approx(0.9 * 60.0).epsilon(0.03));
        // The clip is shorter: its last pose was held.
        const double lasted_s =
            driver.last(NoteKind::motion_end).at.time_s - driver.last(NoteKind::stimulus_onset).at.time_s;
        CHECK(lasted_s == doctest::Approx(0.9).epsilon(0.03));
    }

    TEST_CASE("nothing is heard in a muted stage") {
        Spoken driver(0.9);
        driver.stage("naturalness").muted = true;
        driver.begin();
        while (!answersOpen(driver.frame)) {
            if (resting(driver.frame))
                driver.leavePage();
            else
                driver.step();
            REQUIRE_FALSE(driver.frame.sound);
        }
        CHECK(driver.last(NoteKind::motion_end).at.time_s - driver.last(NoteKind::stimulus_onset).at.time_s ==
              doctest::Approx(0.5).epsilon(0.04));
    }

    TEST_CASE("a sound stands at its start until the clip's first frame was shown") {
        Spoken driver;
        driver.begin();
        REQUIRE(driver.toState("playing"));
        for (int i = 0; i < 5; ++i) {
            if (driver.count(NoteKind::stimulus_onset) > 0) break;
            driver.step({}, false);
            REQUIRE(driver.frame.sound);
            CHECK(driver.frame.sound->time_s == 0.0);
        }
    }

    TEST_CASE("a pause silences it, and the clip begins again with it") {
        Spoken driver;
        driver.begin();
        REQUIRE(driver.toState("pointing"));
        REQUIRE(driver.frame.sound);
        driver.step(pauseFor(PauseReason::escape));
        CHECK_FALSE(driver.frame.sound);
        driver.wait(1.0);
        CHECK_FALSE(driver.frame.sound);
        InputFrame resume;
        resume.resume = true;
        driver.step(resume);
        REQUIRE(driver.waitUntil([&] { return driver.frame.sound.has_value(); }));
        CHECK(driver.frame.sound->time_s == 0.0);
    }

    TEST_CASE("of a pair it comes from the mouth of the one that moves") {
        SpokenPair driver;
        std::array<double, 2> side{};
        for (int i = 0; i < 2; ++i) {
            driver.press(button_id::first_play + i);
            REQUIRE(driver.waitUntil([&] { return driver.frame.sound.has_value(); }));
            CHECK(driver.frame.sound->on_right == (i == 1));
            const Vec3 from_eyes = driver.frame.sound->mouth - driver.frame.stage_from_viewer.position;
            const Vec3 right = driver.frame.stage_from_viewer.orientation * Vec3(1, 0, 0);
            side[static_cast<std::size_t>(i)] = glm::dot(from_eyes, right);
            REQUIRE(driver.waitUntil([&] { return !driver.frame.sound.has_value(); }));
            driver.wait(0.5);
        }
        CHECK(side[0] < -0.2);
        CHECK(side[1] > 0.2);
    }
}
