// The real window, on a virtual display: the keyboard alone, and displays that cannot be used. Whole studies
// by mouse and keyboard: tests/desktop.
#include <SQLiteCpp/SQLiteCpp.h>

#include "display.hpp"

using namespace deixis::tests;

TEST_SUITE("app/desktop") {
    TEST_CASE("a person at the desktop reads, rates and pauses by key alone; the answers are kept") {
        const Scratch scratch;
        const Display display;
        const std::string database = scratch / "study.sqlite";
        Background session(Display::environment() + " LIBGL_ALWAYS_SOFTWARE=1 " + programFile() +
                           " run pointing2023-stand-ins --participant P01 --size 480x320 --db " + database +
                           " >" + (scratch / "out") + " 2>&1");
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
        // Pages are left with Enter, ratings given with 4: pressing both in turn goes through part 1.
        const bool rated = eventually(240.0, [&] {
            press("Return");
            press("4");
            return countIn(database, "select count(*) from responses") >= 3 || !session.running();
        });
        INFO(slurp(scratch / "out"));
        REQUIRE(rated);
        CHECK(countIn(database,
                      "select count(*) from answers a join responses r on r.id = a.response "
                      "where a.question = 'rating' and a.value = 4 and r.input = 'key'") >= 3);
        CHECK(countIn(database,
                      "select count(*) from sessions where station = 'desktop' and synthetic = 0") == 1);
        press("Escape");
        CHECK(eventually(20.0, [&] {
            return countIn(database, "select count(*) from events where kind = 'pause'") >= 1;
        }));
        session.kill(SIGTERM);
    }

    TEST_CASE("without a display the desktop station says so and starts nothing else") {
        const Scratch scratch;
        CHECK_FAILS_SAYING(program("run pointing2023-stand-ins --station desktop --participant P01 --db " +
                                       (scratch / "s.sqlite"),
                                   "env -u DISPLAY -u WAYLAND_DISPLAY"),
                           "display", "simulated");
    }

    TEST_CASE("a driver without OpenGL 4.5 is named with the version that it has") {
        const Scratch scratch;
        CHECK_FAILS_SAYING(
            program("run pointing2023-stand-ins --station simulated --participant P01 --db " +
                        (scratch / "s.sqlite") + " --screenshot rating=" + (scratch / "rating.png"),
                    "env MESA_GL_VERSION_OVERRIDE=3.3 LIBGL_ALWAYS_SOFTWARE=1"),
            "4.5");
        const Display display;
        CHECK_FAILS_SAYING(
            program("run pointing2023-stand-ins --station desktop --participant P01 --db " +
                        (scratch / "s.sqlite"),
                    Display::environment() + " MESA_GL_VERSION_OVERRIDE=3.3 LIBGL_ALWAYS_SOFTWARE=1"),
            "4.5");
    }
}
