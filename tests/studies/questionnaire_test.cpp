#include <doctest/doctest.h>
#include <fmt/format.h>

#include "study_file_fixture.hpp"

namespace fs = std::filesystem;
using namespace deixis;
using namespace deixis::studies;

namespace {

/// The questionnaire of a study that has no more than it.
Questionnaire questionnaireOf(const Folder& folder, const std::string& name) {
    const fs::path file = folder.write(
        fmt::format("[study]\nname = \"q\"\ntitle = \"Q\"\nseed = 1\n[[stages]]\nname = \"now\"\n"
                    "kind = \"questionnaire\"\nfile = \"{}\"\n",
                    name));
    return loaded(file).stages.at(0).questionnaire;
}

std::optional<double> scoreOf(const Questionnaire& questionnaire, std::string_view name,
                              const std::map<std::string, double>& answers) {
    for (const Score& score : questionnaire.scores)
        if (score.name == name) return computeScore(questionnaire, score, answers);
    FAIL(std::string(name));
    return {};
}

}  // namespace

TEST_SUITE("studies/questionnaire") {
    TEST_CASE("What a questionnaire file says is what the questionnaire holds.") {
        const Folder folder;
        const Questionnaire comfort = questionnaireOf(folder, "comfort");
        CHECK(comfort.name == "comfort");
        CHECK(comfort.title == "Comfort");
        CHECK(comfort.text == "How is it now?");
        CHECK(comfort.reference == "made up");
        CHECK(comfort.per_page == 2);
        REQUIRE(comfort.questions.size() == 3);
        CHECK(comfort.questions[0].text == "I am calm.");
        CHECK(comfort.questions[0].required);
        CHECK(comfort.questions[0].scale.high == 7);
        CHECK(comfort.questions[0].scale.labels == std::vector<std::string>{"little", "much"});
        CHECK_FALSE(comfort.questions[1].required);
        CHECK(comfort.questions[2].scale.kind == ScaleKind::slider);
        CHECK(comfort.questions[2].scale.labels.empty());
        REQUIRE(comfort.scores.size() == 1);
        CHECK(comfort.scores[0].reversed == std::vector<std::string>{"tense"});
        CHECK(comfort.scores[0].mean);
        CHECK(comfort.scores[0].factor == 10.0);
        CHECK(comfort.scores[0].offset == -10.0);
    }

    TEST_CASE("Questions are found by id and come on pages in order.") {
        const Folder folder;
        const Questionnaire comfort = questionnaireOf(folder, "comfort");
        REQUIRE(comfort.find("tense") != nullptr);
        CHECK(comfort.find("tense")->text == "I am tense.");
        CHECK(comfort.find("") == nullptr);
        CHECK(comfort.pages() == 2);
        REQUIRE(comfort.page(0).size() == 2);
        CHECK(comfort.page(0)[1]->id == "tense");
        REQUIRE(comfort.page(1).size() == 1);
        CHECK(comfort.page(1)[0]->id == "again");
        CHECK(comfort.page(2).empty());
    }

    TEST_CASE("Every question stands on exactly one page, however many fit on one.") {
        for (int questions = 1; questions <= 12; ++questions)
            for (int per_page = 1; per_page <= 10; ++per_page) {
                Questionnaire questionnaire;
                questionnaire.per_page = per_page;
                for (int i = 0; i < questions; ++i)
                    questionnaire.questions.push_back({fmt::format("q{}", i), QuestionKind::scale, "?"});
                int next = 0;
                for (int page = 0; page < questionnaire.pages(); ++page) {
                    const auto shown = questionnaire.page(page);
                    CHECK_FALSE(shown.empty());
                    CHECK(shown.size() <= static_cast<std::size_t>(per_page));
                    for (const Question* question : shown) CHECK(question->id == fmt::format("q{}", next++));
                }
                CHECK(next == questions);
            }
    }

    TEST_CASE("A score is worked out as by hand: reversed items, mean, factor and offset.") {
        const Folder folder;
        const Questionnaire comfort = questionnaireOf(folder, "comfort");
        // calm 6; tense 2 counts as 1 + 7 - 2 = 6; their mean is 6; 10 * 6 - 10.
        CHECK(scoreOf(comfort, "comfort", {{"calm", 6}, {"tense", 2}}) == 50.0);
        CHECK(scoreOf(comfort, "comfort", {{"calm", 1}, {"tense", 7}}) == 0.0);
        CHECK_FALSE(scoreOf(comfort, "comfort", {{"calm", 6}}).has_value());
        Score sum{"sum", {"calm", "calm", "tense"}};
        CHECK(computeScore(comfort, sum, {{"calm", 6}, {"tense", 2}}) == 14.0);  // 6 twice
        sum.items.clear();
        CHECK_FALSE(computeScore(comfort, sum, {}).has_value());
        CHECK_FALSE(computeScore(comfort, Score{"x", {"nobody"}}, {{"nobody", 1}}).has_value());
    }

    TEST_CASE("The simulator sickness questionnaire reaches the largest scores of Kennedy et al. (1993).") {
        const Folder folder;
        const Questionnaire ssq = questionnaireOf(folder, "ssq");
        REQUIRE(ssq.questions.size() == 16);
        std::map<std::string, double> severe;
        for (const Question& question : ssq.questions) severe[question.id] = 3;
        CHECK(scoreOf(ssq, "nausea", severe).value() == doctest::Approx(200.34));
        CHECK(scoreOf(ssq, "oculomotor", severe).value() == doctest::Approx(159.18));
        CHECK(scoreOf(ssq, "disorientation", severe).value() == doctest::Approx(292.32));
        CHECK(scoreOf(ssq, "total", severe).value() == doctest::Approx(235.62));
        for (auto& [id, value] : severe) value = 0;
        CHECK(scoreOf(ssq, "total", severe) == 0.0);
    }

    TEST_CASE("A file beside the study comes before one that ships with the same name.") {
        const Folder folder;
        static_cast<void>(folder.write(readText(fixtures / "comfort.toml"), "ssq.toml"));
        CHECK(questionnaireOf(folder, "ssq").name == "comfort");
    }

    TEST_CASE("What is wrong with a questionnaire file is told with its line and key.") {
        const std::vector<BadEdit> edits{
            {"name = \"comfort\"\ntitle", "nam = \"comfort\"\ntitle", "nam =", "nam", {"Did you mean name?"}},
            {"reference = \"made up\"\n", "", "", "reference", {"missing"}},
            {"per_page = 2", "per_page = 11", "per_page", "per_page", {"11", "1 to 10"}},
            {"high = 7", "high = 1", "scale", "scale.high", {"found 1", "more than low"}},
            {"id = \"again\"",
             "id = \"calm\"",
             "id = \"calm\"\nkind = \"scale\"\ntext = \"@again\"",
             "questions.id",
             {"occurs twice"}},
            {"items = [\"calm\", \"tense\"]",
             "items = [\"calm\", \"calm\", \"tence\", \"tense\"]",
             "tence",
             "scores.items",
             {"no \"tence\" in the questions on a scale", "Did you mean tense?"}},
            {"reversed = [\"tense\"]", "reversed = [\"again\"]", "reversed", "scores.reversed", {"items"}},
            {"reversed = [\"tense\"]",
             "reversed = [\"tense\", \"tense\"]",
             "reversed",
             "scores.reversed",
             {"twice"}},
            {"factor = 10", "factor = 0", "factor", "scores.factor", {"found 0"}},
            {"offset = -10", "offset = \"x\"", "offset", "scores.offset", {"the text \"x\""}},
            {"[[scores]]",
             "[[scores]]\nname = \"comfort\"\nitems = [\"calm\"]\n[[scores]]",
             "name = \"comfort\"\nitems = [\"calm\", \"tense\"]",
             "scores.name",
             {"occurs twice"}},
            {"tense = \"Jag är spänd.\"\n", "", "[texts.sv]", "texts.sv.tense", {"missing"}},
            {"how = \"Hur är det nu?\"",
             "how = \"Hur är det nu?\"\nmore = \"Mer.\"",
             "more =",
             "texts.sv.more",
             {"not used anywhere"}},
            {"[[scores]]",
             "[[questions]]\nid = \"more\"\nkind = \"text\"\ntext = \"More?\"\n[[scores]]",
             "More?",
             "questions.text",
             {"3 languages"}},
            {"title = \"@title\"", "title = \"@titel\"", "@titel", "title", {"Did you mean title?"}}};
        const std::string comfort = readText(fixtures / "comfort.toml");
        const Folder folder;
        const fs::path study = folder.write(
            "[study]\nname = \"q\"\ntitle = \"Q\"\nseed = 1\n[[stages]]\nname = \"now\"\n"
            "kind = \"questionnaire\"\nfile = \"comfort\"\n");
        for (const BadEdit& edit : edits) {
            CAPTURE(edit.to);
            const std::string text = replaced(comfort, edit.from, edit.to);
            const fs::path file = folder.write(text, "comfort.toml");
            const std::vector<Error> errors = problemsOf(study);
            CHECK_MESSAGE(errors.size() == 1, allText(errors));
            const std::string line =
                edit.line_of.empty() ? "" : fmt::format(":{}", lineOf(text, edit.line_of));
            CHECK(errors[0].where == fmt::format("{}{}: {}", file.string(), line, edit.key));
            for (const std::string& word : edit.words)
                CHECK_MESSAGE(errors[0].text().find(word) != std::string::npos,
                              "'" << word << "' should stand in: " << errors[0].text());
        }
    }

    TEST_CASE("A questionnaire without a shared scale needs one for each question on a scale.") {
        const Folder folder;
        std::string text = readText(fixtures / "comfort.toml");
        text = replaced(text, "scale = {low = 1, high = 7, labels = [\"@little\", \"@much\"]}\n", "");
        text = replaced(text, "id = \"calm\"\nkind = \"scale\"", "id = \"calm\"\nkind = \"text\"");
        const fs::path file = folder.write(text, "comfort.toml");
        const std::vector<Error> errors = problemsOf(
            folder.write("[study]\nname = \"q\"\ntitle = \"Q\"\nseed = 1\n[[stages]]\nname = \"now\"\n"
                         "kind = \"questionnaire\"\nfile = \"comfort\"\n"));
        std::vector<std::string> keys;
        for (const Error& error : errors) keys.push_back(error.where.substr(error.where.rfind(' ') + 1));
        // The two labels are used no more in any language, "tense" lacks a scale, and a score cannot count
        // words.
        CHECK(keys == std::vector<std::string>{"texts.de.little", "texts.de.much", "questions.scale",
                                               "scores.items"});
    }
}
