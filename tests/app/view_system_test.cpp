// deixis view --system: a system that points at a ball, as a picture.
#include <filesystem>

#include "program.hpp"
#include "text.hpp"

using namespace deixis::tests;

TEST_SUITE("app/view_system") {
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
        // In place of ffmpeg, which takes a while to install: keeps what it is given, in the file that it
        // names.
        const auto film = [&](const std::string& ffmpeg, const std::string& file) {
            spill(scratch / "ffmpeg", "#!/bin/sh\nfor last; do :; done\n" + ffmpeg + "\n");
            std::filesystem::permissions(scratch / "ffmpeg", std::filesystem::perms::owner_all);
            return program("view --system direct --size 160x120 --mp4 " + (scratch / file),
                           "env PATH=" + scratch.path().string() + ":$PATH");
        };
        const auto done = film("cat >\"$last\"", "new/direct.mp4");
        REQUIRE_MESSAGE(done.status == 0, done.err);
        const std::string frames = slurp(scratch / "new/direct.mp4");
        constexpr std::size_t frame = 160 * 120 * 3;
        REQUIRE(frames.size() % frame == 0);
        const std::size_t count = frames.size() / frame;
        CHECK(count > 30);
        CHECK(contains(done.out, std::to_string(count) + " frames"));
        CHECK(frames.substr(0, frame) != frames.substr(frame * (count / 2), frame));
        CHECK_FAILS_SAYING(film("exit 1", "broken.mp4"), "broken.mp4", "ffmpeg could not write the film");
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
