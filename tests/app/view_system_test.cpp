// deixis view --system: a system that points at a ball, as a picture.
#include <filesystem>

#include "program.hpp"
#include "text.hpp"

using namespace deixis::tests;

namespace {

/// A film of raw frames: in place of ffmpeg, which takes a while to install, a script that keeps what it is
/// given, in the file that it names.
Finished film(const Scratch& scratch, const std::string& ffmpeg, const std::string& options) {
    spill(scratch / "ffmpeg", "#!/bin/sh\nfor last; do :; done\n" + ffmpeg + "\n");
    std::filesystem::permissions(scratch / "ffmpeg", std::filesystem::perms::owner_all);
    return program("view --system direct --size 160x120 " + options,
                   "env PATH=" + scratch.path().string() + ":$PATH");
}

/// Red as nothing in the picture but the ball is, in the first frame.
int ballPixels(const std::string& frames) {
    int out = 0;
    for (std::size_t i = 0; i < 160 * 120; ++i) {
        const auto channel = [&](std::size_t c) {
            return static_cast<int>(static_cast<unsigned char>(frames.at(3 * i + c)));
        };
        out += channel(0) > 150 && channel(1) < 100 && channel(2) < 70 ? 1 : 0;
    }
    return out;
}

}  // namespace

TEST_SUITE("app/view_system") {
    TEST_CASE("the ball is in the picture wherever it is, unless a side is asked for") {
        const Scratch scratch;
        int hidden = 0;
        for (const char* target :
             {"-1.43 1.34 1.67", "1.9 0.3 -0.2", "0.2 2.0 2.1", "-1.9 0.2 0.4", "1.0 1.9 1.8"}) {
            CAPTURE(target);
            const std::string at =
                std::string("--force --target ") + target + " --mp4 " + (scratch / "film.mp4");
            REQUIRE(film(scratch, "cat >\"$last\"", at).status == 0);
            CHECK(ballPixels(slurp(scratch / "film.mp4")) > 2);
            REQUIRE(film(scratch, "cat >\"$last\"", "--from three-quarter " + at).status == 0);
            hidden += ballPixels(slurp(scratch / "film.mp4")) == 0 ? 1 : 0;
        }
        CHECK(hidden > 0);
    }

    TEST_CASE("a picture of the hold, or of several times side by side; the ball where it is asked for") {
        const Scratch scratch;
        const auto picture = [&](const std::string& name, const std::string& more) {
            const std::string file = scratch / name;
            const auto done =
                program("view --system direct --size 160x120 --screenshot " + file + " " + more);
            CHECK_MESSAGE(done.status == 0, done.err);
            return slurp(file);
        };
        const auto width = [](const std::string& png) {
            return 256 * static_cast<unsigned char>(png.at(18)) + static_cast<unsigned char>(png.at(19));
        };
        const std::string one = picture("one.png", ""), other = picture("other.png", "--target -0.5 1.4 1.8"),
                          two = picture("two.png", "--time 0 1.2");
        CHECK(width(one) == 160);
        CHECK(width(two) == 320);
        CHECK(one != other);
    }

    TEST_CASE("a film has every frame of the movement, 30 a second, and none is left where ffmpeg fails") {
        const Scratch scratch;
        const auto done = film(scratch, "cat >\"$last\"", "--mp4 " + (scratch / "new/direct.mp4"));
        REQUIRE_MESSAGE(done.status == 0, done.err);
        const std::string frames = slurp(scratch / "new/direct.mp4");
        constexpr std::size_t frame = 160 * 120 * 3;
        REQUIRE(frames.size() % frame == 0);
        const std::size_t count = frames.size() / frame;
        CHECK(count > 30);
        CHECK(contains(done.out, std::to_string(count) + " frames"));
        CHECK(frames.substr(0, frame) != frames.substr(frame * (count / 2), frame));
        CHECK_FAILS_SAYING(film(scratch, "exit 1", "--mp4 " + (scratch / "broken.mp4")), "broken.mp4",
                           "ffmpeg could not write the film");
        CHECK_FALSE(std::filesystem::exists(scratch / "broken.mp4"));
    }

    TEST_CASE("a clip or a system, and not both") {
        const Scratch scratch;
        CHECK(program("view").status == 2);
        CHECK(program("view clip.bvh --system direct").status == 2);
        CHECK_FAILS_SAYING(program("view --system amp --screenshot " + (scratch / "x.png")), "amp", "moglow");
        CHECK_FAILS_SAYING(program("view --system direct --weights w --screenshot " + (scratch / "x.png")),
                           "--weights", "direct");
    }
}
