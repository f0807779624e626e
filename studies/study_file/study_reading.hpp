// The parts of a study file, read one after another; private to studies.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "studies/study_file/stage_kind.hpp"
#include "studies/texts/study_texts.hpp"
#include "studies/texts/toml_table.hpp"
#include "study_keys.hpp"

namespace deixis::studies {

/// The names, each once.
template <typename Entry>
std::vector<std::string_view> namesIn(const std::vector<Entry>& entries) {
    std::vector<std::string_view> out;
    for (const Entry& entry : entries)
        if (!entry.name.empty() && std::find(out.begin(), out.end(), entry.name) == out.end())
            out.push_back(entry.name);
    return out;
}

/// What to read from and where it goes.
struct StudyReader {
    const toml::table& file;
    TomlTable root;
    std::filesystem::path folder;  ///< of the study file
    StudyFolders folders;
    Problems& problems;
    Study& study;
    bool shows_clips = false;  ///< any stage of the file
    bool shows_balls = false;
    std::string questionnaire_bytes{};  ///< of the files named, each once, in order

    /// Keeps where the study file has `key` of `table`, for Study::places.
    void keepPlace(const std::string& name, const TomlTable& table, std::string_view key) {
        study.places[name] =
            fmt::format("{}:{}: {}", study.file.string(), table.place(key).line, table.dotted(key));
    }
};

// study_sections.cpp, in the order in which they need each other
void readTargets(StudyReader& reader);
void readDistances(StudyReader& reader);
void readLayouts(StudyReader& reader);
void readSystems(StudyReader& reader);
void readBetween(StudyReader& reader);
void readHeadset(StudyReader& reader);
void readAnalysis(StudyReader& reader);

/// A stage as read so far, with its table for what can be checked only when all are read.
struct StageEntry {
    TomlTable table;
    const StageDeclaration* kind;  ///< null: practice, or a kind that there is not
    bool known;                    ///< the kind
    Stage stage{};
};

/// What a kind reads its stages from, beside their own tables.
struct StageReading {
    StudyReader& reader;
    std::map<std::string, Questionnaire> questionnaires{};  ///< that were read, by name
};

/// How a kind's stages are read: studies/trials/KIND/reading.cpp.
struct KindReader {
    /// Reads the stage's own table.
    void (*read)(TomlTable& table, StageReading& reading, Stage& stage);
    /// What a stage's systems and layouts must be beside known; null: nothing.
    void (*checkLevels)(TomlTable& table, const Study& study, const Stage& stage) = nullptr;
};

// study_stages.cpp
[[nodiscard]] const KindReader& readerOf(StageKind kind);
/// Fills in all that a stage's own table tells.
[[nodiscard]] std::deque<StageEntry> readStages(StudyReader& reader);
// study_trials.cpp
/// What all kinds have that show clips: those keys that the stage's kind has.
void readTrials(TomlTable& table, StageReading& reading, Stage& stage);
/// How many trials a participant has in a stage that is no practice, checks left aside.
[[nodiscard]] long long trialsOf(const Stage& stage);

// study_checks.cpp
/// Fills in practice stages from the ones they practise and checks what stages have to do with each other and
/// with the rest of the file.
void finishStages(StudyReader& reader, std::deque<StageEntry>& stages);

// study_questions.cpp
/// A required [key] that is a scale.
[[nodiscard]] Scale readScale(TomlTable& table, std::string_view key);
[[nodiscard]] std::vector<QuestionOption> readOptions(TomlTable& table);
/// [[questions]] and the default scale of a table. `systems`: those that questions may rate; null: a file of
/// its own, which knows none.
[[nodiscard]] std::vector<Question> readQuestions(TomlTable& table, const std::vector<SystemSource>* systems);

// questionnaire_file.cpp
struct QuestionnaireFile {
    Questionnaire questionnaire{};
    std::vector<std::string> languages{};
    std::string bytes{};
};
/// Reads and checks NAME.toml in `language` (of the file's, else its first).
[[nodiscard]] tl::expected<QuestionnaireFile, std::vector<Error>> loadQuestionnaire(
    const std::filesystem::path& path, const std::string& language);

}  // namespace deixis::studies
