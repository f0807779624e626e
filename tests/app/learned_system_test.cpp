// Systems from weights, where nothing is trained: gt-nn keeps a manifest's demonstrations and plays the
// nearest.
#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>

#include "assets/tables/manifest.hpp"
#include "program.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;

TEST_SUITE("app/learned_system") {
    TEST_CASE("gt-nn plays the demonstrations that it was made of") {
        const Scratch scratch;
        const std::string targets = scratch / "targets.csv", weights = scratch / "w";
        spill(targets, "target_id,x,y,z\nA,0.8,1.2,1.7\nB,-0.6,0.5,1.9\n");
        REQUIRE(program("generate direct --targets " + targets + " -o " + (scratch / "shown")).status == 0);
        const std::string learn = "learn gt-nn --no-mirror --demonstrations " +
                                  (scratch / "shown/manifest.csv") + " --out " + weights;
        const auto done = program(learn);
        REQUIRE_MESSAGE(done.status == 0, done.err);
        CHECK(contains(done.out, "2 synthetic demonstrations: " + weights));
        CHECK_FAILS_SAYING(program(learn), weights, "--force");
        CHECK(program(learn + " --force").status == 0);

        REQUIRE(program("generate gt-nn --weights " + weights + " --targets " + targets + " -o " +
                        (scratch / "made"))
                    .status == 0);
        const auto shown = assets::readManifest(scratch / "shown/manifest.csv").value(),
                   made = assets::readManifest(scratch / "made/manifest.csv").value();
        REQUIRE(made.rows.size() == 2);
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(made.rows[i].system == "gt-nn");
            CHECK(made.rows[i].processing == "learned-from-synthetic");
            CHECK(made.rows[i].phases->peak_frame == shown.rows[i].phases->peak_frame);
            CHECK(made.rows[i].phases->hold_frame == shown.rows[i].phases->hold_frame);
        }
        const std::string page = scratch / "page.html";
        REQUIRE(program("evaluate " + (scratch / "made") + " -o " + page).status == 0);
        CHECK(contains(slurp(page), "gt-nn is made by formulas, or learned from demonstrations that were"));
    }

    TEST_CASE("weights that are no such, damaged, or of another system are rejected by name") {
        const Scratch scratch;
        const std::string targets = scratch / "targets.csv", weights = scratch / "w";
        spill(targets, "target_id,x,y,z\nA,0.8,1.2,1.7\n");
        const auto generate = [&](const std::string& system, const std::string& file) {
            return program("generate " + system + " --weights " + file + " --targets " + targets + " -o " +
                           (scratch / "made"));
        };
        REQUIRE(program("learn gt-nn -o " + weights).status == 0);
        CHECK_FAILS_SAYING(generate("moglow", weights), weights, "'gt-nn', expected those of 'moglow'");
        CHECK_FAILS_SAYING(generate("direct", weights), "--weights", "'direct' has no weights");
        CHECK_FAILS_SAYING(generate("gt-nn", targets), targets, "weights");
        CHECK_FAILS_SAYING(generate("gt-nn", scratch / "none"), "none");
        std::string bytes = slurp(weights);
        bytes[bytes.size() / 2] ^= 1;
        spill(weights, bytes);
        CHECK_FAILS_SAYING(generate("gt-nn", weights), weights, "checksum");
        CHECK_FALSE(fs::exists(scratch / "made"));
    }

    // Ten of the study's targets. What the whole hundred and the grid give is in docs/systems.md.
    TEST_CASE(
        "the systems that ship play by their names, point, and say that they have learned from synthetic") {
        const Scratch scratch;
        const auto targets = program("targets pointing2023");
        REQUIRE(targets.status == 0);
        std::size_t end = 0;
        for (int line = 0; line < 11; ++line) end = targets.out.find('\n', end) + 1;
        spill(scratch / "ten.csv", targets.out.substr(0, end));
        struct Shipped {
            const char* name;
            double least_reward;
        };
        std::string folders;
        const std::vector<Shipped> shipped{
            {"moglow", 0.45},     {"flow", 0.50},       {"amp-no-runtime", 0.45}, {"amp-base", 0.55},
            {"amp-pfnn-1", 0.55}, {"amp-pfnn-3", 0.55}, {"amp-pfnn-8", 0.55}};
        for (const Shipped& one : shipped) {
            const std::string folder = scratch / one.name;
            const auto done = program(std::string("generate ") + one.name + " --targets " +
                                      (scratch / "ten.csv") + " -o " + folder);
            REQUIRE_MESSAGE(done.status == 0, done.err);
            folders += " " + folder;
        }
        const auto evaluated = program("evaluate" + folders + " --json");
        REQUIRE(evaluated.status == 0);
        const auto numbers = nlohmann::json::parse(evaluated.out);
        for (const Shipped& one : shipped) {
            CAPTURE(one.name);
            const auto& systems = numbers["systems"];
            const auto found = std::find_if(systems.begin(), systems.end(),
                                            [&](const auto& system) { return system["system"] == one.name; });
            REQUIRE(found != systems.end());
            CHECK((*found)["accuracy"]["mean"].get<double>() > one.least_reward);
            CHECK(contains(slurp(scratch / one.name + "/manifest.csv"), "learned-from-synthetic"));
        }
    }

    // A few of the study's hundred targets: what the sanitizers watch takes long.
    TEST_CASE(
        "the paper's study plays the paper's systems, and its report says what they have learned from") {
        const Scratch scratch;
        std::string study = slurp(sourceDir() / "assets/data/studies/pointing2023.toml");
        study = replaced(study, "count = 100 ", "count = 9 ");
        study = replaced(study, "items = 5 ", "items = 2 ");
        study = replaced(study, "items = 10 ", "items = 2 ");
        spill(scratch / "study.toml", study);
        const std::string database = scratch / "s.sqlite";
        const auto done =
            program("simulate " + (scratch / "study.toml") + " --participants 2 --db " + database);
        REQUIRE_MESSAGE(done.status == 0, done.err);
        SQLite::Database stored(database);
        for (const char* name : {"gt-nn", "moglow", "amp-base", "amp-pfnn-8"}) {
            CAPTURE(name);
            SQLite::Statement shown(stored, "SELECT count(*) FROM trial_stimuli WHERE system = ?");
            shown.bind(1, name);
            REQUIRE(shown.executeStep());
            CHECK(shown.getColumn(0).getInt() >= 2 * (2 + 2));  // and those of practice
        }
        const auto report = program("report " + database + " --resamples 200 -o " + (scratch / "r.html"));
        REQUIRE_MESSAGE(report.status == 0, report.err);
        CHECK(contains(slurp(scratch / "r.html"), "synthetic"));
    }

    TEST_CASE("a program without trainers says how to get them") {
        const Scratch scratch;
        const auto done = program("learn amp-pfnn --bandwidth wide -o " + (scratch / "w"));
        CHECK(done.status == 2);
        CHECK(contains(done.err, "found 'wide', expected metres above 0, or scott"));
        CHECK(program("learn amp-pfnn -o " + (scratch / "w")).status == 2);
#ifndef DEIXIS_LEARNING
        CHECK_FAILS_SAYING(program("learn moglow -o " + (scratch / "w")), "built without what trains",
                           "scripts/install.sh learning");
#endif
    }
}
