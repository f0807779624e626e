// Study files with any line gone, doubled or changed.
#include <doctest/doctest.h>
#include <iterator>
#include <sstream>

#include "study_file_fixture.hpp"

namespace fs = std::filesystem;
using namespace deixis;
using namespace deixis::studies;

namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

/// Every error must name the file and a line or a key of it.
void checkErrors(const fs::path& file, const std::string& bytes, int& failures) {
    const auto study = loadStudy(file, shipped_folders);
    if (study) return;
    ++failures;
    CHECK_FALSE(study.error().empty());
    const std::string start = file.string() + ":";
    const long lines = std::count(bytes.begin(), bytes.end(), '\n') + 1;
    for (const Error& error : study.error()) {
        CAPTURE(error.text());
        REQUIRE(error.where.rfind(start, 0) == 0);
        const std::string rest = error.where.substr(start.size());
        const long line = std::strtol(rest.c_str(), nullptr, 10);
        CHECK((rest[0] == ' ' ? rest.size() > 1 : line >= 1 && line <= lines));
        CHECK_FALSE(error.message.empty());
    }
}

}  // namespace

TEST_SUITE("studies/study_fuzz") {
    TEST_CASE("Whatever happens to a line of a file, loading tells of it by line or key and never throws.") {
        const Folder folder;
        for (const fs::path& path : {shipped_studies / "pointing2023.toml", fixtures / "full.toml"}) {
            const std::vector<std::string> lines = linesOf(readText(path));
            constexpr const char* values[] = {"-1", "1e300", "\"\"", "\"@\"",      "true", "[]",
                                              "{}", "[[1]]", "[{}]", "1979-05-27", "nan",  "\"x\""};
            // full.toml has every key, and takes a third of the values for each; the shipped study is long,
            // with texts in its midst: some of its lines.
            const bool full = path.filename() == "full.toml";
            const std::size_t values_a_line = full ? 4 : 2;
            int failures = 0;
            int tries = 0;
            const auto attempt = [&](const std::vector<std::string>& edited) {
                const std::string bytes = joined(edited);
                const fs::path file = folder.write(bytes);
                ++tries;
                CHECK_NOTHROW(checkErrors(file, bytes, failures));
            };
            for (std::size_t i = 0; i < lines.size(); i += full ? 1 : 3) {
                if (lines[i].empty() || lines[i].starts_with("#")) continue;  // which change nothing
                CAPTURE(i);
                CAPTURE(lines[i]);
                std::vector<std::string> edited = lines;
                edited.erase(edited.begin() + static_cast<std::ptrdiff_t>(i));
                attempt(edited);
                edited = lines;
                edited.insert(edited.begin() + static_cast<std::ptrdiff_t>(i), lines[i]);
                attempt(edited);
                const std::size_t equals = lines[i].find(" = ");
                if (equals == std::string::npos) continue;
                for (std::size_t k = 0; k < values_a_line; ++k) {
                    const char* value = values[(i + k * 5) % std::size(values)];
                    edited = lines;
                    edited[i] = lines[i].substr(0, equals) + " = " + value;
                    attempt(edited);
                }
                edited = lines;
                edited[i] = "x" + lines[i];
                attempt(edited);
            }
            CHECK(failures > tries / 2);
        }
    }
}
