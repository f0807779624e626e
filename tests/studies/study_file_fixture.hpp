// Study files for tests: the fixtures, edited in a folder of their own.
#pragma once

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "core/files.hpp"
#include "paths.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

inline const std::filesystem::path source = deixis::tests::sourceDir();
inline const std::filesystem::path fixtures = source / "tests/studies/fixtures";
inline const std::filesystem::path shipped_studies = source / "assets/data/studies";
inline const StudyFolders shipped_folders{source / "assets/data/languages",
                                          source / "assets/data/questionnaires"};

inline std::string readText(const std::filesystem::path& path) {
    const Result<std::string> text = readFile(path);
    REQUIRE_MESSAGE(text.has_value(), path.string());
    return *text;
}

/// A copy of the fixtures in a folder of its own; gone with the test.
class Folder {
  public:
    Folder() {
        namespace fs = std::filesystem;
        std::string name = (fs::temp_directory_path() / "deixis_study_XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path_ = name;
        fs::copy(fixtures, path_, fs::copy_options::recursive);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    [[nodiscard]] std::filesystem::path write(const std::string& bytes,
                                              const std::string& name = "study.toml") const {
        const std::filesystem::path file = path_ / name;
        REQUIRE(writeFile(file, bytes).has_value());
        return file;
    }

  private:
    std::filesystem::path path_;
};

/// `text` with its only occurrence of `from` replaced.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE_MESSAGE(at != std::string::npos, from);
    REQUIRE_MESSAGE(text.find(from, at + 1) == std::string::npos, from);
    return text.replace(at, from.size(), to);
}

inline int lineOf(const std::string& text, const std::string& part) {
    const auto at = text.find(part);
    REQUIRE_MESSAGE(at != std::string::npos, part);
    return 1 +
           static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

/// All errors as printed, one a line.
inline std::string allText(const std::vector<Error>& errors) {
    std::string out;
    for (const Error& error : errors) out += error.text() + "\n";
    return out;
}

/// A study that must load.
inline Study loaded(const std::filesystem::path& path, const std::string& language = {}) {
    auto study = loadStudy(path, shipped_folders, language);
    if (!study) FAIL(allText(study.error()));
    return std::move(*study);
}

/// The problems of a study that must not load.
inline std::vector<Error> problemsOf(const std::filesystem::path& path, const std::string& language = {}) {
    auto study = loadStudy(path, shipped_folders, language);
    REQUIRE_FALSE(study.has_value());
    REQUIRE_FALSE(study.error().empty());
    return std::move(study.error());
}

struct BadEdit {
    std::string from, to;
    std::string line_of;  ///< text on the line that the error names, in the edited file
    std::string key;
    std::vector<std::string> words;  ///< what the error must tell
};

/// Each edit gives one problem and no others that only follow from it.
inline void checkEdits(const std::string& fixture, const std::vector<BadEdit>& edits) {
    const std::string original = readText(fixtures / fixture);
    const Folder folder;
    for (const BadEdit& edit : edits) {
        CAPTURE(edit.from);
        CAPTURE(edit.to);
        const std::string text = replaced(original, edit.from, edit.to);
        const std::filesystem::path file = folder.write(text);
        const std::vector<Error> errors = problemsOf(file);
        CHECK_MESSAGE(errors.size() == 1, allText(errors));
        CHECK(errors[0].where ==
              fmt::format("{}:{}: {}", file.string(), lineOf(text, edit.line_of), edit.key));
        for (const std::string& word : edit.words)
            CHECK_MESSAGE(errors[0].text().find(word) != std::string::npos,
                          "'" << word << "' should stand in: " << errors[0].text());
    }
}

}  // namespace deixis::studies
