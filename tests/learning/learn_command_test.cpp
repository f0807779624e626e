// deixis learn, the real program: a short training is stopped and goes on, is shared by two processes, and
// what it has made plays.
#include "app/program.hpp"
#include "text.hpp"

using namespace deixis::tests;

namespace {

/// Two demonstrations, of which one is trained on: a training of seconds.
std::string demonstrations(const Scratch& scratch) {
    spill(scratch / "targets.csv", "target_id,x,y,z\nA,0.8,1.2,1.7\nB,-0.6,0.5,1.9\n");
    REQUIRE(program("generate demonstration-nn --targets " + (scratch / "targets.csv") + " -o " +
                    (scratch / "clips"))
                .status == 0);
    return " --demonstrations " + (scratch / "clips/manifest.csv") + " --no-mirror";
}

Finished played(const Scratch& scratch, const std::string& weights) {
    return program("generate amp-base --weights " + weights + " --targets " + (scratch / "targets.csv") +
                   " -o " + (scratch / "made") + " --force");
}

/// Until the file is there, or for three minutes.
bool comes(const std::string& file) {
    for (int i = 0; i < 1800 && !fs::exists(file); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return fs::exists(file);
}

}  // namespace

TEST_SUITE("learning/command") {
    TEST_CASE("Ctrl-C leaves weights that play; the same command goes on, and ends with curves") {
        const Scratch scratch;
        const std::string weights = scratch / "w", command = "learn amp-base" + demonstrations(scratch) +
                                                             " -o " + weights +
                                                             " --updates 4 --validate-every 2";
        Background training(programFile() + " " + command + " >" + (scratch / "out") + " 2>&1");
        REQUIRE(comes(weights));
        training.kill(SIGINT);
        const std::string said = slurp(scratch / "out");
        CAPTURE(said);
        CHECK(contains(said, "1 synthetic demonstrations to train on, 1 held out"));
        CHECK(contains(said, "Stopped. " + weights + " holds the best so far"));
        CHECK(played(scratch, weights).status == 0);
        CHECK(contains(slurp(scratch / "made/manifest.csv"), "learned-from-synthetic"));

        const auto done = program(command);
        CHECK_MESSAGE(done.status == 0, done.err);
        CHECK(contains(done.out, "the training goes on"));
        CHECK(contains(done.out, "    4 of 4: Eq. 2 "));
        CHECK_FALSE(fs::exists(weights + ".training"));
        CHECK(played(scratch, weights).status == 0);
        const std::string csv = slurp(weights + ".curves.csv");
        for (const char* line : {"part,update,measure,value\n", "\n,0,held-out Eq. 2,",
                                 "\n,2,held-out jerk ratio,", "\n,4,task reward,", "\n,4,samples a second,"})
            CHECK_MESSAGE(contains(csv, line), line);
        CHECK(contains(slurp(weights + ".curves.html"), "Training of amp-base"));

        CHECK_FAILS_SAYING(program(command), weights, "is there already", "--force");
        const auto other = program("generate amp-pfnn-8 --weights " + weights + " --targets " +
                                   (scratch / "targets.csv") + " -o " + (scratch / "other"));
        CHECK_FAILS_SAYING(other, weights, "'amp-base', expected those of 'amp-pfnn-8'");
        std::string bytes = slurp(weights);
        bytes[bytes.size() / 2] ^= 1;
        spill(weights, bytes);
        CHECK_FAILS_SAYING(played(scratch, weights), weights, "checksum");
    }

    TEST_CASE("an observer or the line of eye and fingertip is rewarded where it is asked for") {
        const Scratch scratch;
        const std::string data = demonstrations(scratch);
        for (const std::string reward : {"eye-fingertip", "observer"}) {
            const std::string weights = scratch / reward;
            const auto done = program("learn amp-base" + data + " --reward " + reward + " -o " + weights +
                                      " --updates 2 --validate-every 2 --set cloning_updates=50");
            CHECK_MESSAGE(done.status == 0, done.err);
            const std::string name = reward == "observer" ? reward : "Eq. 2 by " + reward;
            CHECK(contains(done.out, "    2 of 2: " + name + " 0."));
            CHECK(contains(slurp(weights + ".curves.csv"), "\n,2,held-out " + name + ","));
            CHECK(contains(slurp(weights), "\"task\": \"" + reward + "\""));
            CHECK(played(scratch, weights).status == 0);
        }
        CHECK(program("learn amp-base --reward nose -o " + (scratch / "w")).status == 2);
    }

    TEST_CASE("flow learns of each demonstration once, in seconds, and what it has made points") {
        const Scratch scratch;
        const std::string weights = scratch / "w";
        const auto done = program("learn flow --updates 500 --validate-every 500 -o " + weights);
        CHECK_MESSAGE(done.status == 0, done.err);
        CHECK(contains(done.out, "48 synthetic demonstrations to train on, 4 held out"));
        CHECK_FALSE(fs::exists(weights + ".training"));
        CHECK(contains(slurp(weights + ".curves.csv"), "\n,500,spread drawn in cm,"));
        spill(scratch / "targets.csv", "target_id,x,y,z\nA,0.8,1.2,1.7\n");
        CHECK(program("generate flow --weights " + weights + " --targets " + (scratch / "targets.csv") +
                      " -o " + (scratch / "made"))
                  .status == 0);
        CHECK(program("learn flow --no-mirror -o " + weights).status == 2);
    }

    TEST_CASE(
        "two processes on the loopback share a training, and a rank without its place says what is missing") {
        const Scratch scratch;
        const std::string weights = scratch / "w", port = std::to_string(20000 + getpid() % 20000),
                          command = " " + programFile() + " learn amp-base" + demonstrations(scratch) +
                                    " -o " + weights + " --updates 1 --validate-every 1",
                          place =
                              "env GLOO_SOCKET_IFNAME=lo WORLD_SIZE=2 MASTER_ADDR=127.0.0.1 MASTER_PORT=" +
                              port;
        Background second(place + " RANK=1" + command + " >" + (scratch / "second") + " 2>&1");
        const auto first = shell(place + " RANK=0" + command);
        CHECK_MESSAGE(first.status == 0, first.err);
        CHECK(second.wait() == 0);
        CHECK(contains(first.out, "    1 of 1: Eq. 2 "));
        CHECK(slurp(scratch / "second").empty());
        CHECK(played(scratch, weights).status == 0);

        CHECK_FAILS_SAYING(shell("env WORLD_SIZE=2" + command), "RANK", "found ''", "0 to 1");
        CHECK_FAILS_SAYING(shell("env WORLD_SIZE=2 RANK=5" + command), "RANK", "found '5'");
    }
}
