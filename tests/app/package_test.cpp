// A replication package, made by the real program, and used elsewhere.
#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

#include "lab_study.hpp"
#include "rounded_json.hpp"
#include "schema_check.hpp"
#include "text.hpp"

using namespace deixis::tests;
using nlohmann::json;

namespace {

/// Every file below a folder, by its name within.
std::map<std::string, std::string> filesIn(const fs::path& folder) {
    std::map<std::string, std::string> out;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            out[entry.path().lexically_relative(folder).string()] = slurp(entry.path());
    return out;
}

/// Whether the word stands anywhere, not as a part of another one: what draws the figures is full of letters.
bool holdsWord(const std::string& bytes, const std::string& word) {
    const auto isPart = [&](std::size_t at) {
        return at < bytes.size() && std::isalnum(static_cast<unsigned char>(bytes[at])) != 0;
    };
    for (auto at = bytes.find(word); at != std::string::npos; at = bytes.find(word, at + 1))
        if ((at == 0 || !isPart(at - 1)) && !isPart(at + word.size())) return true;
    return false;
}

/// Without what names people and files; lists of people in an order of their content.
json unnamed(json one) {
    if (one.is_array())
        for (json& part : one) part = unnamed(part);
    if (!one.is_object()) return one;
    for (auto& [key, part] : one.items()) {
        if (key == "participant" || key == "answers_hash" || key == "files" || key == "recorded_on")
            part = "";
        part = unnamed(part);
        const bool people =
            part.is_array() && !part.empty() && part[0].is_object() && part[0].contains("participant");
        if (people) std::sort(part.begin(), part.end());
    }
    return one;
}

/// A lab's study, its clips named by a whole path, with authors, and answers of six people of whom one is
/// excluded and one has withdrawn; an experimenter has typed remarks.
class LabWithPeople : public LabFolder {
  public:
    LabWithPeople() {
        std::string manifest = read("clips/manifest.csv");
        std::string authored;
        std::size_t line = 0;
        for (std::size_t at = 0; at < manifest.size(); ++line) {
            const std::size_t end = manifest.find('\n', at);
            authored +=
                manifest.substr(at, end - at) + (line == 0 ? ",author,trial\n" : ",Berta-Lindqvist,1\n");
            at = end + 1;
        }
        write("clips/manifest.csv", authored);
        change("study.toml", "manifest = \"clips/manifest.csv\"",
               "manifest = \"" + path("clips/manifest.csv") + "\"");
        REQUIRE(simulate(6).status == 0);
        REQUIRE(program("participants exclude " + path("study.sqlite") + " S003 --reason 'slept, says Karin'")
                    .status == 0);
        REQUIRE(program("participants withdraw " + path("study.sqlite") + " S004 --yes").status == 0);
        SQLite::Database database(path("study.sqlite"), SQLite::OPEN_READWRITE);
        database.exec(
            "INSERT INTO events (session, kind, trial_index, time_s, utc_s, detail) SELECT id, "
            "'operator_note', NULL, 1.0, started_utc_s + 1.0, 'has a cold, tells Karin' FROM sessions");
    }
};

Finished package(const LabFolder& lab, const std::string& more = "", const std::string& to = "package") {
    return program("package " + lab.path("study.sqlite") + " -o " + lab.path(to) + " " + more);
}

}  // namespace

TEST_SUITE("app/package") {
    TEST_CASE(
        "A package, moved away from all that it was made of, replays and reports the same numbers, and names "
        "nobody") {
        const Scratch elsewhere;
        const std::string moved = elsewhere / "osf";
        json original;
        std::vector<std::string> secrets{"S001", "S002", "S003", "S004", "S005", "S006"};
        {
            const LabWithPeople lab;
            const auto report = program("report " + lab.path("study.sqlite") + " -o " + lab.path("r.html") +
                                        " --json " + lab.path("r.json"));
            REQUIRE_MESSAGE(report.status == 0, report.err);
            original = json::parse(lab.read("r.json"));
            const auto made = package(lab);
            REQUIRE_MESSAGE(made.status == 0, made.err);
            CHECK(contains(made.out, "free-text"));
            CHECK(made.err == "");  // no file names a folder of this machine
            REQUIRE(package(lab, "", "again").status == 0);
            CHECK(filesIn(lab.path("package")) == filesIn(lab.path("again")));
            SQLite::Database database(lab.path("study.sqlite"), SQLite::OPEN_READONLY);
            SQLite::Statement tokens(database,
                                     "SELECT token FROM participants UNION SELECT token FROM withdrawals");
            while (tokens.executeStep()) secrets.push_back(tokens.getColumn(0).getString());
            secrets.push_back(database.execAndGet("SELECT locked_hash FROM study").getString());
            secrets.push_back(fs::path(lab.path("study.sqlite")).parent_path().string());
            fs::rename(lab.path("package"), moved);
        }
        for (const char* secret : {"Karin", "Lindqvist", "a cold", "slept"}) secrets.emplace_back(secret);
        REQUIRE(secrets.size() == 6 + 6 + 2 + 4);
        const auto files = filesIn(moved);
        for (const auto& file : files)
            for (const std::string& secret : secrets)
                CHECK_MESSAGE(!holdsWord(file.first + "\n" + file.second, secret),
                              file.first << ": " << secret);
        for (const char* name : {"README.md", "report.html", "analysis.json", "tables/pairwise.csv",
                                 "tables/analysis.R", "latex/pairwise.tex", "data/codebook.json"})
            CHECK_MESSAGE(files.contains(name), name);
        CHECK(shell("cd " + moved + " && sha256sum --quiet -c SHA256SUMS").status == 0);
        CHECK(shell("wc -l < " + moved + "/SHA256SUMS").out == std::to_string(files.size() - 1) + "\n");

        // The numbers.
        const json analysis = json::parse(files.at("analysis.json"));
        CHECK(analysis["participants"] == 4);
        CHECK(analysis["withdrawn"] == 1);
        CHECK(analysis["left_out"][0]["reason"] == "by the experimenter");
        CHECK(analysis["observers"].size() > 0);  // the clips are at hand
        original["left_out"][0]["reason"] = "by the experimenter";
        CHECK(unnamed(rounded(analysis)) == unnamed(rounded(original)));
        CHECK(schemaProblems("analysis", moved + "/analysis.json") == "");

        // Once more, by whoever has only the folder.
        REQUIRE(program("report " + moved + "/study.sqlite -o " + moved + "/again.html --json " + moved +
                        "/again.json")
                    .status == 0);
        CHECK(slurp(moved + "/again.json") == files.at("analysis.json"));
        CHECK(slurp(moved + "/again.html") == files.at("report.html"));
        for (const auto& person : analysis["answers_by_participant"]) {
            const auto replayed = program("replay " + moved + "/study.sqlite --choices --participant " +
                                          person["participant"].get<std::string>());
            CHECK_MESSAGE(replayed.status == 0, replayed.err);
            CHECK(contains(replayed.out, "6 choices: 6 the same"));
        }
        // And for somebody new, with whom 'run' goes on by what is locked.
        const auto plan = program("plan --db " + moved + "/study.sqlite --participant NEW01");
        CHECK_MESSAGE(plan.status == 0, plan.err);
        const std::string readme = files.at("README.md");
        for (const char* word : {"5 participants, 1 of them excluded", "1 withdrew", "**Synthetic**",
                                 "deixis 0", "6 texts by the experimenter"})
            CHECK_MESSAGE(contains(readme, word), word);
    }

    TEST_CASE("A package is whole or not there, and is written over nothing") {
        const LabFolder lab;
        REQUIRE(lab.simulate(2).status == 0);
        const auto before = filesIn(lab.path(""));
        lab.write("there/mine.txt", "mine");
        CHECK_FAILS_SAYING(package(lab, "", "there"), "there", "exists already");
        CHECK_FAILS_SAYING(program("package " + lab.path("none.sqlite") + " -o " + lab.path("new")),
                           "none.sqlite", "No such file");
        fs::remove_all(lab.path("there"));

        const fs::path clip = [&] {
            for (const auto& entry : fs::recursive_directory_iterator(lab.path("study.locked")))
                if (entry.path().extension() == ".bvh") return entry.path();
            return fs::path();
        }();
        const std::string bytes = slurp(clip);
        spill(clip, bytes + "\n");
        CHECK_FAILS_SAYING(package(lab), clip.filename().string(), "was changed");
        spill(clip, bytes);
        {
            SQLite::Database database(lab.path("study.sqlite"), SQLite::OPEN_READWRITE);
            database.exec(
                "CREATE TABLE kept AS SELECT locked_hash FROM study; UPDATE study SET locked_hash = NULL; "
                "UPDATE plans SET locked_hash = NULL");
        }
        CHECK_FAILS_SAYING(package(lab), "nothing of the study is locked", "deixis run STUDY --db");
        {
            SQLite::Database database(lab.path("study.sqlite"), SQLite::OPEN_READWRITE);
            database.exec(
                "UPDATE study SET locked_hash = (SELECT locked_hash FROM kept); UPDATE plans SET locked_hash "
                "= (SELECT locked_hash FROM kept); DROP TABLE kept; UPDATE answers SET value = 5 WHERE "
                "response = 1");
        }
        CHECK_FAILS_SAYING(package(lab), "this answer is not as it was written");
        std::set<std::string> names;
        for (const auto& [name, content] : before) names.insert(name);
        names.insert("study.locked/seen");
        for (const auto& file : filesIn(lab.path(""))) CHECK_MESSAGE(names.contains(file.first), file.first);
    }
}
