// deixis plan --db: the plan that a database holds, or that its next session would store.
#include <SQLiteCpp/SQLiteCpp.h>

#include <map>

#include "lab_study.hpp"
#include "text.hpp"

using namespace deixis::tests;

namespace {

Finished planIn(const LabFolder& lab, const std::string& more) {
    return program("plan --db " + lab.path("study.sqlite") + " " + more);
}

/// As the database keeps it: without what is added for scripts.
nlohmann::ordered_json plan(const LabFolder& lab, const std::string& participant) {
    const auto printed = planIn(lab, "--json --participant " + participant);
    REQUIRE_MESSAGE(printed.status == 0, printed.err);
    auto out = nlohmann::ordered_json::parse(printed.out);
    CHECK(out["schema"]["name"] == "deixis-plan");
    out.erase("schema");
    for (auto& trial : out["trials"])
        for (const char* twice : {"system", "target_id"}) trial.erase(twice);
    return out;
}

nlohmann::ordered_json stored(const LabFolder& lab, const std::string& participant) {
    SQLite::Database database(lab.path("study.sqlite"), SQLite::OPEN_READONLY);
    SQLite::Statement row(database, "SELECT json FROM plans WHERE participant = ?");
    row.bind(1, participant);
    REQUIRE(row.executeStep());
    return nlohmann::ordered_json::parse(row.getColumn(0).getString());
}

/// Every file of the lab's folder but the memory of hashes.
std::map<std::string, std::string> contents(const LabFolder& lab) {
    std::map<std::string, std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(lab.path("")))
        if (entry.is_regular_file() && entry.path().filename() != "seen")
            out[entry.path().string()] = slurp(entry.path());
    return out;
}

}  // namespace

TEST_SUITE("app/plan_database") {
    TEST_CASE(
        "The plan in a database is the stored one, or the one that the next session stores; nothing is "
        "changed") {
        const LabFolder lab;
        REQUIRE(lab.simulate().status == 0);
        // Whatever became of the files.
        lab.change("study.toml", "items = 3", "items = 4");
        fs::remove_all(lab.path("clips"));
        const auto kept = stored(lab, "S001");
        const auto before = contents(lab);
        CHECK(plan(lab, "S001") == kept);
        const auto next = plan(lab, "anna");
        CHECK(next["number"] == 2);
        CHECK(plan(lab, "P07")["number"] == 7);
        CHECK(contents(lab) == before);
        const auto ran = lab.run("anna", "", "");
        REQUIRE_MESSAGE(ran.status == 0, ran.err);
        CHECK(stored(lab, "anna") == next);
        CHECK(plan(lab, "anna") == next);
    }

    TEST_CASE("What cannot be planned from a database is told") {
        const LabFolder lab;
        CHECK_FAILS_SAYING(planIn(lab, "--participant P02"), "study.sqlite", "no such file");
        CHECK(program("plan --participant P02").status == 2);
        CHECK(planIn(lab, "study.toml --participant P02").status == 2);
        CHECK(planIn(lab, "--participant P02 --group a=b").status == 2);
        REQUIRE(lab.simulate().status == 0);
        CHECK_FAILS_SAYING(planIn(lab, "--participant P02 --number 1"), "--number",
                           "1 is the number of another");
        CHECK_FAILS_SAYING(planIn(lab, "--participant S001 --number 2"), "--number",
                           "S001 takes part with the number 1");
        fs::remove_all(lab.path("study.locked"));
        CHECK(planIn(lab, "--participant S001").status == 0);
        CHECK_FAILS_SAYING(planIn(lab, "--participant P02"), "not there", "from a copy");
    }
}
