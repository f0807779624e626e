// What was asked, as an export tells it.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "export_files.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::results {

namespace {

using nlohmann::json;
using enum ColumnType;

struct Option {
    std::string id;
    std::string text;
    std::optional<double> step{};  ///< of a scale, in the place of `id`
};

/// A scale's labels stand at its steps, or spread evenly from end to end.
std::vector<Option> optionsOf(const std::string& options, const std::string& labels, double low,
                              double high) {
    std::vector<Option> out;
    if (!options.empty())
        for (const json& one : json::parse(options))
            out.push_back({one.at("id").get<std::string>(), one.at("text").get<std::string>()});
    if (!labels.empty()) {
        const auto texts = json::parse(labels).get<std::vector<std::string>>();
        for (std::size_t i = 0; i < texts.size(); ++i) {
            const double share =
                texts.size() < 2 ? 0.0 : static_cast<double>(i) / static_cast<double>(texts.size() - 1);
            out.push_back({"", texts[i], low + share * (high - low)});
        }
    }
    return out;
}

/// As an SQL list: kinds in which a ball is chosen.
std::string kindsWithBalls() {
    std::vector<std::string> names;
    for (const studies::StageDeclaration* kind : studies::allDeclarations())
        if (kind->balls) names.push_back(fmt::format("'{}'", kind->name));
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

ExportedFile questionsFile(SQLite::Database& database) {
    ExportedFile out{"questions.csv",
                     "What was asked, in the language of the database's first session: one row for each "
                     "option or labelled step of a question, or one for a question without any.",
                     CsvTable({{"stage", text, "Name of the stage in the study file"},
                               {"kind", text, "Kind of the stage"},
                               {"measure", text, "What a rating measures in the report"},
                               {"question", text, "As in responses.csv; choice: the game's"},
                               {"answer", text, "scale, choice, choices, number, text or ball"},
                               {"wording", text, "What the participant read"},
                               {"low", number, "Lowest possible answer"},
                               {"high", number, "Highest possible answer"},
                               {"option", text, "An option's id or a step's number: as in responses.csv"},
                               {"option_text", text, "What the participant read there"}})};
    SQLite::Statement rows(
        database,
        "SELECT s.name, s.kind, CASE WHEN q.question = 'rating' THEN s.measure END, q.question, q.kind, "
        "q.text, "
        "q.low, q.high, q.options, q.labels, s.position, q.position FROM questions AS q JOIN stages AS s ON "
        "s.name = q.stage UNION ALL SELECT name, kind, NULL, 'choice', 'ball', question, NULL, NULL, NULL, "
        "NULL, "
        "position, -1 FROM stages WHERE kind IN (" +
            kindsWithBalls() + ") ORDER BY 11, 12");
    while (rows.executeStep()) {
        auto options = optionsOf(rows.getColumn(8).getString(), rows.getColumn(9).getString(),
                                 rows.getColumn(6).getDouble(), rows.getColumn(7).getDouble());
        if (options.empty()) options.emplace_back();
        for (const Option& option : options) {
            for (int i = 0; i < 8; ++i) out.table.cell(rows.getColumn(i));
            if (option.step)
                out.table.number(*option.step);
            else
                out.table.text(option.id);
            out.table.text(option.text);
            out.table.endRow();
        }
    }
    return out;
}

}  // namespace deixis::results
