// What columns are called that many tables have; private to the tables.
#pragma once

#include <string_view>

#include "results/tables/table.hpp"

namespace deixis::results {

struct ColumnWords {
    std::string_view name;
    const char* label = nullptr;  ///< on a page; else the name in words
    const char* latex = nullptr;  ///< likewise in print, LaTeX
    Format format = Format::plain;
};

[[nodiscard]] ColumnWords columnWords(std::string_view name);

}  // namespace deixis::results
