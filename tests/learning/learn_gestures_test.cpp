// deixis learn gestures, learn corpus and evaluate gestures, the real programs: a training of seconds, and
// what it made.
#include <nlohmann/json.hpp>

#include "app/program.hpp"
#include "text.hpp"

using namespace deixis::tests;

namespace {

/// As many words as a training takes, with vectors of three numbers.
std::string wordVectors(const Scratch& scratch) {
    const std::string file = scratch / "words.json";
    if (fs::exists(file)) return file;
    std::string words, vectors;
    for (int i = 0; i < 20000; ++i) {
        const std::string word = "w" + std::to_string(i);
        words += (i == 0 ? "\"" : ",\"") + word + "\"";
        vectors += (i == 0 ? "\"" : ",\"") + word + "\":[0.5," + std::to_string(i % 7) + ",-1,0.1," +
                   std::to_string(i) + "]";
    }
    spill(file, R"({"precision":8,"l2NormIndex":3,"wordIndex":4,"size":20000,"dimensions":3,"words":[)" +
                    words + R"(],"vectors":{)" + vectors + R"(},"unkVector":[0,0,0,0,-1]})");
    return file;
}

std::string learning(const Scratch& scratch, const std::string& more) {
    return "learn gestures --minutes 5 --hidden 16 --word-vectors " + wordVectors(scratch) + " " + more;
}

}  // namespace

TEST_SUITE("learning/gestures_command") {
    TEST_CASE("A short training tells its epochs, draws curves, and is evaluated beside a baseline") {
        const Scratch scratch;
        const std::string weights = scratch / "w", baseline = scratch / "b";
        const auto trained = program(learning(scratch, "--epochs 2 -o " + weights));
        CAPTURE(trained.out);
        REQUIRE_MESSAGE(trained.status == 0, trained.err);
        CHECK(contains(trained.out, "synthetic speeches"));
        CHECK(contains(trained.out, "vectors of 20000 words"));
        CHECK(contains(trained.out, "epoch   2: PCS "));
        CHECK(contains(trained.out, "the mean pose PCS "));
        CHECK_FALSE(fs::exists(weights + ".training"));
        const std::string csv = slurp(weights + ".curves.csv");
        CHECK(csv.starts_with("epoch,updates,huber,"));
        CHECK(contains(csv, "\n2,"));
        const std::string page = slurp(weights + ".curves.html");
        CHECK(contains(page, "Training of speech gestures"));
        CHECK(contains(page, "\"type\":\"log\""));
        CHECK_FAILS_SAYING(program(learning(scratch, "--epochs 2 -o " + weights)), weights,
                           "is there already", "--force");

        REQUIRE(program(learning(scratch, "--epochs 1 --no-controls -o " + baseline)).status == 0);
        const auto found = program("evaluate gestures " + weights + " --baseline " + baseline +
                                   " --minutes 12 -o " + (scratch / "page.html") + " --json " +
                                   (scratch / "n.json") + " --csv " + (scratch / "tables"));
        CAPTURE(found.out);
        REQUIRE_MESSAGE(found.status == 0, found.err);
        for (const char* text :
             {"rules A, unseen sentences (synthetic)", "rules B, unseen sentences (synthetic)", "  proposed ",
              "  baseline ", "  mean pose ", "published (Yoon et al. 2021", "26.768", "cannot be compared"})
            CHECK_MESSAGE(contains(found.out, text), text);
        const auto numbers = nlohmann::json::parse(slurp(scratch / "n.json"));
        const auto& models = numbers["sets"][0]["models"];
        REQUIRE(models.size() == 3);
        CHECK(models[0]["model"] == "proposed");
        CHECK(models[0]["exact_off_deg"].get<double>() < 0.01);
        CHECK(models[1]["pcs"].is_null());
        CHECK(models[2]["pcs"].get<double>() > 0.0);
        CHECK(numbers["published"][0]["pcs"] == 0.014);
        CHECK(contains(slurp(scratch / "tables/gesture_scores.csv"), "mean pose"));
        const std::string html = slurp(scratch / "page.html");
        for (const char* text : {"Synthetic:", "<svg", "one pose, speed -1", "published, TED"})
            CHECK_MESSAGE(contains(html, text), text);
    }

    TEST_CASE("What is missing or does not belong together is told by name") {
        const Scratch scratch;
        CHECK_FAILS_SAYING(
            program("learn gestures --word-vectors " + (scratch / "none") + " -o " + (scratch / "w")),
            scratch / "none", "fetch_word_vectors.sh");
        CHECK_FAILS_SAYING(
            program(learning(scratch, "--corpus " + (scratch / "nowhere") + " -o " + (scratch / "w"))),
            scratch / "nowhere", "");
        CHECK_FAILS_SAYING(program("evaluate gestures " + (scratch / "nowhere.weights")),
                           scratch / "nowhere.weights", "");
        spill(scratch / "text.weights", "hello");
        CHECK_FAILS_SAYING(program("evaluate gestures " + (scratch / "text.weights")),
                           scratch / "text.weights", "");
        CHECK(program("evaluate").status == 2);
        CHECK(program("learn gestures").status == 2);
    }

    TEST_CASE("A corpus is written as a folder, counted beside published figures, and read again") {
        const Scratch scratch;
        const std::string folder = scratch / "corpus";
        const auto made =
            program("learn corpus --minutes 2 --rules b -o " + folder + " --csv " + (scratch / "t"));
        REQUIRE_MESSAGE(made.status == 0, made.err);
        CHECK(contains(made.out, "rules B, synthetic"));
        CHECK(contains(made.out, "Shattuck-Hufnagel & Ren 2018"));
        CHECK(contains(slurp(scratch / "t/corpus.csv"), "strokes a minute"));
        CHECK(fs::exists(fs::path(folder) / "corpus.csv"));
        const auto read = program("learn corpus --corpus " + folder);
        REQUIRE_MESSAGE(read.status == 0, read.err);
        CHECK(contains(read.out, folder));
        CHECK_FAILS_SAYING(program("learn corpus --minutes 2 -o " + folder), folder, "--force");
    }
}
