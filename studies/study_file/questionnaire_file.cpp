// Reads a questionnaire file.
#include <fmt/format.h>

#include <algorithm>

#include "core/files.hpp"
#include "study_reading.hpp"

namespace deixis::studies {

namespace {

Score readScore(TomlTable& table, const Questionnaire& questionnaire) {
    std::vector<std::string_view> ids;
    for (const Question& question : questionnaire.questions)
        if (question.kind == QuestionKind::scale && !question.id.empty()) ids.push_back(question.id);
    Score score;
    score.name = table.name("name");
    score.items = table.names("items", 1, true, true);
    for (const std::string& item : score.items)
        table.checkKnown("items", item, ids, "the questions on a scale");
    score.reversed = table.names("reversed", 1, false);
    const std::vector<std::string_view> items(score.items.begin(), score.items.end());
    for (const std::string& item : score.reversed) table.checkKnown("reversed", item, items, "items");
    score.mean = table.flag("mean", score.mean);
    score.factor = table.number("factor", -1000.0, 1000.0, score.factor);
    if (score.factor == 0.0 && table.sound("factor"))
        table.problem("factor", "found 0, expected another number: the score would always be the same");
    score.offset = table.number("offset", -1e6, 1e6, score.offset);
    return score;
}

void readScores(TomlTable& root, Questionnaire& questionnaire) {
    for (const toml::table* section : root.sections("scores", false)) {
        TomlTable table = root.below("scores", section, keys::scores);
        Score score = readScore(table, questionnaire);
        if (!score.name.empty() && std::any_of(questionnaire.scores.begin(), questionnaire.scores.end(),
                                               [&](const Score& other) { return other.name == score.name; }))
            table.problem("name", fmt::format("\"{}\" occurs twice, expected a unique name", score.name));
        questionnaire.scores.push_back(std::move(score));
    }
}

}  // namespace

tl::expected<QuestionnaireFile, std::vector<Error>> loadQuestionnaire(const std::filesystem::path& path,
                                                                      const std::string& language) {
    Result<std::string> bytes = readFile(path);
    if (!bytes) return tl::unexpected(std::vector{bytes.error()});
    const Result<toml::table> table = parseToml(path.string(), *bytes);
    if (!table) return tl::unexpected(std::vector{table.error()});

    QuestionnaireFile file;
    Problems problems(path.string());
    TextBook texts(problems);
    TomlTable root(&*table, "", keys::questionnaire, problems, texts);
    file.languages = readLanguages(root, *table);
    const bool known =
        std::find(file.languages.begin(), file.languages.end(), language) != file.languages.end();
    texts.read(*table, file.languages, known ? language : file.languages.front());

    Questionnaire& questionnaire = file.questionnaire;
    questionnaire.name = root.name("name");
    questionnaire.title = root.text("title", "");
    questionnaire.text = root.text("text", "");
    questionnaire.reference = root.note("reference");
    questionnaire.per_page = root.count("per_page", 1, 10, questionnaire.per_page);
    questionnaire.questions = readQuestions(root, nullptr);
    readScores(root, questionnaire);
    if (!problems.none()) return tl::unexpected(problems.sorted());
    file.bytes = std::move(*bytes);
    return file;
}

}  // namespace deixis::studies
