// The options that mean the same in every command (docs/command-line.md): each is declared here and nowhere
// else.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

namespace deixis::app {

/// -o, --output: what the command writes; `value` is FILE or DIR.
CLI::Option* addOutput(CLI::App& command, std::string& output, const std::string& what,
                       const char* value = "FILE");
/// The same where the file may also stand after the others without -o, as `positional`.
CLI::Option* addOutputLast(CLI::App& command, std::string& output, const std::string& what);

/// --force: what stands there is replaced.
CLI::Option* addForce(CLI::App& command, bool& force);

/// --json: what is printed is JSON.
CLI::Option* addJson(CLI::App& command, bool& json, const std::string& what);
/// --json [FILE]: without FILE, `json` becomes "-", standard output (written_output.hpp).
CLI::Option* addJsonOrFile(CLI::App& command, std::string& json);

/// --csv DIR: a folder for tables.
CLI::Option* addCsv(CLI::App& command, std::string& folder, const std::string& what);

CLI::Option* addSeed(CLI::App& command, std::uint64_t& seed, const std::string& of_what);
CLI::Option* addLanguage(CLI::App& command, std::string& language);

}  // namespace deixis::app
