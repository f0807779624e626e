// A CSV file of ours by its columns' names.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/csv.hpp"

namespace deixis::tests {

struct CsvTable {
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows;

    explicit CsvTable(const std::string& bytes) {
        const auto records = parseCsv(bytes, "a table");
        REQUIRE(records);
        REQUIRE_FALSE(records->empty());
        header = records->front().fields;
        for (std::size_t i = 1; i < records->size(); ++i) rows.push_back((*records)[i].fields);
    }
    [[nodiscard]] std::size_t column(const std::string& name) const {
        const auto found = std::find(header.begin(), header.end(), name);
        REQUIRE_MESSAGE(found != header.end(), name);
        return static_cast<std::size_t>(found - header.begin());
    }
    [[nodiscard]] const std::string& cell(std::size_t row, const std::string& name) const {
        return rows.at(row).at(column(name));
    }
    /// The rows that say so in these columns.
    [[nodiscard]] std::vector<std::size_t> find(
        const std::vector<std::pair<std::string, std::string>>& said) const {
        std::vector<std::size_t> out;
        for (std::size_t row = 0; row < rows.size(); ++row)
            if (std::all_of(said.begin(), said.end(),
                            [&](const auto& one) { return cell(row, one.first) == one.second; }))
                out.push_back(row);
        return out;
    }
    /// Those rows, cells by their columns' names.
    [[nodiscard]] std::vector<std::map<std::string, std::string>> having(
        const std::vector<std::pair<std::string, std::string>>& said) const {
        std::vector<std::map<std::string, std::string>> out;
        for (const std::size_t row : find(said)) {
            auto& one = out.emplace_back();
            for (std::size_t i = 0; i < header.size(); ++i) one[header[i]] = rows[row][i];
        }
        return out;
    }
    [[nodiscard]] bool has(const std::vector<std::pair<std::string, std::string>>& said) const {
        return !find(said).empty();
    }
};

}  // namespace deixis::tests
