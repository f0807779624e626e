#include "studies/study_file/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <system_error>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "studies/texts/language_words.hpp"
#include "study_reading.hpp"

namespace deixis::studies {

namespace {

namespace fs = std::filesystem;

/// The program's own words in one language: those that ship, those of the study's [words.LANGUAGE], or the
/// former with some of them replaced by the latter.
void readWordsOf(const std::string& language, const toml::table* own, TomlTable& table, StudyReader& reader,
                 LanguageStatus& status) {
    const fs::path path = reader.folders.languages / (language + ".toml");
    std::error_code ignored;
    const bool ships = fs::is_regular_file(path, ignored);
    if (!ships && own == nullptr) {
        table.problem("languages",
                      fmt::format("found \"{}\", a language that the program does not have", language),
                      fmt::format("Add its words as [words.{}]: all those of {}, translated", language,
                                  (reader.folders.languages / "en.toml").string()));
        return;
    }
    std::optional<LanguageTable> words;
    if (ships) {
        reader.study.language_files.push_back(path);
        const fs::path& since = reader.folders.words_since;
        Result<LanguageTable> shipped = since.empty()
                                            ? LanguageTable::load(path)
                                            : LanguageTable::loadKept(path, since / path.filename());
        if (!shipped) return reader.problems.add(table.place("languages"), {shipped.error()});
        words = std::move(*shipped);
    }
    if (own != nullptr) {
        const std::string prefix = fmt::format("words.{}.", language);
        Result<LanguageTable> read =
            readWords(*own, reader.study.file.string(), prefix, language,
                      words                                ? &*words
                      : reader.folders.words_since.empty() ? nullptr
                                                           : &LanguageTable::english());
        if (!read) return reader.problems.add(own->source().begin, {read.error()});
        words = std::move(*read);
    }
    status.words = words->status();
    if (language == reader.study.language) reader.study.words = std::move(*words);
}

/// [words.LANGUAGE] of every language; those of the session's go into the study.
void readAllWords(TomlTable& table, StudyReader& reader) {
    Study& study = reader.study;
    const toml::table* section = reader.root.section("words", false);
    if (section != nullptr)
        for (const auto& [code, node] : *section)
            if (std::find(study.languages.begin(), study.languages.end(), code.str()) ==
                    study.languages.end() ||
                !node.is_table())
                reader.problems.add(
                    code.source().begin, fmt::format("words.{}", code.str()),
                    fmt::format("found {}, expected a section [words.LANGUAGE] of one of {}",
                                node.is_table() ? fmt::format("[words.{}]", code.str()) : describe(node),
                                fmt::join(study.languages, ", ")));
    for (std::size_t i = 0; i < study.languages.size(); ++i) {
        const toml::node* own = section != nullptr ? section->get(study.languages[i]) : nullptr;
        readWordsOf(study.languages[i], own != nullptr ? own->as_table() : nullptr, table, reader,
                    study.language_status[i]);
    }
}

/// text_status = {de = "translated"}
void readTextStatus(TomlTable& table, Study& study) {
    for (const auto& [language, name] : table.levels("text_status")) {
        const auto known = std::find(study.languages.begin(), study.languages.end(), language);
        const auto status = textStatusFromName(name);
        if (known == study.languages.end())
            table.problemAt("text_status", language,
                            fmt::format("\"{}\" is not among languages ({})", language,
                                        fmt::join(study.languages, ", ")));
        else if (!status)
            table.problemAt(
                "text_status", language,
                fmt::format("found \"{}\", expected \"written\", \"translated\" or \"reviewed\"", name));
        else
            study.language_status[static_cast<std::size_t>(known - study.languages.begin())].texts = *status;
    }
}

/// The languages, and which of them the texts are to be in. Before all else, since texts depend on them.
void readLanguage(TomlTable& table, StudyReader& reader, TextBook& texts, const std::string& wanted) {
    Study& study = reader.study;
    study.languages = readLanguages(table, reader.file);
    study.language = wanted.empty() ? study.languages.front() : wanted;
    const auto& all = study.languages;
    if (std::find(all.begin(), all.end(), study.language) == all.end()) {
        table.problem("languages", fmt::format("there is no language \"{}\" in the study, which has {}",
                                               wanted, fmt::join(all, ", ")));
        study.language = all.front();
    }
    texts.read(reader.file, study.languages, study.language);
    study.language_status.resize(study.languages.size());
    readTextStatus(table, study);
    if (!table.faulty("languages") || table.sound("languages")) readAllWords(table, reader);
}

void readHead(TomlTable& table, StudyReader& reader) {
    Study& study = reader.study;
    study.name = table.name("name");
    study.title = table.text("title");
    study.description = table.note("description", "");
    study.reference = table.note("reference", "");
    study.seed = static_cast<std::uint64_t>(table.whole("seed", 0, std::numeric_limits<std::int64_t>::max()));
    study.eye_height_m = table.number("eye_height_m", 0.5, 2.5, study.eye_height_m);
    if (table.has("avatar")) {
        study.avatar = (reader.folder / table.note("avatar")).lexically_normal();
        reader.keepPlace("study.avatar", table, "avatar");
    }
    if (table.has("avatar_height_m")) {
        study.avatar_height_m = table.number("avatar_height_m", 0.3, 3.0);
        if (study.avatar.empty()) table.reject("avatar_height_m", "without the study's own avatar");
    }
    study.inter_trial_s = table.number("inter_trial_s", 0.0, 60.0, study.inter_trial_s);
    constexpr std::string_view after_interruption[] = {"resume", "repeat"};
    study.after_interruption = static_cast<AfterInterruption>(
        table.choice("after_interruption", after_interruption, false).value_or(0));
    study.instructions_again_after_s =
        table.number("instructions_again_after_s", 0.0, 1e7, study.instructions_again_after_s);
}

/// What the file's stages need, before they are read.
void foresee(StudyReader& reader) {
    const toml::array* stages = reader.file["stages"].as_array();
    if (stages == nullptr) return;
    for (const toml::node& node : *stages) {
        const toml::table* table = node.as_table();
        const std::optional<std::string_view> name =
            table != nullptr ? (*table)["kind"].value<std::string_view>() : std::nullopt;
        const StageDeclaration* kind = findDeclaration(name.value_or(""));
        if (kind == nullptr) continue;
        reader.shows_clips = reader.shows_clips || kind->showsClips();
        reader.shows_balls = reader.shows_balls || kind->balls;
    }
}

void readStudy(StudyReader& reader, TextBook& texts, const std::string& language) {
    foresee(reader);
    TomlTable head = reader.root.below("study", reader.root.section("study", true), keys::study);
    readLanguage(head, reader, texts, language);
    readHead(head, reader);
    readTargets(reader);
    readDistances(reader);
    readLayouts(reader);
    readSystems(reader);
    readBetween(reader);
    std::deque<StageEntry> stages = readStages(reader);
    finishStages(reader, stages);
    for (StageEntry& entry : stages) reader.study.stages.push_back(std::move(entry.stage));
    readHeadset(reader);
    readAnalysis(reader);
}

}  // namespace

tl::expected<Study, std::vector<Error>> loadStudy(const fs::path& path, const StudyFolders& folders,
                                                  const std::string& language) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) return tl::unexpected(std::vector{bytes.error()});
    const Result<toml::table> file = parseToml(path.string(), *bytes);
    if (!file) return tl::unexpected(std::vector{file.error()});

    Study study;
    study.file = path;
    Problems problems(path.string());
    TextBook texts(problems);
    StudyReader reader{
        *file, TomlTable(&*file, "", keys::root, problems, texts), path.parent_path(), folders, problems,
        study};
    readStudy(reader, texts, language);
    if (!problems.none()) return tl::unexpected(problems.sorted());
    study.source = *bytes;
    study.hash = sha256Hex(*bytes + reader.questionnaire_bytes);
    return study;
}

}  // namespace deixis::studies
