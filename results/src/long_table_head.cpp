#include "long_table_head.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "long_table_cells.hpp"

namespace deixis::results {

namespace {

constexpr std::array<std::string_view, long_column_count> long_column_names{
    "participant", "system",    "correct", "rating",   "response", "stage",  "measure",
    "layout",      "distance",  "trial",   "order",    "item",     "rt",     "attention",
    "practice",    "synthetic", "balls",   "excluded", "marked",   "status", "station"};

class HeadReader {
  public:
    using enum LongColumn;

    HeadReader(const CsvRecord& record, const std::string& file, const FactorColumns& factors)
        : record_(record), file_(file), factors_(factors) {}

    Result<LongHead> read() {
        head_.width = record_.fields.size();
        for (std::size_t i = 0; i < head_.width; ++i)
            if (auto known = readColumn(i); !known) return tl::unexpected(known.error());
        for (const LongColumn needed : {participant, system})
            if (!head_.place(needed))
                return fail(file_, fmt::format("has no column \"{}\"", nameOf(needed)),
                            "A long table has one line an answer, with columns participant, system, and "
                            "correct, rating or response");
        if (!head_.place(correct) && !head_.place(rating) && !head_.place(response))
            return fail(file_, "has none of the columns \"correct\", \"rating\" and \"response\"",
                        "Name the column of the answers so");
        for (const std::string& name : factors_.between)
            if (auto found = addFactor(name, "--between", head_.between); !found)
                return tl::unexpected(found.error());
        for (const std::string& name : factors_.within)
            if (auto found = addFactor(name, "--within", head_.within); !found)
                return tl::unexpected(found.error());
        return std::move(head_);
    }

  private:
    Result<void> readColumn(std::size_t i) {
        std::string name = lowered(record_.fields[i]);
        if (name == "response_time_s") name = nameOf(rt);
        const auto known = std::find(long_column_names.begin(), long_column_names.end(), name);
        if (known == long_column_names.end()) {
            if (!isFactor(i)) head_.unread.push_back(record_.fields[i]);
            return {};
        }
        auto& place = head_.places[static_cast<std::size_t>(known - long_column_names.begin())];
        if (place)
            return fail(file_, fmt::format("has several columns \"{}\"", name), "Name them differently");
        place = i;
        return {};
    }

    [[nodiscard]] bool isFactor(std::size_t column) const {
        const auto names = [&](const std::string& name) {
            return lowered(name) == lowered(record_.fields[column]);
        };
        return std::any_of(factors_.between.begin(), factors_.between.end(), names) ||
               std::any_of(factors_.within.begin(), factors_.within.end(), names);
    }

    Result<void> addFactor(const std::string& name, const char* option, std::vector<std::size_t>& places) {
        const std::string wanted = lowered(name);
        if (std::find(long_column_names.begin(), long_column_names.end(), wanted) != long_column_names.end())
            return fail(file_, fmt::format("{} {}: this column has a meaning of its own", option, name),
                        "Name another column");
        const auto taken = [&](std::size_t i) {
            return std::count(head_.between.begin(), head_.between.end(), i) +
                       std::count(head_.within.begin(), head_.within.end(), i) >
                   0;
        };
        std::optional<std::size_t> found;
        for (std::size_t i = 0; i < head_.width; ++i) {
            if (lowered(record_.fields[i]) != wanted) continue;
            if (found || taken(i))
                return fail(file_, fmt::format("{} {}: the column stands twice", option, name));
            found = i;
        }
        if (!found)
            return fail(file_, fmt::format("{} {}: there is no such column", option, name),
                        fmt::format("The columns are {}", fmt::join(record_.fields, ", ")));
        places.push_back(*found);
        return {};
    }

    const CsvRecord& record_;
    const std::string& file_;
    const FactorColumns& factors_;
    LongHead head_;
};

}  // namespace

std::string_view nameOf(LongColumn column) {
    return long_column_names[static_cast<std::size_t>(column)];
}

Result<LongHead> readLongHead(const CsvRecord& record, const std::string& file,
                              const FactorColumns& factors) {
    return HeadReader(record, file, factors).read();
}

}  // namespace deixis::results
