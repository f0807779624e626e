#include "studies/study_file/study_source.hpp"

#include "studies/texts/toml_table.hpp"

namespace deixis::studies {

std::string avatarNamedIn(std::string_view source) {
    const auto table = parseToml("", source);
    if (!table) return {};
    return (*table)["study"]["avatar"].value_or(std::string());
}

std::optional<double> avatarHeightIn(std::string_view source) {
    const auto table = parseToml("", source);
    if (!table) return std::nullopt;
    return (*table)["study"]["avatar_height_m"].value<double>();
}

std::string studyNamedIn(std::string_view source) {
    const auto table = parseToml("", source);
    if (!table) return {};
    return (*table)["study"]["name"].value_or(std::string());
}

}  // namespace deixis::studies
