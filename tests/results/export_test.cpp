#include <SQLiteCpp/SQLiteCpp.h>
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "core/csv.hpp"
#include "core/files.hpp"
#include "csv_table.hpp"
#include "fixtures.hpp"
#include "results/copies/data_export.hpp"
#include "results/participants/participants.hpp"
#include "results/store/recording.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::contains;

namespace {

tests::CsvTable tableOf(const std::filesystem::path& file) {
    return tests::CsvTable(readFile(file).value());
}

const std::string formula = "=HYPERLINK(\"http://x\",\"y\")";

/// Two participants with every kind of answer, tracked frames, a note and a formula typed in.
void fillWide(const std::filesystem::path& path) {
    const auto study = fixtures::wideStudy();
    Store store = fixtures::open(path);
    for (const char* id : {"Anna7", "Bert3"}) {
        const auto plan = fixtures::widePlan(study, id);
        fixtures::store(store, study, plan);
        store.beginSession(fixtures::session(id, false));
        const auto keep = [&](const studies::SessionEvent& event) {
            store.record(event, study, plan, fixtures::clips(plan));
        };
        keep(studies::Note{studies::NoteKind::session_start, -1, {100.0, 1.7e9}, ""});
        keep(studies::Note{
            studies::NoteKind::operator_note, -1, {101.0, 1.7e9 + 1.0}, "wears Anna's glasses"});
        auto remark = fixtures::response(plan.trials[2]);
        remark.answers = {{"remark", -1, {}, formula}};
        keep(remark);
        auto age = fixtures::response(plan.trials[1]);
        age.answers = {{"age", -1, 31.0}, {"gender", -1, 2.0, "x"}};
        keep(age);
        auto choice = fixtures::answer(plan.trials[5], 1);
        choice.answers = {{"confidence", -1, 6.0}};
        keep(choice);
        auto load = fixtures::response(plan.trials[9]);
        load.answers = {{"effort", -1, 12.0}, {"calm", -1, 4.0}};
        keep(load);
        std::vector<TrackedFrame> frames;
        for (std::uint64_t i = 1; i <= 100; ++i) frames.push_back({fixtures::frame(i), 5});
        store.recordTracking(frames, {});
        store.endSession(studies::SessionOutcome::finished, 1.7e9 + 600.0);
    }
}

std::string everythingIn(const std::filesystem::path& folder) {
    std::string all;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        all += readFile(entry.path()).value();
    return all;
}

/// Bytes by name; throws where a folder is among the files.
std::map<std::string, std::string> filesIn(const std::filesystem::path& folder) {
    std::map<std::string, std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        out[entry.path().filename().string()] = readFile(entry.path()).value();
    return out;
}

}  // namespace

TEST_SUITE("results/export") {
    TEST_CASE("Every answer, participant, event and tracked frame comes out, and reads back as it was") {
        const fixtures::Folder folder;
        fillWide(folder / "a.sqlite");
        const auto files = exportCsv(folder / "a.sqlite", folder / "out", {});
        REQUIRE_MESSAGE(files, files.error().text());
        CHECK(std::set<std::string>(files->begin(), files->end()) ==
              std::set<std::string>{"responses.csv", "trials.csv", "sessions.csv", "events.csv",
                                    "participants.csv", "scores.csv", "questions.csv", "tracking.csv",
                                    "codebook.json"});
        const tests::CsvTable responses = tableOf(folder / "out/responses.csv");
        std::map<std::string, std::size_t> by_question;
        for (std::size_t i = 0; i < responses.rows.size(); ++i)
            if (responses.cell(i, "participant") == "Anna7") by_question[responses.cell(i, "question")] = i;
        REQUIRE(by_question.count("confidence") == 1);
        const std::size_t choice = by_question["confidence"];
        CHECK(responses.cell(choice, "value") == "6");
        CHECK(responses.cell(choice, "correct") == "1");
        CHECK(responses.cell(choice, "system") == "direct");
        CHECK(responses.cell(choice, "response_time_s") == "1.25");
        CHECK(responses.cell(choice, "ray_dz") == "-1");
        CHECK(responses.cell(by_question["remark"], "text") == "'" + formula);
        CHECK(responses.cell(choice, "measure") == "confidence");
        CHECK(responses.cell(choice, "scale_high") == "7");
        CHECK(responses.cell(choice, "balls") == "3");
        CHECK(responses.cell(choice, "group_style") == "calm");
        CHECK(responses.cell(choice, "field_age") == "31");
        const tests::CsvTable people = tableOf(folder / "out/participants.csv");
        REQUIRE(people.rows.size() == 2);
        CHECK(people.cell(0, "participant") == "Anna7");
        CHECK(people.cell(0, "number") == "7");
        CHECK(people.cell(0, "field_age") == "31");
        CHECK(people.cell(0, "field_gender") == "x");
        CHECK(people.cell(0, "group_style") == "calm");
        CHECK(people.cell(0, "answered") == "4");
        CHECK(people.cell(0, "planned") == "10");
        const tests::CsvTable scores = tableOf(folder / "out/scores.csv");
        REQUIRE(scores.rows.size() == 2);
        CHECK(scores.cell(0, "value") == "70");  // (12 + (20 - 4)) / 2 x 5
        const tests::CsvTable tracking = tableOf(folder / "out/tracking.csv");
        REQUIRE(tracking.rows.size() == 200);
        CHECK(std::stod(tracking.cell(9, "display_time_s")) == doctest::Approx(10.0 / 90.0).epsilon(1e-5));
        CHECK(std::stod(tracking.cell(9, "head_y_m")) == doctest::Approx(1.65).epsilon(1e-4));
        CHECK(tracking.cell(9, "aim_left_x_m").empty());
        CHECK(tracking.cell(9, "trial_index") == "5");
    }

    TEST_CASE(
        "The codebook describes every column of every file, and the same database gives the same bytes") {
        const fixtures::Folder folder;
        fillWide(folder / "a.sqlite");
        REQUIRE(exportCsv(folder / "a.sqlite", folder / "out", {}));
        REQUIRE(exportCsv(folder / "a.sqlite", folder / "again", {}));
        CHECK(everythingIn(folder / "out") == everythingIn(folder / "again"));
        const auto codebook = nlohmann::json::parse(readFile(folder / "out/codebook.json").value());
        int columns = 0;
        for (const auto& part : codebook["hasPart"]) {
            const tests::CsvTable table = tableOf(folder / "out" / part["name"].get<std::string>().c_str());
            CHECK(table.rows.size() == part["rows"].get<std::size_t>());
            REQUIRE(table.header.size() == part["variableMeasured"].size());
            for (std::size_t i = 0; i < table.header.size(); ++i) {
                CHECK(part["variableMeasured"][i]["name"] == table.header[i]);
                CHECK_FALSE(part["variableMeasured"][i]["description"].get<std::string>().empty());
                ++columns;
            }
        }
        CHECK(columns > 120);
    }

    TEST_CASE("An anonymised export names nobody, no time of day and no free text, and keeps the numbers") {
        const fixtures::Folder folder;
        fillWide(folder / "a.sqlite");
        ExportOptions options;
        options.anonymise = true;
        REQUIRE(exportCsv(folder / "a.sqlite", folder / "out", options));
        const std::string all = everythingIn(folder / "out");
        for (const char* secret : {"Anna", "Bert", "HYPERLINK", "glasses", "2023-11", "made by a test"})
            CHECK_MESSAGE(!contains(all, secret), secret);
        const tests::CsvTable people = tableOf(folder / "out/participants.csv");
        REQUIRE(people.rows.size() == 2);
        CHECK(people.cell(0, "participant") == "A001");
        CHECK(people.cell(1, "participant") == "A002");
        CHECK(people.cell(0, "field_age") == "31");
        CHECK(people.cell(0, "field_remark").empty());
        const tests::CsvTable events = tableOf(folder / "out/events.csv");
        CHECK(events.cell(0, "kind") == "session_start");
        CHECK(events.cell(0, "time_s") == "0");
        CHECK(events.cell(1, "time_s") == "1");
        CHECK(events.cell(1, "detail").empty());
    }

    TEST_CASE("Nothing but an earlier export is written over, and nothing is left of a failed one") {
        const fixtures::Folder folder;
        fillWide(folder / "a.sqlite");
        std::filesystem::create_directories(folder / "mine");
        REQUIRE(writeFile(folder / "mine/thesis.txt", "words"));
        const auto rejected = exportCsv(folder / "a.sqlite", folder / "mine", {});
        REQUIRE_FALSE(rejected);
        CHECK(contains(rejected.error().text(), "not empty"));
        CHECK_FALSE(exportCsv(folder / "none.sqlite", folder / "out", {}));
        CHECK_FALSE(std::filesystem::exists(folder / "out"));
        REQUIRE(exportCsv(folder / "a.sqlite", folder / "out", {}));
        ExportOptions without;
        without.tracking = false;
        REQUIRE(exportCsv(folder / "a.sqlite", folder / "out", without));
        CHECK_FALSE(std::filesystem::exists(folder / "out/tracking.csv"));
    }

    TEST_CASE(
        "An export that fails leaves the earlier one as it was, one that is killed does not block the next") {
        const fixtures::Folder folder;
        const auto database = folder / "a.sqlite";
        const auto out = folder / "out";
        fillWide(database);
        REQUIRE(exportCsv(database, out, {}));
        REQUIRE(writeFile(out / "notes.txt", "mine"));
        const auto whole = filesIn(out);
        std::filesystem::copy_file(database, folder / "damaged.sqlite");
        SQLite::Database((folder / "damaged.sqlite").string(), SQLite::OPEN_READWRITE)
            .exec("UPDATE tracking_blocks SET data = x'00'");
        CHECK_FALSE(exportCsv(folder / "damaged.sqlite", out, {}));
        CHECK(filesIn(out) == whole);
        CHECK_FALSE(exportCsv(folder / "damaged.sqlite", folder / "new", {}));
        CHECK_FALSE(std::filesystem::exists(folder / "new"));

        std::filesystem::remove(out / "notes.txt");
        const auto exported = filesIn(out);
        const auto killed = folder / "killed";
        int broken_off = 0;
        for (int i = 0; i < 12; ++i) {
            const pid_t child = ::fork();
            REQUIRE(child >= 0);
            if (child == 0)
                for (;;) (void)exportCsv(database, killed, {});
            ::usleep(3000U + 1700U * static_cast<unsigned>(i));
            ::kill(child, SIGKILL);
            ::waitpid(child, nullptr, 0);
            if (std::filesystem::exists(killed / ".export-under-way")) ++broken_off;
            const auto again = exportCsv(database, killed, {});
            REQUIRE_MESSAGE(again, again.error().text());
            CHECK(filesIn(killed) == exported);
        }
        CHECK(broken_off > 0);
    }

    TEST_CASE("What was done again stands in the export once, with the new answer") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        const auto plan = fixtures::plan(study, "P01", 1);
        {
            Store store = fixtures::open(folder / "a.sqlite");
            fixtures::store(store, study, plan);
            store.beginSession(fixtures::session("P01", false));
            store.record(fixtures::answer(plan.trials[1], 2), study, plan, fixtures::clips(plan));
            store.record(studies::Superseded{1, "the door opened", {50.0, 1.7e9 + 50.0}}, study, plan,
                         fixtures::clips(plan));
            store.record(fixtures::answer(plan.trials[1], 4), study, plan, fixtures::clips(plan));
        }
        REQUIRE(exportCsv(folder / "a.sqlite", folder / "out", {}));
        const tests::CsvTable responses = tableOf(folder / "out/responses.csv");
        REQUIRE(responses.rows.size() == 1);
        CHECK(responses.cell(0, "value") == "4");
    }

    TEST_CASE("Where the participant stood and what was to be seen are kept, replayed and exported") {
        const fixtures::Folder folder;
        const auto study = fixtures::study({"direct"});
        auto plan = fixtures::plan(study, "P01", 1);
        studies::Trial& beside = plan.trials[3];
        REQUIRE(beside.layout == "side-by-side");
        beside.seen = {{"side-by-side", studies::Standing::headset, {1.0, 0.957, 1.0}, {1.0, 1.0, 0.942}},
                       {"side-by-side", studies::Standing::desktop, {1.0, 0.3, 1.0}, {0.9, 1.0, 1.0}}};
        {
            Store store = fixtures::open(folder / "a.sqlite");
            fixtures::store(store, study, plan);
            store.beginSession(fixtures::session("P01", false));
            for (const int trial : {2, 3}) {
                auto choice = fixtures::answer(plan.trials[static_cast<std::size_t>(trial)], 1);
                if (trial == 3) choice.viewer = {0.75, -1.25, 20.0};
                store.record(choice, study, plan, fixtures::clips(plan));
            }
        }
        REQUIRE(exportCsv(folder / "a.sqlite", folder / "out", {}));
        const tests::CsvTable trials = tableOf(folder / "out/trials.csv");
        CHECK(trials.cell(2, "visibility").empty());
        CHECK(trials.cell(2, "min_seen_headset").empty());
        CHECK(trials.cell(3, "visibility") ==
              R"({"headset":{"at_rest":[1.0,0.957,1.0],"pointing":[1.0,1.0,0.942]},)"
              R"("desktop":{"at_rest":[1.0,0.3,1.0],"pointing":[0.9,1.0,1.0]}})");
        CHECK(trials.cell(3, "min_seen_headset") == "0.942");
        CHECK(trials.cell(3, "min_seen_desktop") == "0.3");
        const tests::CsvTable responses = tableOf(folder / "out/responses.csv");
        REQUIRE(responses.rows.size() == 2);
        CHECK(responses.cell(1, "viewer_x_m") == "0.75");
        CHECK(responses.cell(1, "viewer_z_m") == "-1.25");
        CHECK(responses.cell(1, "viewer_heading_deg") == "20");
        const auto replayed = loadRecording(folder / "a.sqlite", "P01");
        REQUIRE(replayed);
        REQUIRE(replayed->answers.size() == 2);
        CHECK(replayed->answers[1].trial.layout.name == "side-by-side");
        CHECK(replayed->answers[1].trial.layout.viewer_z_m == -1.25);
        CHECK(replayed->answers[1].trial.layout.heading_deg == 20.0);

        // From before it was kept: the layout's own place.
        SQLite::Database(folder / "a.sqlite", SQLite::OPEN_READWRITE)
            .exec(
                "UPDATE responses SET viewer_x_m = NULL, viewer_z_m = NULL, viewer_heading_deg = NULL, "
                "hash = NULL");
        const auto older = loadRecording(folder / "a.sqlite", "P01");
        REQUIRE(older);
        CHECK(older->answers[1].trial.layout.viewer_x_m == 0.5);
        CHECK(older->answers[1].trial.layout.viewer_z_m == 0.0);
        REQUIRE(exportCsv(folder / "a.sqlite", folder / "older", {}));
        CHECK(tableOf(folder / "older/responses.csv").cell(1, "viewer_x_m") == "0.5");
    }
}
