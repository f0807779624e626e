// What observers read in the arms of a database's choices, and drift: the real program.
#include "program.hpp"

#include "csv_table.hpp"
#include "xml.hpp"

using namespace deixis::tests;
using nlohmann::json;

TEST_SUITE("app/report_observers") {
    TEST_CASE("A simulated study's page leads with the spread of observers; drift stands with the choices") {
        const Scratch scratch{WithSharedStimuli{}};
        REQUIRE(program("simulate pointing2023-stand-ins --participants 4 --db " + (scratch / "s.sqlite"))
                    .status == 0);
        const auto done = program("report " + (scratch / "s.sqlite") + " -o " + (scratch / "r.html") +
                                  " --json " + (scratch / "r.json") + " --csv " + (scratch / "tables"));
        REQUIRE_MESSAGE(done.status == 0, done.err);
        const json analysis = json::parse(slurp(scratch / "r.json"));
        REQUIRE(analysis["observers"].size() == 12);  // four systems, all layouts and each of two
        for (std::size_t s = 0; s < 4; ++s) {
            const json& all = analysis["observers"][3 * s];
            CAPTURE(all["system"].get<std::string>());
            CHECK(all["layout"] == "all");
            CHECK(all["trials"] == 40.0);
            // Forty choices of the two-cue observer lie about what is expected of it.
            const double expected = all["observers"]["two-cue"]["accuracy"].get<double>();
            const double found = analysis["systems"][s]["accuracy"]["mean"].get<double>();
            CHECK(std::abs(found - expected) < 4.0 * std::sqrt(expected * (1.0 - expected) / 40.0) + 0.02);
        }
        REQUIRE(analysis["drift"].size() == 8);
        for (const json& one : analysis["drift"]) {
            CHECK(one["choices"] == 40);
            if (one["system"] == "stiff") CHECK(one["moved"] == 0);
            if (one["system"] == "drifting") CHECK(one["moved"] > 0);
            CHECK(one["moved_first"].get<int>() + one["moved_last"].get<int>() <= one["moved"].get<int>());
        }
        const std::string page = slurp(scratch / "r.html");
        const std::size_t finding = page.find("What a simulated observer chooses after the same arms");
        CHECK(finding < page.find("has the highest"));
        CHECK(page.find("Choices and arms that keep moving") != std::string::npos);
        CHECK(page.find("reads two-cue, noise 3 degrees, lapses 0.02") != std::string::npos);
        int tables = 0;  // numbered as they stand
        for (const std::string& caption : XmlDocument(page).texts("//h:b[starts-with(., 'Table ')]"))
            CHECK(std::stoi(caption.substr(6)) == ++tables);
        CHECK(tables > 8);
        CHECK(analysis["observers"][1]["layout"] == "across");
        const CsvTable drift(slurp(scratch / "tables/drift.csv"));
        REQUIRE(drift.rows.size() == analysis["drift"].size());
        for (std::size_t i = 0; i < drift.rows.size(); ++i)
            CHECK(drift.cell(i, "moved_first") == analysis["drift"][i]["moved_first"].dump());

        // Alone, without what is locked beside it, the database tells the rest.
        fs::create_directories(scratch / "elsewhere");
        fs::copy_file(scratch / "s.sqlite", scratch / "elsewhere/s.sqlite");
        const auto alone = program("report " + (scratch / "elsewhere/s.sqlite") + " -o " +
                                   (scratch / "a.html") + " --json " + (scratch / "a.json"));
        REQUIRE_MESSAGE(alone.status == 0, alone.err);
        CHECK(json::parse(slurp(scratch / "a.json"))["observers"].empty());
        CHECK(slurp(scratch / "a.html").find("are left out: ") != std::string::npos);
        const auto named =
            program("report " + (scratch / "elsewhere/s.sqlite") + " --stimuli " + (scratch / "s.locked") +
                    " -o " + (scratch / "b.html") + " --json " + (scratch / "b.json"));
        REQUIRE_MESSAGE(named.status == 0, named.err);
        CHECK(json::parse(slurp(scratch / "b.json"))["observers"] == analysis["observers"]);
    }
}
