#include "response_values.hpp"

namespace deixis::results {

std::vector<studies::KeptValue> readResponseValues(SQLite::Database& database, std::int64_t response) {
    SQLite::Statement row(
        database,
        "SELECT name, value, coalesce(text, '') FROM response_values WHERE response = ? ORDER BY name");
    row.bind(1, response);
    std::vector<studies::KeptValue> values;
    while (row.executeStep()) {
        studies::KeptValue& one = values.emplace_back(
            studies::KeptValue{row.getColumn(0).getString(), {}, row.getColumn(2).getString()});
        if (!row.getColumn(1).isNull()) one.value = row.getColumn(1).getDouble();
    }
    return values;
}

}  // namespace deixis::results
