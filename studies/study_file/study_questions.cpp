// Scales, questions and their options, as study files and questionnaire files write them.
#include <fmt/format.h>

#include <algorithm>

#include "study_reading.hpp"

namespace deixis::studies {

namespace {

constexpr int max_steps = 11;  // what fits on a board

void checkLabels(TomlTable& table, const Scale& scale) {
    const std::size_t found = scale.labels.size();
    if (!table.has("labels") || table.faulty("low") || table.faulty("high")) return;
    if (scale.kind == ScaleKind::slider) {
        if (found < 2 || found > max_steps)
            table.problem("labels", fmt::format("found a list of {}, expected 2 to {} texts or none", found,
                                                max_steps));
        return;
    }
    const int steps = scale.steps();
    if (found != 2 && found != static_cast<std::size_t>(steps))
        table.problem("labels",
                      fmt::format("found a list of {}, expected {} texts, one for each step from {} to "
                                  "{}, or 2 for the ends",
                                  found, steps, scale.low, scale.high));
}

QuestionOption readOption(TomlTable table, const std::vector<QuestionOption>& before) {
    QuestionOption option{table.name("id"), table.text("text")};
    if (!option.id.empty() && std::any_of(before.begin(), before.end(),
                                          [&](const QuestionOption& other) { return other.id == option.id; }))
        table.problem("id", fmt::format("\"{}\" occurs twice, expected a unique id", option.id));
    return option;
}

void readNumberQuestion(TomlTable& table, Question& question) {
    question.low = table.number("low", -1e6, 1e6, question.low);
    question.high = table.number("high", -1e6, 1e6, question.high);
    question.whole = table.flag("whole", question.whole);
    if (!table.faulty("low") && !table.faulty("high") && question.low >= question.high)
        table.problem("high",
                      fmt::format("found {}, expected more than low ({})", question.high, question.low));
}

/// rates = {measure = "intention", system = "SGT"}
std::optional<SystemRated> readRated(TomlTable& table, const std::vector<SystemSource>* systems) {
    if (!table.has("rates")) return std::nullopt;
    if (systems == nullptr) {
        table.reject("rates", "in a questionnaire's own file, which knows no systems");
        return std::nullopt;
    }
    TomlTable rates = table.below("rates", table.section("rates", false), keys::rates);
    SystemRated out{rates.name("measure"), rates.name("system")};
    if (out.measure == "accuracy" || out.measure == "preference")
        rates.problem("measure", fmt::format("found \"{}\", which is the report's name for other answers; "
                                             "expected another name",
                                             out.measure));
    if (rates.sound("system")) rates.checkKnown("system", out.system, namesIn(*systems), "[[systems]]");
    return out;
}

Question readQuestion(TomlTable& table, const std::optional<Scale>& shared,
                      const std::vector<SystemSource>* systems) {
    Question question;
    question.id = table.name("id");
    question.text = table.text("text");
    question.required = table.flag("required", question.required);
    constexpr std::string_view kinds[] = {"scale", "choice", "choices", "number", "text"};
    const std::optional<std::size_t> kind = table.choice("kind", kinds, true);
    if (!kind) return question;
    question.kind = static_cast<QuestionKind>(*kind);
    const std::string why = fmt::format("in a question of kind \"{}\"", kinds[*kind]);
    const bool options = question.kind == QuestionKind::choice || question.kind == QuestionKind::choices;
    if (question.kind != QuestionKind::scale)
        for (const std::string_view key : {"scale", "rates"}) table.reject(key, why);
    if (!options) table.reject("options", why);
    if (question.kind != QuestionKind::number)
        for (const std::string_view key : {"low", "high", "whole"}) table.reject(key, why);

    if (question.kind == QuestionKind::scale) question.rates = readRated(table, systems);
    if (question.kind == QuestionKind::scale)
        question.scale = shared && !table.has("scale") ? *shared : readScale(table, "scale");
    if (options) question.options = readOptions(table);
    if (question.kind == QuestionKind::number) readNumberQuestion(table, question);
    return question;
}

}  // namespace

Scale readScale(TomlTable& parent, std::string_view key) {
    Scale scale;
    const toml::table* section = parent.section(key, true);
    if (section == nullptr) return scale;
    TomlTable table = parent.below(key, section, keys::scale);
    constexpr std::string_view kinds[] = {"steps", "slider"};
    scale.kind = static_cast<ScaleKind>(table.choice("kind", kinds, false).value_or(0));
    scale.low = table.count("low", -1000, 1000);
    scale.high = table.count("high", -1000, 1000);
    scale.labels = table.texts("labels");
    const bool ends_sound = table.sound("low") && table.sound("high");
    if (ends_sound && scale.low >= scale.high)
        table.problem("high", fmt::format("found {}, expected more than low ({})", scale.high, scale.low));
    else if (ends_sound && scale.kind == ScaleKind::steps && scale.steps() > max_steps)
        table.problem("high",
                      fmt::format("found {}, expected at most {}: a scale of steps has at most {} of them",
                                  scale.high, scale.low + max_steps - 1, max_steps),
                      "Make it a slider");
    checkLabels(table, scale);
    return scale;
}

std::vector<QuestionOption> readOptions(TomlTable& table) {
    constexpr std::size_t min = 2;
    constexpr std::size_t max = 12;
    std::vector<QuestionOption> options;
    const std::vector<const toml::table*> entries = table.sections("options", true);
    for (const toml::table* entry : entries)
        options.push_back(readOption(table.below("options", entry, keys::options), options));
    if (!entries.empty() && (entries.size() < min || entries.size() > max))
        table.problem("options",
                      fmt::format("found {} options, expected {} to {}", entries.size(), min, max));
    return options;
}

std::vector<Question> readQuestions(TomlTable& table, const std::vector<SystemSource>* systems) {
    std::optional<Scale> shared;
    if (table.has("scale")) shared = readScale(table, "scale");
    std::vector<Question> questions;
    for (const toml::table* entry : table.sections("questions", true)) {
        TomlTable below = table.below("questions", entry, keys::questions);
        Question question = readQuestion(below, shared, systems);
        if (!question.id.empty() &&
            std::any_of(questions.begin(), questions.end(),
                        [&](const Question& other) { return other.id == question.id; }))
            below.problem("id", fmt::format("\"{}\" occurs twice, expected a unique id", question.id));
        questions.push_back(std::move(question));
    }
    return questions;
}

}  // namespace deixis::studies
