// The options of every command that reads clip files.
#pragma once

#include "app/program/parser.hpp"
#include "assets/joints/clip_import.hpp"

namespace deixis::app {

/// --unit, --up, --fps and --animation, which override what a file says. `options` must outlive the parsing.
void addImportOptions(Parser command, assets::ImportOptions& options);
/// The same without --fps, for commands that mean another rate by it.
void addImportOptionsWithoutRate(Parser command, assets::ImportOptions& options);

/// "BVH, CSV of joint positions, ...", for a command's help.
extern const char* const clip_file_kinds;

}  // namespace deixis::app
