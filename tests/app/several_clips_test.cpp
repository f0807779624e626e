// Several clips stand for one system and item: each participant is shown one, and the answer keeps which.
#include <SQLiteCpp/SQLiteCpp.h>

#include <sstream>

#include "csv_table.hpp"
#include "lab_study.hpp"
#include "text.hpp"

using namespace deixis::tests;
using deixis::tests::contains;

namespace {

/// The rows of a manifest with author and trial, their clips found in `folder`.
std::string authored(const std::string& manifest, const std::string& folder, const std::string& author,
                     int trial) {
    std::istringstream lines(manifest);
    std::string line, out;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        out += folder + line + "," + author + "," + std::to_string(trial) + "\n";
    }
    return out;
}

std::string header(const std::string& manifest) {
    return manifest.substr(0, manifest.find('\n')) + ",author,trial\n";
}

int number(const LabFolder& lab, const std::string& query) {
    return SQLite::Database(lab.path("study.sqlite"), SQLite::OPEN_READONLY).execAndGet(query).getInt();
}

}  // namespace

TEST_SUITE("app/several_clips") {
    TEST_CASE("Two authors' clips: check tells of them, each rater has one, answers and exports keep whose") {
        const LabFolder lab;
        const auto made = program("generate stiff --targets " + lab.path("targets.csv") + " --out " +
                                  lab.path("clips/second"));
        REQUIRE_MESSAGE(made.status == 0, made.err);
        const std::string first = lab.read("clips/manifest.csv");
        std::string second = lab.read("clips/second/manifest.csv");
        for (auto at = second.find(",stiff,"); at != std::string::npos; at = second.find(",stiff,"))
            second.replace(at, 7, ",direct,");
        lab.write("clips/manifest.csv",
                  header(first) + authored(first, "", "A07", 1) + authored(second, "second/", "A11", 2));

        const auto checked = program("check " + lab.path("study.toml"));
        CHECK_MESSAGE(checked.status == 0, checked.err);
        CHECK(
            contains(checked.out, "clips: ours has 2 for 6 of 6 items; a participant is shown one of them"));

        const auto ran = lab.simulate(8);
        REQUIRE_MESSAGE(ran.status == 0, ran.err);
        const std::string of_ours =
            "FROM response_stimuli AS x JOIN responses AS r ON r.id = x.response JOIN trial_stimuli AS s ON "
            "s.participant = r.participant AND s.trial_index = r.trial_index AND s.position = x.position ";
        CHECK(number(lab, "SELECT count(DISTINCT author) " + of_ours + "WHERE s.system = 'ours'") == 2);
        CHECK(number(lab, "SELECT count(*) " + of_ours +
                              "WHERE s.system = 'builtin' AND author IS NOT NULL") == 0);
        // Author, trial and file go with the clip that the plan drew.
        CHECK(number(lab, "SELECT count(*) " + of_ours +
                              "WHERE s.system = 'ours' AND (s.clip, author, author_trial) "
                              "NOT IN (VALUES (0, 'A07', 1), (1, 'A11', 2))") == 0);
        CHECK(number(lab, "SELECT count(*) FROM (SELECT count(DISTINCT x.clip_hash) AS n " + of_ours +
                              "GROUP BY s.system, s.item, s.clip) WHERE n > 1") == 0);
        // One of them for each participant and item.
        CHECK(number(lab,
                     "SELECT max(n) FROM (SELECT count(DISTINCT clip) AS n FROM trial_stimuli GROUP BY "
                     "participant, system, item)") == 1);
        const auto planned = program("plan " + lab.path("study.toml") + " --participant S003 --json");
        const auto printed = nlohmann::json::parse(planned.out);
        const auto stored =
            nlohmann::json::parse(SQLite::Database(lab.path("study.sqlite"), SQLite::OPEN_READONLY)
                                      .execAndGet("SELECT json FROM plans WHERE participant = 'S003'")
                                      .getString());
        REQUIRE(printed["trials"].size() == stored["trials"].size());
        for (std::size_t i = 0; i < stored["trials"].size(); ++i)
            CHECK(printed["trials"][i]["stimuli"] == stored["trials"][i]["stimuli"]);

        // A further participant, by what was locked alone.
        REQUIRE(lab.run("P09", "", "").status == 0);
        const auto exported = program("export " + lab.path("study.sqlite") + " -o " + lab.path("data"));
        REQUIRE_MESSAGE(exported.status == 0, exported.err);
        const std::string responses = lab.read("data/responses.csv");
        CHECK(CsvTable(responses).has({{"clip", "1"}, {"author", "A11"}, {"author_trial", "2"}}));
        for (const auto& trial : CsvTable(lab.read("data/trials.csv")).having({{"kind", "referential-game"}}))
            CHECK_FALSE(trial.at("min_angle_avatar_deg").empty());
        // The report reads each choice's own arm, and a replay shows it.
        const auto report = program("report " + lab.path("study.sqlite") + " -o " + lab.path("r.html") +
                                    " --json " + lab.path("a.json"));
        CHECK_MESSAGE(report.status == 0, report.err);
        const auto analysis = nlohmann::json::parse(lab.read("a.json"));
        CHECK(analysis["observers"].size() > 0);
        int choices = 0;
        for (const auto& band : analysis["accuracy_by_angle"])
            if (band["eyes"] == "avatar" && band["system"] == "all") choices += band["choices"].get<int>();
        CHECK(choices == 9 * 6);
        CHECK(contains(lab.read("r.html"),
                       "Correct choices by the angle between target and nearest distractor"));
        // Ratings of clips of the authors' first trial against those of the second, of the one system that
        // has them.
        REQUIRE(analysis["author_trials"].size() == 1);
        const auto& learned = analysis["author_trials"][0];
        CHECK(learned["system"] == "ours");
        const std::string rated = of_ours +
                                  "JOIN answers AS a ON a.response = r.id WHERE a.question = 'rating' AND "
                                  "s.system = 'ours' AND x.author_trial = ";
        CHECK(learned["n_a"] == number(lab, "SELECT count(*) " + rated + "1"));
        CHECK(learned["n_b"] == number(lab, "SELECT count(*) " + rated + "2"));
        CHECK(learned["n_a"].get<int>() + learned["n_b"].get<int>() == 9 * 2);
        const auto& paired = analysis["author_trials_by_participants"][0];
        CHECK(paired["n"] ==
              number(lab, "SELECT count(*) FROM (SELECT r.participant " + of_ours +
                              "JOIN answers AS a ON a.response = r.id WHERE a.question = 'rating' "
                              "AND s.system = 'ours' GROUP BY r.participant HAVING count(DISTINCT "
                              "x.author_trial) = 2)"));
        CHECK(paired["n"].get<int>() > 0);
        CHECK(contains(lab.read("r.html"), "to see whether authors learn"));
        CHECK(program("replay " + lab.path("study.sqlite") + " --participant S003 --choices").status == 0);
    }
}
