#include "results/database/migration_5.hpp"

#include <vector>

#include "results/database/schema.hpp"

namespace deixis::results {

const char* const before_tokens_sql =
    "SELECT p.id, s.started_utc_s, e.time_s, e.utc_s FROM participants AS p "
    "LEFT JOIN sessions AS s ON s.id = (SELECT min(id) FROM sessions WHERE participant = p.id) "
    "LEFT JOIN events AS e ON e.id = (SELECT min(id) FROM events WHERE session = s.id) ORDER BY p.id";

void migrateTo5(SQLite::Database& database) {
    database.exec(step_5);
    std::vector<BeforeTokens> everybody;
    SQLite::Statement row(database, before_tokens_sql);
    const auto number = [&](int column) -> std::optional<double> {
        if (row.getColumn(column).isNull()) return std::nullopt;
        return row.getColumn(column).getDouble();
    };
    while (row.executeStep())
        everybody.push_back({row.getColumn(0).getString(), number(1), number(2), number(3)});
    SQLite::Statement update(database, "UPDATE participants SET token = ? WHERE id = ?");
    for (const BeforeTokens& one : everybody) {
        const auto token = tokenFrom(one);
        if (!token) continue;
        update.bind(1, *token);
        update.bind(2, one.participant);
        update.exec();
        update.reset();
    }
}

}  // namespace deixis::results
