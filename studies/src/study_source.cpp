#include "studies/study_source.hpp"

#include "toml_table.hpp"

namespace deixis::studies {

std::string avatarNamedIn(std::string_view source) {
    const auto table = parseToml("", source);
    if (!table) return {};
    return (*table)["study"]["avatar"].value_or(std::string());
}

}  // namespace deixis::studies
