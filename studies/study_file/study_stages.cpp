// The stages: what each one's own table tells.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <system_error>

#include "study_reading.hpp"

namespace deixis::studies {

namespace {

namespace fs = std::filesystem;

/// A key that other kinds have is a problem of its own, with the kinds that have it.
void refuseOtherKinds(TomlTable& table, std::size_t kind) {
    for (const std::string_view key : table.keys()) {
        const bool known = std::find(keys::stages.begin(), keys::stages.end(), key) != keys::stages.end();
        if (!known || stageHasKey(kind, key)) continue;
        std::vector<std::string> kinds;
        for (std::size_t other = 0; other < std::size(kind_names); ++other)
            if (stageHasKey(other, key)) kinds.push_back(fmt::format("\"{}\"", kind_names[other]));
        table.problem(key, fmt::format("found in a stage of kind \"{}\", expected in {} only",
                                       kind_names[kind], fmt::join(kinds, ", ")));
    }
}

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

class QuestionnaireShelf {
  public:
    explicit QuestionnaireShelf(StudyReader& reader) : reader_(reader) {}

    Questionnaire read(TomlTable& table) {
        const std::string name = table.name("file");
        if (!table.sound("file")) return {};
        const fs::path path = findQuestionnaire(reader_, name);
        if (path.empty()) {
            const std::vector<std::string> names = shippedQuestionnaires(reader_);
            table.problem("file",
                          fmt::format("found \"{}\", but there is no {}.toml in {} or {}", name, name,
                                      reader_.folder.empty() ? "." : reader_.folder.string(),
                                      reader_.folders.questionnaires.string()),
                          names.empty()
                              ? ""
                              : proposeName(name, std::vector<std::string_view>(names.begin(), names.end())));
            return {};
        }
        if (const auto before = read_.find(name); before != read_.end()) return before->second;
        return read_[name] = load(table, path, name);
    }

  private:
    StudyReader& reader_;
    std::map<std::string, Questionnaire> read_{};

    Questionnaire load(TomlTable& table, const fs::path& path, const std::string& name) {
        auto file = loadQuestionnaire(path, reader_.study.language);
        if (!file) {
            reader_.problems.add(table.place("file"), std::move(file.error()));
            return {};
        }
        reader_.questionnaire_bytes += file->bytes;
        reader_.study.questionnaire_files.push_back(path);
        for (const std::string& language : reader_.study.languages)
            if (std::find(file->languages.begin(), file->languages.end(), language) == file->languages.end())
                table.problem("file",
                              fmt::format("the questionnaire \"{}\" has no texts in \"{}\", only in {}", name,
                                          language, fmt::join(file->languages, ", ")),
                              fmt::format("Add [texts.{}] to {}", language, path.string()));
        return std::move(file->questionnaire);
    }
};

void readQuestionnaireStage(TomlTable& table, QuestionnaireShelf& shelf, Stage& stage) {
    stage.about_participant = table.flag("about_participant", false);
    if (table.has("file") == table.has("questions")) {
        table.problem(table.has("file") ? "questions" : "file",
                      table.has("file") ? "found both file and questions, expected one of them"
                                        : "found neither file nor questions, expected one of them");
        return;
    }
    if (table.has("file")) {
        for (const std::string_view key : {"title", "text", "per_page", "scale"})
            table.refuse(key, "together with file, which has its own");
        stage.questionnaire = shelf.read(table);
        return;
    }
    Questionnaire& questionnaire = stage.questionnaire;
    questionnaire.name = stage.name;
    questionnaire.title = table.text("title", "");
    questionnaire.text = table.text("text", "");
    questionnaire.per_page = table.count("per_page", 1, 10, questionnaire.per_page);
    questionnaire.questions = readQuestions(table);
}

Practice readPractice(TomlTable& table) {
    Practice practice;
    practice.of = table.name("of");
    practice.criterion = table.number("criterion", 0.0, 1.0, 0.0);
    practice.max_attempts = table.count("max_attempts", 1, 10, 1);
    practice.end_if_failed = table.flag("end_if_failed", false);
    if (practice.max_attempts > 1)
        practice.again_text = table.text("again_text");
    else if (!table.faulty("max_attempts"))
        table.refuse("again_text", "without max_attempts over 1");
    if (practice.criterion == 0.0 && !table.faulty("criterion")) {
        if (practice.max_attempts > 1)
            table.problem("max_attempts",
                          fmt::format("found {}, expected 1 without a criterion, which alone calls "
                                      "for a further attempt",
                                      practice.max_attempts));
        table.refuse("end_if_failed", "without a criterion");
    }
    return practice;
}

void readPage(TomlTable& table, Stage& stage) {
    stage.text = table.text("text");
    if (stage.kind == StageKind::instructions) stage.emphasis = table.text("emphasis", "");
    if (stage.kind != StageKind::consent) stage.minimum_s = table.number("minimum_s", 0.0, 3600.0, 0.0);
}

void readWhen(TomlTable& table, const Study& study, Stage& stage) {
    stage.when = table.levels("when");
    const std::vector<std::string_view> factors = namesIn(study.between);
    for (const auto& [name, level] : stage.when) {
        const auto factor =
            std::find_if(study.between.begin(), study.between.end(),
                         [&, wanted = name](const BetweenFactor& entry) { return entry.name == wanted; });
        if (factor == study.between.end()) {
            table.problemAt("when", name, fmt::format("there is no factor \"{}\" in [[between]]", name),
                            factors.empty() ? "" : proposeName(name, factors));
        } else if (!factor->levels.empty() &&
                   std::find(factor->levels.begin(), factor->levels.end(), level) == factor->levels.end()) {
            table.problemAt(
                "when", name, fmt::format("there is no level \"{}\" of \"{}\" in [[between]]", level, name),
                proposeName(level,
                            std::vector<std::string_view>(factor->levels.begin(), factor->levels.end())));
        }
    }
}

void readSession(TomlTable& table, int before, Stage& stage) {
    stage.session = table.count("session", 1, 100, before == 0 ? 1 : before);
    if (!table.sound("session") || stage.session == before || stage.session == before + 1) {
        if (table.faulty("session")) stage.session = std::max(before, 1);
        return;
    }
    table.problem("session", before == 0
                                 ? fmt::format("found {}, expected 1 in the first stage", stage.session)
                             : stage.session < before
                                 ? fmt::format("found {}, expected {} or {}: sessions do not go back",
                                               stage.session, before, before + 1)
                                 : fmt::format("found {}, expected {} or {}: no session is left out",
                                               stage.session, before, before + 1));
}

/// A sitting that asks nothing would count as answered before it began.
void refuseSessionsOfPages(std::deque<StageEntry>& stages) {
    const auto asks = [](const StageEntry& one) {
        return one.stage.practice ||
               (one.stage.kind != StageKind::instructions && one.stage.kind != StageKind::rest);
    };
    for (std::size_t i = 1; i < stages.size(); ++i) {
        const int session = stages[i].stage.session;
        if (session == stages[i - 1].stage.session) continue;
        if (std::none_of(stages.begin(), stages.end(), [&](const StageEntry& other) {
                return other.stage.session == session && (asks(other) || other.kind == std::size(kind_names));
            }))
            stages[i].table.problem(
                "session", fmt::format("session {} asks nothing, expected a stage that is answered", session),
                "Move its pages to the end of the session before");
    }
}

}  // namespace

std::deque<StageEntry> readStages(StudyReader& reader) {
    constexpr std::size_t no_kind = std::size(kind_names);
    QuestionnaireShelf shelf(reader);
    std::deque<StageEntry> out;
    int session = 0;
    for (const toml::table* section : reader.root.sections("stages", true)) {
        TomlTable table = reader.root.below("stages", section, keys::stages);
        Stage stage;
        stage.name = table.name("name");
        if (!stage.name.empty() && std::any_of(out.begin(), out.end(), [&](const StageEntry& other) {
                return other.stage.name == stage.name;
            }))
            table.problem("name", fmt::format("\"{}\" comes twice, expected a name of its own", stage.name));
        readSession(table, session, stage);
        session = stage.session;
        readWhen(table, reader.study, stage);
        const std::size_t kind = table.choice("kind", kind_names, true).value_or(no_kind);
        if (kind != no_kind) refuseOtherKinds(table, kind);
        if (kind == practice_kind) {
            stage.practice = readPractice(table);
            stage.design.items = table.count("items", 1, 10000);
        } else if (kind != no_kind) {
            stage.kind = static_cast<StageKind>(kind);
            if (showsClips(stage.kind))
                readTrials(table, reader.study, stage);
            else if (stage.kind == StageKind::questionnaire)
                readQuestionnaireStage(table, shelf, stage);
            else
                readPage(table, stage);
        }
        out.push_back({std::move(table), kind, std::move(stage)});
    }
    refuseSessionsOfPages(out);
    return out;
}

}  // namespace deixis::studies
