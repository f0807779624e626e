// Several studies in one report: each by itself and pooled, or rejected with the reason.
#include "results/analysis/several_studies.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "answers_text.hpp"
#include "core/files.hpp"
#include "csv_table.hpp"
#include "fixtures.hpp"
#include "old_databases.hpp"
#include "oracles.hpp"
#include "page_text.hpp"
#include "results/answers/long_table.hpp"
#include "results/answers/stations.hpp"
#include "results/outputs/analysis_json.hpp"
#include "results/outputs/analysis_tables.hpp"
#include "results/report/report.hpp"
#include "text.hpp"
#include "xml.hpp"

using namespace deixis;
using namespace deixis::results;
using deixis::tests::close;
using deixis::tests::contains;
using deixis::tests::pageText;
using nlohmann::json;

namespace {

/// A study of its own name; `text`: CSV.
ResponseTable studyOf(const std::string& name, const std::string& text,
                      const LongTableOptions& options = {}) {
    const fixtures::Folder folder;
    REQUIRE(writeFile(folder / "answers.csv", text).has_value());
    ResponseTable table = loadAnswers(folder / "answers.csv", options).value();
    table.study_name = name;
    table.study_title = "Title of " + name;
    table.study_hash = name + std::string(64 - std::min<std::size_t>(64, name.size()), '0');
    table.database = name + ".sqlite";
    return table;
}

/// Two systems, `better` above the other one by one step for all of the participants but the first.
std::string ratingsOf(int participants, const std::string& systems = "a,b", int high = 5) {
    const std::string first = systems.substr(0, systems.find(','));
    const std::string second = systems.substr(systems.find(',') + 1);
    std::string out = "participant,system,item,measure,rating,scale_low,scale_high\n";
    for (int p = 1; p <= participants; ++p)
        for (int item = 1; item <= 2; ++item) {
            out += fmt::format("P{:02},{},T{},naturalness,{},1,{}\n", p, first, item, 2 + p % 2, high);
            out += fmt::format("P{:02},{},T{},naturalness,{},1,{}\n", p, second, item, p == 1 ? 1 : 3 + p % 2,
                               high);
        }
    return out;
}

std::string rejection(std::vector<ResponseTable> tables, const JoinChoice& choice = {}) {
    const auto joined = joinData(std::move(tables), choice);
    REQUIRE_FALSE(joined.has_value());
    return joined.error().text();
}

/// The tests of one family of pairs against R's, whichever system of a pair stands first.
void checkPairs(const std::vector<Comparison>& found, const json& expected, const std::string& family) {
    REQUIRE(found.size() == expected.size());
    for (const json& right : expected) {
        const std::string a = right["a"];
        const std::string b = right["b"];
        CAPTURE(a);
        CAPTURE(b);
        const auto one = std::find_if(found.begin(), found.end(), [&](const Comparison& pair) {
            return (pair.a == a && pair.b == b) || (pair.a == b && pair.b == a);
        });
        REQUIRE(one != found.end());
        CHECK(one->test.n_pairs == right["n"]);
        CHECK(close(one->test.p_two_sided, right["p"], 1e-9));
        CHECK(close(one->p_holm, right["p_holm"], 1e-9));
        CHECK(one->mean_difference * (one->a == a ? 1.0 : -1.0) ==
              doctest::Approx(right["mean"].get<double>()).epsilon(1e-9));
        CHECK(one->family == family);
        CHECK(one->family_size == 6);
    }
}

}  // namespace

TEST_SUITE("results/several_studies") {
    TEST_CASE("Each study, all pooled, studies against each other and medians in order, as R has them") {
        const json expected = tests::oracles("several_studies")[0];
        LongTableOptions scale;
        scale.scales["rating"] = {0.0, 100.0};
        const AnalysisResult result =
            analyse(joinData({studyOf("rushed", expected["csv"]["rushed"], scale),
                              studyOf("relaxed", expected["csv"]["relaxed"], scale)})
                        .value());
        REQUIRE(result.by_study.size() == 2);
        CHECK(result.participants == 24);
        CHECK(result.by_study[0].table.study_name == "relaxed");
        CHECK(result.by_study[0].participants == 14);
        CHECK(result.by_study[1].participants == 10);
        checkPairs(result.by_study[0].pairwise, expected["relaxed"], "rating: pairs of systems, in relaxed");
        checkPairs(result.by_study[1].pairwise, expected["rushed"], "rating: pairs of systems, in rushed");
        checkPairs(result.pairwise, expected["pooled"], "rating: pairs of systems, all studies pooled");

        REQUIRE(result.between.size() == 5);
        for (const BetweenResult& one : result.between) {
            CHECK(one.factor == "study");
            CHECK(one.a == "relaxed");
            CHECK(one.b == "rushed");
            if (one.system != "all")
                CHECK(close(one.test.p_two_sided, expected["between"][one.system], 1e-9));
        }
        REQUIRE(result.group_interactions.size() == 6);
        const std::vector<std::string> order{"REF", "AUTO", "SGT", "MANUAL"};
        for (const GroupInteractionResult& one : result.group_interactions) {
            std::size_t at = 0;
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = i + 1; j < 4; ++j, ++at)
                    if ((one.c == order[i] && one.d == order[j]) || (one.c == order[j] && one.d == order[i]))
                        CHECK(close(one.test.p_two_sided, expected["interaction"][at], 1e-9));
        }

        REQUIRE(result.medians.size() == 12);
        for (std::size_t i = 0; i < result.medians.size(); ++i) {
            const MedianResult& one = result.medians[i];
            const json& right = expected["medians"][one.study][one.system];
            CHECK(close(one.median, right["median"], 1e-12));
            CHECK(close(one.answers_median, right["ratings"], 1e-12));
            CHECK(one.place == static_cast<int>(i % 4) + 1);
            if (i % 4 > 0) CHECK(one.median <= result.medians[i - 1].median);
        }
        CHECK(result.medians[0].system == "REF");
        CHECK(result.medians[3].system == "AUTO");
        CHECK(result.medians[7].system == "MANUAL");
        CHECK(result.medians[11].study == "pooled");
    }

    TEST_CASE("Each study's numbers are those of its own report, and the order of the data changes no byte") {
        const ResponseTable one = studyOf("one", ratingsOf(8));
        const ResponseTable two = studyOf("two", ratingsOf(11));
        const AnalysisResult both = analyse(joinData({one, two}).value());
        for (const ResponseTable* table : {&one, &two}) {
            const AnalysisResult alone = analyse(*table);
            const AnalysisResult& here = both.by_study[table == &one ? 0 : 1];
            CHECK(here.pairwise[0].test.p_two_sided == alone.pairwise[0].test.p_two_sided);
            CHECK(here.pairwise[0].p_holm == alone.pairwise[0].p_holm);
            for (std::size_t i = 0; i < 2; ++i) {
                const Summary& found = here.systems[i].measures[0];
                const Summary& right = alone.systems[i].measures[0];
                CHECK(found.mean == right.mean);
                CHECK(found.interval->lower == right.interval->lower);
                CHECK(found.interval->upper == right.interval->upper);
            }
            CHECK(both.table.origins[table == &one ? 0 : 1].answers_hash == alone.answers_hash);
        }
        // One of each study prefers a, by two steps, all others b by one. Of 8 the ranks are seven 4 and an
        // 8, W+ = 8: 1 + 7 + 21 + 1 of 2^8 sign patterns give as little; of 11 likewise, 57 of 2^11. Pooled,
        // 17 ranks of 9 and two of 18.5, W+ = 37: (1 + 17 + 136 + 680 + 2380) + 2 (1 + 17 + 136) + 1.
        CHECK(both.by_study[0].pairwise[0].test.p_two_sided == 2.0 * 30.0 / 256.0);
        CHECK(both.by_study[1].pairwise[0].test.p_two_sided == 2.0 * 57.0 / 2048.0);
        CHECK(both.pairwise[0].test.p_two_sided == 2.0 * 3523.0 / 524288.0);
        const AnalysisResult turned = analyse(joinData({two, one}).value());
        CHECK(analysisJson(both) == analysisJson(turned));
        CHECK(renderReport(both) == renderReport(turned));
        CHECK(analysisTables(both, TableFormat::csv) == analysisTables(turned, TableFormat::csv));
    }

    TEST_CASE("P01 of one study is not P01 of another, and the page says so") {
        const ResponseTable table =
            joinData({studyOf("one", ratingsOf(3)), studyOf("two", ratingsOf(2))}).value();
        CHECK(table.rows.size() == 20);
        CHECK(table.rows.front().participant == "one/P01");
        CHECK(table.rows.front().target_id == "one/T1");
        CHECK(table.rows.back().participant == "two/P02");
        CHECK(table.groups.at("two/P01").at("study") == "two");
        const AnalysisResult result = analyse(table);
        CHECK(result.participants == 5);
        CHECK(result.pairwise[0].test.n_pairs == 5);
        const std::string page = renderReport(result);
        CHECK(contains(pageText(page),
                       "2 participants' names occur (P01, P02) in more than one study: they are treated as "
                       "different people"));
        CHECK(contains(page, "The data are from several studies: they are compared by study, as with --by"));
        const tests::XmlDocument document(page);
        CHECK(document.count(
                  "//h:b[.='In one'][starts-with(following-sibling::text()[1], ' (3 participants): ')]") ==
              1);
        CHECK(document.count("//h:b[.='Pooled'][starts-with(following-sibling::text()[1], "
                             "' over the 2 studies (5 participants): ')]") == 1);
        CHECK(contains(page, "No test of the studies against each other is significant in naturalness"));
        CHECK(contains(page, "Naturalness, all pairs of systems in two."));
        CHECK(contains(page, "Naturalness, all pairs of systems, all studies pooled."));
        CHECK(contains(page, "[[\\\"one\\\"],[\\\"two\\\"],[\\\"pooled\\\"]][indexof("));
        CHECK(contains(page, "study file (SHA-256) two0000"));
        const json out = json::parse(analysisJson(result));
        CHECK(out["by_study"][1]["data"][0]["people"] == 2);
        CHECK(out["by_study"][1]["data"][0]["schema_version"].is_null());
        CHECK(out["study_medians"][0]["study"] == "one");
        const auto inTable = [&](const char* file,
                                 const std::vector<std::pair<std::string, std::string>>& said) {
            return tests::CsvTable(fixtures::csvOf(result, file)).has(said);
        };
        CHECK(inTable("study_pairwise.csv",
                      {{"study", "two"}, {"measure", "naturalness"}, {"a", "a"}, {"b", "b"}}));
        CHECK(inTable("studies.csv", {{"study", "two"}, {"data", "two.sqlite"}, {"title", "Title of two"}}));
        CHECK(inTable("answers.csv", {{"participant", "two/P02"}, {"measure", "naturalness"}}));
        // Of one study nothing of this is there.
        const AnalysisResult alone = analyse(studyOf("one", ratingsOf(3)));
        CHECK(json::parse(analysisJson(alone))["by_study"].empty());
        CHECK(fixtures::csvOf(alone, "studies.csv").empty());
        CHECK_FALSE(contains(renderReport(alone), "pooled"));
    }

    TEST_CASE("An older database is read as it lies there, unchanged, and says which schema it has") {
        const fixtures::Folder folder;
        fixtures::makeVersion(2, folder / "old.sqlite");
        const auto before = readFile(folder / "old.sqlite").value();
        const ResponseTable old = loadResponses(folder / "old.sqlite").value();
        CHECK(old.schema_version == 2);
        ResponseTable other = old;
        other.study_name = "other";
        other.study_hash = "other";
        const AnalysisResult result = analyse(joinData({old, other}).value());
        REQUIRE(result.by_study.size() == 2);
        CHECK(result.table.origins[0].schema_version == 2);
        CHECK(contains(renderReport(result), "old.sqlite; schema 2; "));
        CHECK(result.participants == 2 * analyse(old).participants);
        CHECK(readFile(folder / "old.sqlite").value() == before);
    }

    TEST_CASE(
        "An unfinished study is told with what it lacks, and too few people with what they cannot show") {
        auto short_of = studyOf("short", ratingsOf(3));
        short_of.planned_answers = {{"P01", {{"naturalness", 4}}},
                                    {"P02", {{"naturalness", 4}}},
                                    {"P03", {{"naturalness", 4}}},
                                    {"P04", {{"naturalness", 4}}}};
        short_of.measures[0].planned = 16;
        const AnalysisResult result = analyse(joinData({studyOf("whole", ratingsOf(9)), short_of}).value());
        const auto told = [&](const std::string& text) {
            return std::count(result.remarks.begin(), result.remarks.end(), text);
        };
        CHECK(told("short: 12 of 16 planned on naturalness are answered.") == 1);
        CHECK(told("The data are incomplete: 48 of 52 planned on naturalness are answered.") == 1);
        CHECK(told("whole: 36 of 36 planned on naturalness are answered.") == 0);
        CHECK(
            told("1 of 1 tests (naturalness: pairs of systems, in short) cannot be significant at 0.01 after "
                 "Holm's correction, whatever the answers: they have too few non-zero differences.") == 1);
        CHECK(contains(renderReport(result), "study (short: 3 and whole: 9)"));
    }

    TEST_CASE("Three studies, one of two files: pairs of studies, and the files of each") {
        ResponseTable more = studyOf("two", ratingsOf(4));
        more.database = "two-more.sqlite";
        for (ResponseRow& row : more.rows) row.participant = "Q" + row.participant;
        const AnalysisResult result =
            analyse(joinData({more, studyOf("two", ratingsOf(3)), studyOf("one", ratingsOf(5)),
                              studyOf("three", ratingsOf(2))})
                        .value());
        REQUIRE(result.by_study.size() == 3);
        CHECK(result.by_study[2].table.study_name == "two");
        CHECK(result.by_study[2].participants == 7);
        CHECK(result.between.size() == 9);  // over all and of two systems, three pairs of studies
        CHECK(result.table.origins.size() == 4);
        CHECK(result.table.origins[3].data == "two.sqlite");
        CHECK(result.table.database == "one.sqlite, three.sqlite, two-more.sqlite, two.sqlite");
    }

    TEST_CASE("What studies do not share is rejected with the reason") {
        const auto one = studyOf("one", ratingsOf(3));
        CHECK(contains(
            rejection({one, studyOf("two", ratingsOf(3, "a,b", 100))}),
            "two.sqlite: \"naturalness\" is rated from 1 to 100, but from 1 to 5 in one (one.sqlite). "
            "Answers on different scales have no common mean"));
        CHECK(contains(rejection({one, studyOf("two", ratingsOf(3, "c,d"))}),
                       "two.sqlite: no system is in all studies: a, b in one (one.sqlite), c, d in two"));
        auto other = studyOf("two", ratingsOf(3));
        for (ResponseRow& row : other.rows) row.measure = "appropriateness";
        other.measures[0].name = "appropriateness";
        CHECK(contains(rejection({one, other}),
                       "two.sqlite: does not measure \"naturalness\", which one (one.sqlite) has. The two "
                       "have no measure in common: naturalness and appropriateness"));
        auto empty = studyOf("two", ratingsOf(3));
        empty.rows.clear();
        empty.scores.push_back({"P01", "load", "load", 3.0});
        CHECK(contains(rejection({one, empty}), "two.sqlite: has no answers yet on \"naturalness\""));
        auto strict = studyOf("two", ratingsOf(3));
        strict.alpha = 0.05;
        CHECK(contains(rejection({one, strict}), "is tested at alpha = 0.05, but one (one.sqlite) at 0.01"));
        CHECK(joinData({one, strict}, {false, 0.05, {}}).value().alpha == 0.05);
        auto version = studyOf("two", ratingsOf(3));
        version.study_name = "one";
        CHECK(contains(rejection({one, version}), "--by study compares its two versions as studies"));
        CHECK(studiesIn(joinData({one, version}, {true, {}, {}}).value()) ==
              std::vector<std::string>{"one (one00000)", "one (two00000)"});
        auto file = studyOf("two", ratingsOf(3));
        file.study_hash.clear();
        CHECK(contains(rejection({one, file}), "is not a database and names no study"));
        CHECK(joinData({one, file}, {true, {}, {}}).has_value());
        CHECK(contains(rejection({one}, {true, {}, {}}), "--by study: all data are from one study, one"));
        CHECK(contains(rejection({one, one}), "participant P01 is also in one.sqlite"));
        auto factor = studyOf("two", ratingsOf(3));
        factor.between.push_back({"study", {"x"}});
        CHECK(contains(rejection({one, factor}), "has its own factor \"study\""));
    }

    TEST_CASE(
        "A measure that one study lacks is passed over on request; systems that one lacks are left out") {
        const std::string more = "P01,a,T1,smoothness,2,1,5\nP01,b,T1,smoothness,3,1,5\n";
        const auto one = studyOf("one", ratingsOf(3) + more);
        const auto two = studyOf("two", ratingsOf(3));
        CHECK(contains(rejection({one, two}), "--measure naturalness"));
        CHECK(contains(rejection({one, two}, {false, {}, {"warmth"}}), "--measure: found \"warmth\""));
        const AnalysisResult result = analyse(joinData({one, two}, {false, {}, {"naturalness"}}).value());
        CHECK(result.measures.size() == 1);
        CHECK(result.table.rows.size() == 24);

        const auto third = studyOf("two", ratingsOf(3, "b,c"));
        const AnalysisResult shared = analyse(joinData({two, studyOf("more", ratingsOf(3, "b,c"))}).value());
        CHECK(shared.table.systems == std::vector<std::string>{"b"});
        CHECK(shared.between.size() == 2);
        CHECK(contains(shared.remarks[2], "more: not in all studies, and left out here (6 answers): c."));
    }

    TEST_CASE("People and simulated participants, or other stations, are no studies to compare") {
        auto one = studyOf("one", ratingsOf(3));
        auto two = studyOf("two", ratingsOf(3));
        for (ResponseRow& row : two.rows) row.synthetic = true;
        ResponseTable both = joinData({one, two}).value();
        CHECK(contains(
            checkStudiesMeet(both, true).error().text(),
            "no two studies have answers of the same kind: people in one, simulated participants in two"));
        // Where they are asked for all the same, the people's study stands alone.
        const AnalysisResult people = analyse(both);
        CHECK(people.by_study.empty());
        CHECK(people.participants == 3);
        CHECK(people.between.empty());
        for (ResponseRow& row : one.rows) row.station = "desktop";
        for (ResponseRow& row : two.rows) {
            row.station = "headset";
            row.synthetic = false;
        }
        both = joinData({one, two}).value();
        CHECK(contains(checkStudiesMeet(both, false).error().text(), "--stations together compares"));
        CHECK(checkStudiesMeet(both, true).has_value());
        const std::string remark =
            "All participants of a study have the same station, and not all studies do: no test can separate "
            "a difference between studies from one of station.";
        const auto confounded = analyse(withStations(both)).remarks;
        CHECK(std::count(confounded.begin(), confounded.end(), remark) == 1);
        for (ResponseRow& row : two.rows)
            if (row.participant == "P01") row.station = "desktop";
        const auto mixed = analyse(withStations(joinData({one, two}).value())).remarks;
        CHECK(std::count(mixed.begin(), mixed.end(), remark) == 0);
    }
}
