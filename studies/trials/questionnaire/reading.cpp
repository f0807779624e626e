#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "study_reading.hpp"

namespace deixis::studies {

namespace questionnaire {
namespace {

namespace fs = std::filesystem;

/// NAME.toml beside the study file, else among those that ship; empty where it is in neither.
fs::path findQuestionnaire(const StudyReader& reader, const std::string& name) {
    for (const fs::path& folder : {reader.folder, reader.folders.questionnaires}) {
        fs::path path = folder / (name + ".toml");
        std::error_code ignored;
        if (fs::is_regular_file(path, ignored)) return path;
    }
    return {};
}

std::vector<std::string> shippedQuestionnaires(const StudyReader& reader) {
    std::vector<std::string> names;
    std::error_code ignored;
    for (fs::directory_iterator it(reader.folders.questionnaires, ignored), end; !ignored && it != end;
         it.increment(ignored))
        if (it->path().extension() == ".toml") names.push_back(it->path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

Questionnaire load(TomlTable& table, StudyReader& reader, const fs::path& path, const std::string& name) {
    auto file = loadQuestionnaire(path, reader.study.language);
    if (!file) {
        reader.problems.add(table.place("file"), std::move(file.error()));
        return {};
    }
    reader.questionnaire_bytes += file->bytes;
    reader.study.questionnaire_files.push_back(path);
    for (const std::string& language : reader.study.languages)
        if (std::find(file->languages.begin(), file->languages.end(), language) == file->languages.end())
            table.problem("file",
                          fmt::format("the questionnaire \"{}\" has no texts in \"{}\", only in {}", name,
                                      language, fmt::join(file->languages, ", ")),
                          fmt::format("Add [texts.{}] to {}", language, path.string()));
    return std::move(file->questionnaire);
}

Questionnaire questionnaireOf(TomlTable& table, StageReading& reading) {
    StudyReader& reader = reading.reader;
    const std::string name = table.name("file");
    if (!table.sound("file")) return {};
    const fs::path path = findQuestionnaire(reader, name);
    if (path.empty()) {
        const std::vector<std::string> names = shippedQuestionnaires(reader);
        table.problem("file",
                      fmt::format("found \"{}\", but there is no {}.toml in {} or {}", name, name,
                                  reader.folder.empty() ? "." : reader.folder.string(),
                                  reader.folders.questionnaires.string()),
                      names.empty()
                          ? ""
                          : proposeName(name, std::vector<std::string_view>(names.begin(), names.end())));
        return {};
    }
    const auto before = reading.questionnaires.find(name);
    if (before != reading.questionnaires.end()) return before->second;
    return reading.questionnaires[name] = load(table, reader, path, name);
}

void read(TomlTable& table, StageReading& reading, Stage& stage) {
    stage.about_participant = table.flag("about_participant", false);
    if (table.has("file") == table.has("questions")) {
        table.problem(table.has("file") ? "questions" : "file",
                      table.has("file") ? "found both file and questions, expected one of them"
                                        : "found neither file nor questions, expected one of them");
        return;
    }
    if (table.has("file")) {
        for (const std::string_view key : {"title", "text", "per_page", "scale"})
            table.reject(key, "together with file, which has its own");
        stage.questionnaire = questionnaireOf(table, reading);
        return;
    }
    Questionnaire& questionnaire = stage.questionnaire;
    questionnaire.name = stage.name;
    questionnaire.title = table.text("title", "");
    questionnaire.text = table.text("text", "");
    questionnaire.per_page = table.count("per_page", 1, 10, questionnaire.per_page);
    questionnaire.questions = readQuestions(table, &reading.reader.study.systems);
}

}  // namespace
}  // namespace questionnaire

extern const KindReader questionnaire_reader{questionnaire::read};

}  // namespace deixis::studies
