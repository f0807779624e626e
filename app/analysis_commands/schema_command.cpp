// deixis schema: the JSON Schemas of what the program writes as JSON.
#include <fmt/format.h>

#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "app/analysis_commands/analysis_commands.hpp"
#include "app/program/command_help.hpp"
#include "assets/data/data_paths.hpp"
#include "core/files.hpp"

namespace deixis::app {

namespace {

constexpr std::array schema_names{"analysis", "plan", "evaluation", "trace"};

Result<void> printSchemas(const std::string& name) {
    for (const std::string one : schema_names) {
        if (!name.empty() && one != name) continue;
        const auto file = assets::dataFile(fmt::format("schemas/{}.schema.json", one));
        const auto text = readFile(file);
        if (!text) return tl::unexpected(text.error());
        if (name.empty())
            fmt::print("{:<10}  {}\n            {}\n", one,
                       nlohmann::json::parse(*text).at("description").get<std::string>(), file.string());
        else
            fmt::print("{}", *text);
    }
    return {};
}

}  // namespace

void addSchemaCommand(Parser cli, Command& chosen) {
    auto name = std::make_shared<std::string>();
    Parser command = cli.addCommand("schema", "Print the JSON Schema of an output, or list all schemas");
    describe(command, {.writes = "nothing; it prints the schema.",
                       .example = "deixis schema analysis",
                       .page = "docs/data-out.md"});
    command.addOption("NAME", *name, "analysis, plan, evaluation or trace [lists them, with their files]")
        .check(OneOf{{schema_names.begin(), schema_names.end()}});
    command.callback([name, &chosen] { chosen = [name] { return printSchemas(*name); }; });
}

}  // namespace deixis::app
