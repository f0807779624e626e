// The options that mean the same in every command (docs/command-line.md): each is declared only here.
#pragma once

#include <cstdint>
#include <string>

#include "app/program/parser.hpp"

namespace deixis::app {

/// -o, --output: what the command writes; `value` is FILE or DIR.
Option addOutput(Parser command, std::string& output, const std::string& what, const char* value = "FILE");
/// The same where the file may also stand after the others without -o, as `positional`.
Option addOutputLast(Parser command, std::string& output, const std::string& what);

/// --force: `what` ("pictures that are") there already is replaced.
Option addForce(Parser command, bool& force, const std::string& what = "what is");

/// --json: what is printed is JSON.
Option addJson(Parser command, bool& json, const std::string& what);
/// --json [FILE]: without FILE, `json` becomes "-", standard output (written_output.hpp).
Option addJsonOrFile(Parser command, std::string& json);

/// --csv DIR: a folder for tables.
Option addCsv(Parser command, std::string& folder, const std::string& what);

Option addSeed(Parser command, std::uint64_t& seed, const std::string& of_what);
Option addLanguage(Parser command, std::string& language);

}  // namespace deixis::app
