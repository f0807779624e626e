// scripts/reproduce.sh with the weights that come with the program, on few points and few participants.
#include "app/program.hpp"
#include "text.hpp"

using namespace deixis::tests;

namespace {

Finished reproduce(const std::string& arguments) {
    return shell((sourceDir() / "scripts/reproduce.sh").string() + " " + arguments);
}

}  // namespace

TEST_SUITE("learning/reproduce") {
    TEST_CASE("the whole paper, once: a page with every part; again it is there already") {
        const Scratch scratch;
        const std::string folder = scratch / "out", all = "--quick --program " + programFile() +
                                                          " --grid 8 --participants 3 -o " + folder;
        const auto made = reproduce(all);
        CAPTURE(made.out);
        REQUIRE_MESSAGE(made.status == 0, made.err);
        const std::string page = slurp(fs::path(folder) / "reproduction.html");
        for (const char* part :
             {"What agrees and what does not", "Objective evaluation", "The study", "Demonstrations",
              "What was trained", "Systems in order of Equation 2.", "box grid", "spherical grid", "two-cue",
              "arm-finger", "eye-fingertip", "all participants are simulated", "<svg", "amp-no-runtime",
              "peak speed of the hand"})
            CHECK_MESSAGE(contains(page, part), part);
        // The study shows the clips that were evaluated.
        CHECK(contains(slurp(fs::path(folder) / "pointing2023.toml"),
                       "manifest = \"study/amp-pfnn-8/manifest.csv\""));
        CHECK(contains(slurp(fs::path(folder) / "two-cue.html"), "Beside the objective evaluation"));

        const auto before = fs::last_write_time(fs::path(folder) / "box.json");
        const auto again = reproduce(all);
        CHECK(again.status == 0);
        CHECK(fs::last_write_time(fs::path(folder) / "box.json") == before);
        CHECK(slurp(fs::path(folder) / "reproduction.html") == page);
    }

    TEST_CASE("options that are none are rejected with those that there are") {
        for (const char* wrong : {"--slow", "--grid", "-o"}) {
            const auto rejected = reproduce(wrong);
            CHECK(rejected.status == 2);
            CHECK(contains(rejected.err, "--participants N"));
        }
    }
}
