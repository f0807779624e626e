// The R script that deixis report writes: R itself computes the tables again.
#include "core/random.hpp"
#include "csv_table.hpp"
#include "program.hpp"
#include "text.hpp"

using namespace deixis::tests;

namespace {

/// Whether R is here; says so where it is not.
bool hasR() {
    if (shell("Rscript --version").status == 0) return true;
    tellSkipped("Rscript is not here");
    return false;
}

/// Three systems, rated and played with by 24 people; every tenth answer is missing.
std::string unevenAnswers() {
    deixis::Random random(11);
    std::string out = "participant,measure,system,layout,item,order,correct,rating,rt\n";
    for (int p = 7; p < 31; ++p) {
        const std::string person = p < 10 ? "00" + std::to_string(p) : "0" + std::to_string(p);
        int order = 0;
        for (const std::string system : {"stiff", "fluent", "sudden"})
            for (int item = 1; item <= 4; ++item) {
                const int better = system == "stiff" ? 0 : 1;
                const std::string layout = item % 2 == 0 ? "across" : "side-by-side";
                const auto start = [&](const std::string& measure) {
                    return person + "," + measure + "," + system + "," + layout + ",T" +
                           std::to_string(item) + "," + std::to_string(++order) + ",";
                };
                const std::string rt = "," + std::to_string(random.uniform(0.5, 2.5)) + "\n";
                if (random.uniform(0.0, 1.0) > 0.1)
                    out += start("accuracy") + (random.uniform(0.0, 1.0) < 0.6 + 0.3 * better ? "1" : "0") +
                           "," + rt;
                if (random.uniform(0.0, 1.0) > 0.1)
                    out += start("naturalness") + "," +
                           std::to_string(1 + better + static_cast<int>(random.uniform(0.0, 3.999))) + rt;
            }
    }
    return out;
}

/// Ratings from 0 to 100 of two measures by 14 people, all of them there. In "smoothness" all people have the
/// same mean.
std::string manySteps() {
    deixis::Random random(12);
    std::string out = "participant,measure,system,item,rating\n";
    for (int p = 0; p < 14; ++p) {
        const double own = random.uniform(-15.0, 15.0);
        int place = 0;
        for (const std::string system : {"stiff", "fluent", "sudden"})
            for (int item = 1; item <= 5; ++item) {
                const auto add = [&](const std::string& measure, int rating) {
                    out += "P" + std::to_string(10 + p) + "," + measure + "," + system + ",T" +
                           std::to_string(item) + "," + std::to_string(rating) + "\n";
                };
                add("naturalness", 50 + (system == "fluent" ? 12 : 0) + 5 * item + static_cast<int>(own) +
                                       static_cast<int>(random.uniform(-20.0, 20.0)));
                add("smoothness", 30 + 3 * ((place++ + 2 * p) % 15));
            }
    }
    return out;
}

/// What stands in front of " numbers compared".
int compared(const std::string& said) {
    const auto end = said.find(" numbers compared");
    if (end == std::string::npos) return 0;
    const auto begin = said.rfind('\n', end);
    return std::stoi(said.substr(begin == std::string::npos ? 0 : begin + 1));
}

/// The answers' report with its analysis.R, as that ends.
Finished analysedByR(const Scratch& scratch, const std::string& answers, const std::string& options = "") {
    spill(scratch / "lab.csv", answers);
    const auto made = program("report " + (scratch / "lab.csv") + " -o " + (scratch / "page.html") + " --r " +
                              (scratch / "r") + " " + options);
    REQUIRE_MESSAGE(made.status == 0, made.err);
    CHECK(contains(made.out, "analysis.R"));
    Finished done = shell("Rscript " + (scratch / "r/analysis.R"));
    CHECK_MESSAGE(done.status == 0, done.out, done.err);
    return done;
}

}  // namespace

TEST_SUITE("app/report_r") {
    TEST_CASE(
        "R finds the same numbers in uneven answers, adds mixed models, and names a number that is off") {
        if (!hasR()) return;
        const Scratch scratch;
        const auto done = analysedByR(scratch, unevenAnswers());
        INFO(done.out, done.err);
        CHECK(compared(done.out) > 300);
        if (contains(done.out, "not installed"))
            tellSkipped("the mixed models: a package of R is not installed");
        else {
            const std::string models = slurp(scratch / "r/mixed_models.csv");
            CHECK(contains(models, "\"accuracy\",\"logistic GLMM\",\"stiff\",\"fluent\""));
            CHECK(contains(models, "\"naturalness\",\"cumulative link mixed model\""));
        }

        // The comparison can fail.
        std::string pairs = slurp(scratch / "r/pairwise.csv");
        const auto row = pairs.find("\naccuracy,") + 1;
        const auto shift = pairs.find(',', pairs.find(',', pairs.find(',', row) + 1) + 1) + 1;
        pairs.replace(shift, pairs.find(',', shift) - shift, "0.77");
        spill(scratch / "r/pairwise.csv", pairs);
        const auto wrong = shell("Rscript " + (scratch / "r/analysis.R"));
        INFO(wrong.out, wrong.err);
        CHECK(wrong.status == 1);
        CHECK(contains(wrong.out, "mean_difference"));
    }

    TEST_CASE("R finds the same numbers in single ratings and in authors' trials") {
        if (!hasR()) return;
        const Scratch scratch;
        const auto oracle = nlohmann::json::parse(slurp(sourceDir() / "tests/results/oracles/ratings.json"));
        const auto done = analysedByR(scratch, oracle["cases"][0]["csv"], "--unit ratings");
        INFO(done.out, done.err);
        const CsvTable numbers(slurp(scratch / "r/comparison.csv"));
        for (const char* table : {"pairwise_ratings", "author_trials", "author_trials_by_participants"})
            CHECK_MESSAGE(numbers.has({{"table", table}, {"row", "2"}, {"column", "p_holm"}}), table);
    }

    TEST_CASE("R takes two systems, a measure that nobody gave both, and models that cannot be fitted") {
        if (!hasR()) return;
        deixis::Random random(4);
        std::string answers = "participant,measure,system,rating\n";
        for (int p = 10; p < 20; ++p)
            for (const std::string system : {"stiff", "fluent"}) {
                const std::string start = "P" + std::to_string(p) + ",";
                for (int i = 0; i < 4; ++i)
                    answers += start + "naturalness," + system + "," +
                               std::to_string(1 + random.below(system == "fluent" ? 5 : 4)) + "\n";
                if ((p % 2 == 0) == (system == "stiff"))
                    answers += start + "shared," + system + "," + std::to_string(1 + random.below(5)) + "\n";
                // Two people only, who agree but for one answer: no covariance of the model.
                if (p < 12)
                    answers += start + "few," + system + "," +
                               (system == "stiff" ? "1"
                                : p == 10         ? "2"
                                                  : "3") +
                               "\n";
            }
        const Scratch scratch;
        const auto done = analysedByR(scratch, answers);
        INFO(done.out, done.err);
        CHECK(compared(done.out) > 50);
        if (!contains(done.out, "not installed"))
            CHECK(contains(slurp(scratch / "r/mixed_models.csv"),
                           "\"naturalness\",\"cumulative link mixed model\",\"stiff\",\"fluent\""));
    }

    TEST_CASE("Ratings with many steps get a linear mixed model, and what R says of it is told") {
        if (!hasR()) return;
        const Scratch scratch;
        const auto done = analysedByR(scratch, manySteps());
        INFO(done.out, done.err);
        if (contains(done.out, "not installed")) {
            tellSkipped("the mixed models: a package of R is not installed");
            return;
        }
        // Nothing is missing: a contrast is the difference of the means, which the program tells.
        const auto field = [](const std::string& table, const std::string& start, int column) {
            auto at = table.find("\n" + start);
            REQUIRE_MESSAGE(at != std::string::npos, table);
            ++at;
            for (int k = 0; k < column; ++k) at = table.find(',', at) + 1;
            return table.substr(at, table.find_first_of(",\n", at) - at);
        };
        const std::string models = slurp(scratch / "r/mixed_models.csv");
        const std::string pairs = slurp(scratch / "r/pairwise.csv");
        const std::string natural = "\"naturalness\",\"linear mixed model\",\"stiff\",\"fluent\"";
        CHECK(std::stod(field(models, natural, 4)) ==
              doctest::Approx(std::stod(field(pairs, "naturalness,stiff,fluent", 3))));
        CHECK(std::stod(field(models, natural, 7)) < 0.01);
        CHECK(contains(field(models, natural, 9),
                       "(1 + system | participant) + (1 | item): boundary (singular) fit"));
        CHECK(contains(field(models, natural, 10), "(1 | participant) + (1 | item)"));
        // No participant is above another.
        const std::string smooth = "\"smoothness\",\"linear mixed model\",\"stiff\",\"fluent\"";
        CHECK(contains(field(models, smooth, 9), "singular"));
        CHECK(contains(done.out, "smoothness : "));
    }

    TEST_CASE("A model that did not converge is not published as if it had") {
        if (!hasR()) return;
        // lme4 1.1-31 stops elsewhere with its default optimiser, and gives z = -579 and z = 4687. Drawn by
        // R: set.seed(4), ten people with b = rnorm(10, 0, 4), right with logit 3 + b + (0, .6, -.6).
        const std::string right =
            "101111111111111011110111010011100001111111111111111111111111111111111111111111111111111111111111"
            "111111111111"
            "000000010000000100101111101111110011111111111111111111111111111111111111";
        std::string answers = "participant,system,item,correct\n";
        for (std::size_t i = 0; i < right.size(); ++i)
            answers += "P" + std::to_string(10 + i / 18) + "," + std::string(1, "abc"[i / 6 % 3]) + ",T" +
                       std::to_string(i % 6) + "," + right[i] + "\n";
        const Scratch scratch;
        const auto done = analysedByR(scratch, answers);
        INFO(done.out, done.err);
        if (contains(done.out, "not installed")) {
            tellSkipped("the mixed models: a package of R is not installed");
            return;
        }
        const std::string models = slurp(scratch / "r/mixed_models.csv");
        INFO(models);
        int rows = 0;
        for (const char* pair : {"\"a\",\"b\"", "\"a\",\"c\"", "\"b\",\"c\""}) {
            auto at = models.find(std::string("\"accuracy\",\"logistic GLMM\",") + pair);
            REQUIRE(at != std::string::npos);
            for (int k = 0; k < 6; ++k) at = models.find(',', at) + 1;
            const std::string z = models.substr(at, models.find(',', at) - at);
            ++rows;
            // Either it is a sensible one or none is given, with the reason.
            CHECK((z == "NA" || std::abs(std::stod(z)) < 5.0));
        }
        CHECK(rows == 3);
    }

    TEST_CASE("R finds the same numbers in preferences, and in groups without who is excluded") {
        if (!hasR()) return;
        const Scratch folder;
        spill(folder / "groups.toml",
              replaced(slurp(sourceDir() / "assets/data/studies/genea-pairwise.toml"), "[[systems]]",
                       "[[between]]\nname = \"age\"\nlevels = [\"old\", \"young\"]\n\n[[systems]]"));
        const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
            {folder / "groups.toml", {"preferences", "preferences_between"}},
            {"distractor-distance", {"between"}}};
        for (const auto& one : cases) {
            const std::string& study = one.first;
            CAPTURE(study);
            const Scratch scratch{WithSharedStimuli{}};
            const std::string db = scratch / "s.db";
            REQUIRE(program("simulate " + study + " --participants 7 --db " + db).status == 0);
            REQUIRE(program("participants exclude " + db + " S003 --reason test").status == 0);
            REQUIRE(program("report " + db + " -o " + (scratch / "page.html") + " --r " + (scratch / "r"))
                        .status == 0);
            const auto done = shell("Rscript " + (scratch / "r/analysis.R"));
            INFO(done.out, done.err);
            CHECK(done.status == 0);
            CHECK(compared(done.out) > 100);
            for (const std::string& table : one.second)
                CHECK(contains(slurp(scratch / "r/comparison.csv"), "\"" + table + "\""));
            CHECK(contains(done.out, "Some answers are simulated"));
        }
    }
}
