// The real window, on a virtual display, with a keyboard and a mouse.
#include <SQLiteCpp/SQLiteCpp.h>

#include <cmath>
#include <map>
#include <utility>

#include "core/pose.hpp"
#include "program.hpp"

using namespace deixis::tests;

namespace {

// An X server of its own for one test.
class Display {
  public:
    Display()
        : server_("Xvfb :" + std::to_string(number()) +
                  " -screen 0 1280x800x24 -nolisten tcp >/dev/null 2>&1") {
        REQUIRE(eventually(20.0,
                           [&] { return shell(environment() + " xdotool getdisplaygeometry").status == 0; }));
    }
    [[nodiscard]] static std::string environment() { return "env DISPLAY=:" + std::to_string(number()); }

  private:
    static int number() {
        static const int chosen = 100 + static_cast<int>(getpid()) % 800;
        return chosen;
    }
    Background server_;
};

int count(const std::string& database, const std::string& query) {
    try {
        SQLite::Database db(database, SQLite::OPEN_READONLY, 1000);
        return db.execAndGet(query).getInt();
    } catch (const SQLite::Exception&) {
        return -1;
    }
}

// How far the mouse must go from the view that a trial begins with until a ball is in the middle: the view
// begins half way between the avatar and the balls and 6 degrees down, and a pixel turns it by 0.07 degrees.
std::pair<int, int> mouseTo(const nlohmann::json& trial, int place) {
    const bool across = trial["layout"] == "across";
    const double viewer_x = across ? 0.0 : -0.6;
    const double viewer_z = across ? 3.4 : -0.95;
    const double heading = deixis::radiansFromDegrees(across ? 180.0 : 15.0);
    const auto yawTo = [&](double x, double z) {
        return std::remainder(std::atan2(x - viewer_x, z - viewer_z) - heading, 2.0 * deixis::pi);
    };
    std::vector<nlohmann::json> balls{trial["target"]};
    for (const auto& distractor : trial["distractors"]) balls.push_back(distractor);
    double x = 0.0;
    double z = 0.0;
    for (const auto& ball : balls) {
        x += ball[0].get<double>() / 3.0;
        z += ball[2].get<double>() / 3.0;
    }
    const double first_yaw = 0.5 * (yawTo(0.0, 0.0) + yawTo(x, z));
    const auto& ball = balls[trial["ball_order"][static_cast<std::size_t>(place)].get<std::size_t>()];
    const double yaw = yawTo(ball[0], ball[2]);
    const double distance = std::hypot(ball[0].get<double>() - viewer_x, ball[2].get<double>() - viewer_z);
    const double pitch = std::atan2(ball[1].get<double>() - 1.65, distance);
    const double per_pixel = deixis::radiansFromDegrees(0.07);
    return {static_cast<int>(std::lround((first_yaw - yaw) / per_pixel)),
            static_cast<int>(std::lround((deixis::radiansFromDegrees(-6.0) - pitch) / per_pixel))};
}

}  // namespace

TEST_SUITE("app/desktop") {
    TEST_CASE("a person at the desktop reads, rates by key, pauses and ends; the answers are kept") {
        const Scratch scratch;
        const Display display;
        const std::string database = scratch / "study.sqlite";
        Background session(Display::environment() + " LIBGL_ALWAYS_SOFTWARE=1 " + DEIXIS_PROGRAM +
                           " run pointing2023 --participant P01 --size 480x320 --db " + database + " >" +
                           (scratch / "out") + " 2>&1");
        const std::string window = Display::environment() + " xdotool search --onlyvisible --name P01";
        const bool opened =
            eventually(120.0, [&] { return shell(window).status == 0 || !session.running(); });
        INFO(slurp(scratch / "out"));
        REQUIRE(opened);
        REQUIRE(session.running());
        const auto press = [&](const std::string& key) {
            shell(Display::environment() + " xdotool search --name P01 windowfocus key " + key);
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
        };
        // Pages are left with Enter, ratings given with 4: pressing both in turn walks through stage 1.
        const bool rated = eventually(240.0, [&] {
            press("Return");
            press("4");
            return count(database, "select count(*) from responses") >= 3 || !session.running();
        });
        INFO(slurp(scratch / "out"));
        REQUIRE(rated);
        CHECK(count(database, "select count(*) from responses where rating = 4 and input = 'key'") >= 3);
        CHECK(count(database, "select count(*) from sessions where station = 'desktop' and synthetic = 0") ==
              1);
        press("Escape");
        CHECK(eventually(
            20.0, [&] { return count(database, "select count(*) from events where kind = 'pause'") >= 1; }));
        session.kill(SIGTERM);
    }

    TEST_CASE(
        "a person at the desktop plays the game by aiming with the mouse and clicking, in both places") {
        const Scratch scratch;
        const Display display;
        const std::string database = scratch / "study.sqlite";
        std::string study = shippedStudy();
        for (const std::string from : {"items = 5 ", "items = 10 "})
            study = replaced(study, from, "items = 1 ");
        for (int i = 0; i < 2; ++i) study = replaced(study, "practice = 2 ", "practice = 0 ");
        spill(scratch / "study.toml", study);
        // One item a system: the layout goes to all its trials, so two participants make both places come up.
        std::map<std::string, int> places;
        for (const std::string participant : {"P01", "P02", "P03", "P04", "P05"}) {
            const auto plan = nlohmann::json::parse(
                program("plan " + (scratch / "study.toml") + " --participant " + participant + " --json")
                    .out);
            const std::string place = plan["trials"][4]["layout"];
            if (places[place]++ > 0) continue;
            Background session(Display::environment() + " LIBGL_ALWAYS_SOFTWARE=1 " + DEIXIS_PROGRAM +
                               " run " + (scratch / "study.toml") + " --participant " + participant +
                               " --size 480x320 --db " + database + " >" + (scratch / "out") + " 2>&1");
            const auto xdotool = [&](const std::string& what) {
                shell(Display::environment() + " xdotool " + what);
                std::this_thread::sleep_for(std::chrono::milliseconds(200));
            };
            const std::string of_participant = " from responses where participant = '" + participant + "'";
            const std::string trial_events =
                "select count(*) from events e join sessions s on s.id = e.session where "
                "s.participant = '" +
                participant + "' and e.kind = 'motion_end'";
            REQUIRE(eventually(60.0, [&] {
                return shell(Display::environment() + " xdotool search --onlyvisible --name " + participant)
                           .status == 0;
            }));
            xdotool("search --name " + participant + " windowfocus");
            REQUIRE(eventually(120.0, [&] {
                xdotool("key Return");
                xdotool("key 3");
                return count(database, trial_events) >= 5;
            }));
            CHECK(count(database, "select count(*)" + of_participant + " and rating = 3") == 4);
            for (int t = 4; t < 8; ++t) {
                const auto& trial = plan["trials"][static_cast<std::size_t>(t)];
                REQUIRE(eventually(60.0, [&] { return count(database, trial_events) >= t + 1; }));
                std::this_thread::sleep_for(std::chrono::milliseconds(500));
                const int wanted = t % 3;
                const auto [right_px, down_px] = mouseTo(trial, wanted);
                xdotool("mousemove_relative -- " + std::to_string(right_px) + " " + std::to_string(down_px));
                std::this_thread::sleep_for(std::chrono::milliseconds(400));
                INFO(participant << " trial " << t << " " << trial.dump());
                // A slow machine may not have shown the white balls yet; nothing more can be chosen before
                // the next motion has ended.
                REQUIRE(eventually(30.0, [&] {
                    xdotool("click 1");
                    std::this_thread::sleep_for(std::chrono::milliseconds(700));
                    return count(database, "select count(*)" + of_participant) == t + 1;
                }));
                CHECK(count(database, "select chosen_place" + of_participant +
                                          " and trial_index = " + std::to_string(t)) == wanted);
            }
            CHECK(eventually(30.0, [&] {
                xdotool("key Return");
                return !session.running();
            }));
            CHECK(session.wait() == 0);
        }
        CHECK(places.size() == 2);
    }

    TEST_CASE("without a display the desktop station says so and starts nothing else") {
        const Scratch scratch;
        CHECK_FAILS_SAYING(
            program("run pointing2023 --station desktop --participant P01 --db " + (scratch / "s.sqlite"),
                    "env -u DISPLAY -u WAYLAND_DISPLAY"),
            "display", "simulated");
    }

    TEST_CASE("a driver without OpenGL 4.5 is named with the version that it has") {
        const Scratch scratch;
        CHECK_FAILS_SAYING(
            program("run pointing2023 --station simulated --participant P01 --db " + (scratch / "s.sqlite"),
                    "env MESA_GL_VERSION_OVERRIDE=3.3 LIBGL_ALWAYS_SOFTWARE=1"),
            "4.5");
        const Display display;
        CHECK_FAILS_SAYING(
            program("run pointing2023 --station desktop --participant P01 --db " + (scratch / "s.sqlite"),
                    Display::environment() + " MESA_GL_VERSION_OVERRIDE=3.3 LIBGL_ALWAYS_SOFTWARE=1"),
            "4.5");
    }
}
