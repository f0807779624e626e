// check, plan, simulate, participants, export, merge and replay --list: the real program on the studies that
// ship.
#include <map>
#include <set>

#include <SQLiteCpp/SQLiteCpp.h>

#include "csv_table.hpp"
#include "program.hpp"
#include "schema_check.hpp"
#include "text.hpp"

using namespace deixis::tests;
using deixis::tests::contains;

namespace {

std::vector<std::string> shippedStudies() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(sourceDir() / "assets/data/studies"))
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// Those that this build can show: speeches of projects need the studio's voices.
std::vector<std::string> playableStudies() {
    std::vector<std::string> names = shippedStudies();
#ifndef DEIXIS_STUDIO
    std::erase_if(names, [](const std::string& name) { return name.starts_with("sgtoolkit2021"); });
#endif
    return names;
}

/// A database of one or more simulated participants.
Finished simulated(const std::string& study, int participants, const std::string& database) {
    return program("simulate " + study + " --participants " + std::to_string(participants) + " --db " +
                   database + " --stimuli " + sharedStimuli());
}

int count(const std::string& database, const std::string& query) {
    return SQLite::Database(database, SQLite::OPEN_READONLY).execAndGet(query).getInt();
}

}  // namespace

TEST_SUITE("app/study_commands") {
    TEST_CASE("Every study that ships is checked without a problem, and its plan is printed the same twice") {
        CHECK(shippedStudies().size() >= 10);
        for (const std::string& study : shippedStudies()) {
            CAPTURE(study);
            const auto checked = program("check " + study);
            CHECK_MESSAGE(checked.status == 0, checked.err);
            CHECK(contains(checked.out, "no problem found"));
            CHECK(contains(
                checked.out,
                "language ko: the program's words are translated, not reviewed by a native speaker"));
            const auto plan = program("plan " + study + " --participant P07");
            CHECK(plan.status == 0);
            CHECK(plan.out == program("plan " + study + " --participant P07").out);
            CHECK(plan.out != program("plan " + study + " --participant P08").out);
        }
    }

    TEST_CASE("A folder of the same name does not hide a study that ships") {
        const Scratch scratch;
        fs::create_directories(scratch / "pointing2023");
        const auto checked =
            shell("cd " + scratch.path().string() + " && " + programFile() + " check pointing2023");
        INFO(checked.err);
        CHECK(checked.status == 0);
    }

    TEST_CASE("Every problem of a file is told at once, with line, key and proposal") {
        const Scratch scratch;
        std::string text = shippedStudy();
        text = replaced(text, "seed = 2023", "sead = 2023");
        text = replaced(text, "ball_diameter_m = 0.10", "ball_diameter_m = -1");
        text = replaced(text, "generator = \"stiff\"", "generator = \"stif\"");
        spill(scratch / "bad.toml", text);
        const auto checked = program("check " + (scratch / "bad.toml"));
        CHECK(checked.status == 1);
        CAPTURE(checked.err);
        CHECK(contains(checked.err, "sead"));
        CHECK(contains(checked.err, "seed"));
        CHECK(contains(checked.err, "ball_diameter_m"));
        CHECK(contains(checked.err, "problems"));
        const auto listed = program("check " + (scratch / "bad.toml") + " --json");
        CHECK(listed.status == 1);
        const auto problems = nlohmann::json::parse(listed.out).at("problems");
        CHECK(problems.size() == 3);
        for (const auto& problem : problems)
            CHECK(contains(checked.err, problem.at("where").get<std::string>() + ": " +
                                            problem.at("message").get<std::string>()));
    }

    TEST_CASE("What participants meet is told as JSON, as the plan has it") {
        const auto checked = nlohmann::json::parse(program("check pointing-style --json").out);
        CHECK(checked.at("problems").empty());
        std::map<std::string, int> told, planned;
        for (const auto& stage : checked.at("participants").at(0).at("stages"))
            told[stage.at("stage").get<std::string>()] = stage.at("trials").get<int>();
        const auto plan = nlohmann::json::parse(program("plan pointing-style --participant P1 --json").out);
        for (const auto& trial : plan.at("trials")) ++planned[trial.at("stage").get<std::string>()];
        std::erase_if(told, [](const auto& one) { return one.second == 0; });
        CHECK(told == planned);
    }

    TEST_CASE(
        "Every study that ships runs to its end with a simulated participant, each unit answered once") {
        for (const std::string& study : playableStudies()) {
            CAPTURE(study);
            const Scratch scratch;
            const std::string database = scratch / "study.sqlite";
            const auto ran = simulated(study, 2, database);
            REQUIRE_MESSAGE(ran.status == 0, ran.err);
            CHECK(count(database, "SELECT count(*) FROM sessions WHERE outcome IS NOT 'finished'") == 0);
            // Practice stops when its criterion is met; all else is answered.
            CHECK(count(database,
                        "SELECT count(*) FROM trials AS t WHERE NOT practice AND NOT EXISTS (SELECT 1 FROM "
                        "responses AS r WHERE r.participant = t.participant AND r.trial_index = "
                        "t.trial_index)") == 0);
            CHECK(count(database, "SELECT count(*) FROM responses WHERE status <> 'answered'") == 0);
            const auto report = program("report " + database + " -o " + (scratch / "report.html") +
                                        " --json " + (scratch / "analysis.json"));
            CHECK_MESSAGE(report.status == 0, report.err);
            CHECK(schemaProblems("analysis", scratch / "analysis.json") == "");
            const auto analysis = nlohmann::json::parse(slurp(scratch / "analysis.json"));
            CHECK(analysis["synthetic"] == true);
            CHECK(analysis["participants"] == 2);
            for (const auto& system : analysis["systems"])
                for (const auto& measure : analysis["measures"])
                    if (measure["kind"] != "preference")
                        CHECK(system[measure["measure"].get<std::string>()]["n"].get<int>() > 0);
        }
    }

    TEST_CASE(
        "30 raters of four systems on a page give the counts of Yoon et al.: 12 pages of 4, two attention "
        "checks apart, and "
        "who "
        "fails one ends there") {
        const Scratch scratch;
        const std::string database = scratch / "raters.sqlite";
        const auto ran =
            simulated((sourceDir() / "tests/studies/fixtures/parallel_rating.toml").string(), 30, database);
        REQUIRE_MESSAGE(ran.status == 0, ran.err);
        const std::string pages = "FROM trials WHERE kind = 'parallel-rating' AND NOT practice";
        CHECK(count(database, "SELECT count(*) " + pages) == 30 * 12);
        CHECK(count(database, "SELECT count(*) " + pages + " AND check_kind = 'number'") == 30 * 2);
        // Ratings: 4 a page; the check takes the place of one of them.
        CHECK(
            count(
                database,
                "SELECT count(*) FROM answers AS a JOIN responses AS r ON r.id = a.response JOIN trials AS t "
                "USING (participant, trial_index) WHERE t.kind = 'parallel-rating' AND NOT t.practice AND "
                "a.question = 'rating'") == 30 * 48);
        CHECK(count(database,
                    "SELECT count(*) FROM trial_stimuli WHERE scored AND trial_index IN (SELECT trial_index "
                    "FROM trials AS t WHERE t.participant = trial_stimuli.participant AND kind = "
                    "'parallel-rating')") == 30 * 46);
        const auto report =
            program("report " + database + " -o " + (scratch / "r.html") + " --json " + (scratch / "a.json"));
        REQUIRE(report.status == 0);
        const auto analysis = nlohmann::json::parse(slurp(scratch / "a.json"));
        int ratings = 0;
        for (const auto& system : analysis["systems"])
            ratings += system[analysis["measures"][0]["measure"].get<std::string>()]["n"].get<int>();
        const int left_out = static_cast<int>(analysis["left_out"].size());
        CHECK(ratings == (30 - left_out) * 46);
        CHECK(analysis["checks"][0]["passed"].get<int>() + analysis["checks"][0]["failed"].get<int>() == 60);

        // The paper's unit, which the study asks for: pages on which both movements were rated, no check in
        // the place of either. It passes what means of 30 people can reach.
        const std::string both =
            "FROM trial_stimuli AS a JOIN trial_stimuli AS b USING (participant, trial_index) JOIN responses "
            "AS r USING (participant, trial_index) JOIN participants AS p ON p.id = r.participant WHERE "
            "r.superseded IS NULL AND p.status = 'active' AND a.scored AND b.scored AND a.system = '{}' AND "
            "b.system = '{}'";
        double max = 0.0;
        REQUIRE(analysis["pairwise_ratings"].size() == 6);
        for (const auto& pair : analysis["pairwise_ratings"]) {
            const std::string a = pair["a"], b = pair["b"];
            CHECK(count(database, "SELECT count(*) " + replaced(replaced(both, "{}", a), "{}", b)) ==
                  pair["n"].get<int>());
            CHECK(pair["n"].get<int>() + pair["n_missing"].get<int>() == (30 - left_out) * 12);
            CHECK(pair["participants"] == 30 - left_out);
            max = std::max(max, std::abs(pair["z"].get<double>()));
        }
        CHECK(max > 6.83);
        for (const auto& pair : analysis["pairwise"]) CHECK(std::abs(pair["z"].get<double>()) < 4.79);
        CHECK(contains(slurp(scratch / "r.html"), "again by single ratings"));
        REQUIRE(program("report " + database + " --unit participants -o " + (scratch / "r.html")).status ==
                0);
        CHECK_FALSE(contains(slurp(scratch / "r.html"), "again by single ratings"));
    }

    TEST_CASE("Participants are listed, excluded, taken back and withdrawn") {
        const Scratch scratch;
        const std::string database = scratch / "study.sqlite";
        REQUIRE(simulated("genea-pairwise", 3, database).status == 0);
        auto listed = program("participants list " + database);
        CHECK(contains(listed.out, "S002"));
        CHECK(contains(listed.out, "3 participants, "));
        CHECK_FAILS_SAYING(program("participants show " + database + " S009"), "S009");
        CHECK(contains(program("participants show " + database + " S002").out, "session"));
        CHECK(program("participants exclude " + database + " S002").status == 2);
        CHECK(program("participants exclude " + database + " S002 --reason 'fell asleep'").status == 0);
        CHECK(contains(program("participants list " + database).out, "(fell asleep)"));
        const auto numbers = nlohmann::json::parse(program("participants list " + database + " --json").out);
        CHECK(numbers.at("participants").size() == 3);
        const auto& second = numbers.at("participants").at(1);
        CHECK(second.at("participant") == "S002");
        CHECK(second.at("status") == "excluded");
        CHECK(second.at("reason") == "fell asleep");
        CHECK(numbers.at("participants").at(0).at("reason").is_null());
        CHECK(
            second.at("answered") ==
            count(database, "SELECT count(DISTINCT trial_index) FROM responses WHERE participant = 'S002'"));
        const auto one = nlohmann::json::parse(program("participants show " + database + " S002 --json").out);
        CHECK(one.at("planned") == second.at("planned"));
        CHECK(one.at("fields").at("age").get<std::string>() ==
              SQLite::Database(database, SQLite::OPEN_READONLY)
                  .execAndGet(
                      "SELECT CAST(value AS INTEGER) FROM participant_fields WHERE participant = 'S002' "
                      "AND field = 'age'")
                  .getString());
        REQUIRE(program("report " + database + " -o " + (scratch / "r.html")).status == 0);
        CHECK(contains(slurp(scratch / "r.html"), "fell asleep"));
        CHECK(program("participants include " + database + " S002").status == 0);
        CHECK_FALSE(contains(program("participants list " + database).out, "fell asleep"));
        CHECK_FAILS_SAYING(program("participants withdraw " + database + " S002"), "--yes");
        CHECK(contains(slurp(database), "S002"));
        CHECK(program("participants withdraw " + database + " S002 --yes").status == 0);
        CHECK_FALSE(contains(slurp(database), "S002"));
        CHECK(
            contains(program("participants list " + database).out, "trials and pages answered, 1 withdrawn"));
    }

    TEST_CASE("Tables are written with their codebook, and stations' databases joined") {
        const Scratch scratch;
        const std::string database = scratch / "study.sqlite";
        REQUIRE(simulated("pointing2023-stand-ins", 2, database).status == 0);
        const auto written = program("export " + database + " --format csv -o " + (scratch / "csv"));
        REQUIRE_MESSAGE(written.status == 0, written.err);
        for (const char* file :
             {"responses.csv", "trials.csv", "participants.csv", "events.csv", "codebook.json"})
            CHECK(fs::exists(scratch / (std::string("csv/") + file)));
        // What the game declares to keep of a trial are columns, as in its view.
        const CsvTable trials(slurp(scratch / "csv/trials.csv"));
        int places = 0, with_place = 0;
        for (std::size_t i = 0; i < trials.rows.size(); ++i)
            if (const std::string& place = trials.cell(i, "target_place"); !place.empty()) {
                places += std::stoi(place);
                ++with_place;
                CHECK(trials.cell(i, "balls").starts_with("[["));
                CHECK(trials.cell(i, "distractors").starts_with("[["));
            }
        CHECK(with_place == count(database, "SELECT count(*) FROM game_trials"));
        CHECK(places == count(database, "SELECT sum(target_place) FROM game_trials"));
        const auto shared = program("export " + database + " --anonymise -o " + (scratch / "shared"));
        REQUIRE(shared.status == 0);
        CHECK_FALSE(contains(slurp(scratch / "shared/responses.csv"), "S001"));
        const auto rejected = program("merge " + database + " " + (scratch / "none.sqlite") + " -o " +
                                      (scratch / "all.sqlite"));
        CHECK(rejected.status == 1);
        CHECK(contains(rejected.err, "none.sqlite"));
        CHECK_FALSE(fs::exists(scratch / "all.sqlite"));
        fs::copy_file(database, scratch / "copy.sqlite");
        CHECK(
            program("merge " + database + " " + (scratch / "copy.sqlite") + " -o " + (scratch / "all.sqlite"))
                .status == 0);
        CHECK(count(scratch / "all.sqlite", "SELECT count(*) FROM participants") == 2);
    }

    TEST_CASE("The trials of a recorded session are listed, and its choices follow from the recorded rays") {
        const Scratch scratch;
        const std::string database = scratch / "study.sqlite";
        REQUIRE(simulated("pointing2023-stand-ins", 1, database).status == 0);
        const auto listed = program("replay " + database + " --participant S001 --list");
        CHECK(listed.status == 0);
        CHECK(contains(listed.out, "chose ball"));
        CHECK(contains(listed.out, "rating"));
        const auto choices = program("replay " + database + " --participant S001 --choices");
        CHECK_MESSAGE(choices.status == 0, choices.err);
        CHECK(contains(choices.out, "42 choices: 42 the same"));
        CHECK_FAILS_SAYING(program("replay " + database + " --participant S004 --list"), "S004");
        const auto moved =
            program("replay " + database + " --participant S001 --choices --stimuli " + sharedStimuli());
        CHECK(moved.status == 0);
    }
}
