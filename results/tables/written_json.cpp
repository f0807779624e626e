#include "results/tables/written_json.hpp"

#include <fmt/format.h>

#include "core/files.hpp"

namespace deixis::results {

WrittenJson writtenEvaluation() {
    return {"objective evaluation", "deixis evaluate ... --json FILE",
            [](const Json& json) { return json.value("format", Json()) == "deixis-evaluation"; }};
}

WrittenJson writtenAnalysis() {
    return {"analysis", "deixis report ... --json FILE", [](const Json& json) {
                const Json schema = json.value("schema", Json());
                return schema.is_object() && schema.value("name", Json()) == "deixis-analysis";
            }};
}

Result<void> readWritten(const std::filesystem::path& file, const WrittenJson& expected,
                         const std::function<Result<void>(const Json&)>& read) {
    const auto text = readFile(file);
    if (!text) return tl::unexpected(text.error());
    const Json json = Json::parse(*text, nullptr, false);
    const std::string hint = fmt::format("Expected the JSON that '{}' writes", expected.command);
    if (!json.is_object() || !expected.is_it(json))
        return fail(file.string(), "is no " + expected.what, hint);
    try {
        return read(json);
    } catch (const Json::exception& problem) {
        return fail(file.string(), fmt::format("is damaged: {}", problem.what()), hint);
    }
}

}  // namespace deixis::results
