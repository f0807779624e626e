// deixis view --system: a system that points at a ball, as a picture.
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

    TEST_CASE("a clip or a system, and not both") {
        const Scratch scratch;
        CHECK(program("view").status == 2);
        CHECK(program("view clip.bvh --system direct").status == 2);
        CHECK_FAILS_SAYING(program("view --system amp --screenshot " + (scratch / "x.png")), "amp", "moglow");
        CHECK_FAILS_SAYING(program("view --system direct --weights w --screenshot " + (scratch / "x.png")),
                           "--weights", "direct");
    }
}
