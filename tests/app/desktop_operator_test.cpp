// The experimenter's window beside the participant's, on a virtual display, with the one keyboard and mouse
// of both.
#include <SQLiteCpp/SQLiteCpp.h>

#include <string>

#include "display.hpp"

using namespace deixis::tests;

namespace {

// The participant's window, 480x320, is put against the screen's left edge; the experimenter's takes what is
// left beside it, over the whole height. Middles of what is at the foot of the panel, at the right of the
// screen.
struct Place {
    int x, y;
};
constexpr Place note_field{1000, 623};
constexpr Place repeat_button{1033, 715};
constexpr Place skip_button{1187, 715};
constexpr Place abort_button{1033, 761};

void wait(double seconds) {
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

void click(const Place& at) {
    Display::xdotool("mousemove " + std::to_string(at.x) + " " + std::to_string(at.y));
    wait(0.3);
    Display::xdotool("click 1");
    wait(1.2);
}

void type(const std::string& text) {
    Display::xdotool("type --delay 120 '" + text + "'");
    wait(0.6);
    Display::xdotool("key Return");
    wait(0.6);
}

// Whether the experimenter's window has the keyboard.
bool keysAreTheOperators() {
    return Display::xdotool("getwindowfocus getwindowname").out.find("experimenter") != std::string::npos;
}

}  // namespace

TEST_SUITE("app/desktop_operator") {
    TEST_CASE(
        "the experimenter pauses, writes a note, repeats, skips and aborts with reasons; all of it is kept") {
        const Scratch scratch;
        const Display display;
        const std::string database = scratch / "study.sqlite";
        Background session(Display::environment() + " LIBGL_ALWAYS_SOFTWARE=1 " + programFile() +
                           " run pointing2023-stand-ins --participant P01 --operator --size 480x320 --db " +
                           database + " >" + (scratch / "out") + " 2>&1");
        const bool opened = eventually(120.0, [&] {
            return Display::xdotool("search --onlyvisible --name experimenter").status == 0 ||
                   !session.running();
        });
        INFO(slurp(scratch / "out"));
        REQUIRE(opened);
        REQUIRE(session.running());
        const std::string geometry =
            Display::xdotool("search --onlyvisible --name experimenter getwindowgeometry").out;
        CHECK_MESSAGE(geometry.find("Position: 480,0") != std::string::npos, geometry);
        CHECK_MESSAGE(geometry.find("Geometry: 800x800") != std::string::npos, geometry);

        // Through the pages and the first ratings.
        const bool rated = eventually(240.0, [&] {
            for (const char* key : {"Return", "4"}) {
                Display::xdotool(std::string("key ") + key);
                wait(0.2);
            }
            return countIn(database, "select count(*) from responses") >= 3 || !session.running();
        });
        REQUIRE(rated);
        REQUIRE(session.running());
        CHECK(countIn(database, "select count(*) from events where kind = 'pause'") == 0);

        // With the mouse in the other window the participant cannot answer: so the session is paused.
        const auto toOperator = [] {
            Display::xdotool("key F10");
            CHECK(eventually(20.0, keysAreTheOperators));
            wait(0.8);
        };
        toOperator();
        CHECK(eventually(20.0, [&] {
            return countIn(database,
                           "select count(*) from events where kind = 'pause' and detail = 'operator'") == 1;
        }));
        click(note_field);
        type("the phone rang, p and r");
        CHECK(eventually(20.0, [&] {
            return countIn(database,
                           "select count(*) from events where kind = 'operator_note' and detail = 'the phone "
                           "rang, p and r'") == 1;
        }));
        CHECK(countIn(database, "select count(*) from events where kind = 'recentre'") == 0);

        // Asked twice; a response that is repeated stays, and is marked.
        click(repeat_button);
        CHECK(countIn(database, "select count(*) from responses where superseded is not null") == 0);
        click(repeat_button);
        CHECK(eventually(20.0, [&] {
            return countIn(database, "select count(*) from responses where superseded is not null") == 1;
        }));

        // A trial is skipped with its reason, once one is under way.
        const bool skipped = eventually(60.0, [&] {
            click(skip_button);
            Display::xdotool("key Return");
            wait(0.8);
            type("the clip did not move");
            if (eventually(5.0, [&] {
                    return countIn(database, "select count(*) from responses where status = 'skipped'") == 1;
                }))
                return true;
            Display::xdotool("key p");
            wait(1.5);
            toOperator();
            return !session.running();
        });
        CHECK(skipped);
        CHECK(countIn(database,
                      "select count(*) from responses where status = 'skipped' and reason = 'the clip did "
                      "not move'") == 1);

        // Going on brings the participant's window to the front again: keys are the participant's.
        const int resumed = countIn(database, "select count(*) from events where kind = 'resume'");
        Display::xdotool("key p");
        CHECK(eventually(20.0, [&] {
            return countIn(database, "select count(*) from events where kind = 'resume'") == resumed + 1;
        }));
        CHECK(eventually(20.0, [] { return !keysAreTheOperators(); }));
        const int paused = countIn(database, "select count(*) from events where kind = 'pause'");
        Display::xdotool("key Escape");
        CHECK(eventually(20.0, [&] {
            return countIn(database,
                           "select count(*) from events where kind = 'pause' and detail = 'escape'") == 1 &&
                   countIn(database, "select count(*) from events where kind = 'pause'") == paused + 1;
        }));

        // Aborting takes a reason and is asked twice.
        toOperator();
        click(abort_button);
        type("felt unwell");
        wait(0.5);
        CHECK(session.running());
        CHECK(countIn(database, "select count(*) from sessions where outcome is not null") == 0);
        click(abort_button);
        CHECK(eventually(30.0, [&] { return !session.running(); }));
        CHECK(session.wait() == 0);
        CHECK(countIn(database, "select count(*) from sessions where outcome = 'aborted'") == 1);
        CHECK(
            countIn(database,
                    "select count(*) from events where kind = 'operator_abort' and detail = 'felt unwell'") ==
            1);
    }

    TEST_CASE(
        "where the experimenter's window would cover the participant's, it is rejected with what to do") {
        const Scratch scratch;
        const Display display;
        CHECK_FAILS_SAYING(
            program("run pointing2023-stand-ins --operator --size 1280x700 --db " + (scratch / "s.sqlite"),
                    Display::environment() + " LIBGL_ALWAYS_SOFTWARE=1"),
            "--operator", "second monitor");
        CHECK_FAILS_SAYING(
            program("run pointing2023-stand-ins --operator --fullscreen --db " + (scratch / "s.sqlite"),
                    Display::environment() + " LIBGL_ALWAYS_SOFTWARE=1"),
            "--operator", "--fullscreen");
    }
}
