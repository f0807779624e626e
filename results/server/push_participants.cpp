#include "push_participants.hpp"

#include <fmt/core.h>

#include <utility>

#include "core/hash.hpp"

namespace deixis::results {

namespace {

using SQLite::Statement;

constexpr std::size_t statement_bytes = 1 << 20;  ///< rows are sent together up to about this much

bool isColumn(const char* name, const TableColumn& column) {
    return name != nullptr && column.name == name;
}

/// Whether a row is known by its place among the participant's.
bool knownByPlace(const ParticipantTable& table) {
    return table.own_id != nullptr && std::string_view(table.key) == table.own_id;
}

std::string order(const ParticipantTable& table) {
    return table.own_id != nullptr ? fmt::format(" ORDER BY {}", table.own_id) : "";
}

std::string namesOf(const std::vector<TableColumn>& columns) {
    std::string out;
    for (const TableColumn& column : columns) out += (out.empty() ? "" : ", ") + column.name;
    return out;
}

/// The same text for the same value, whichever database it comes from; of bytes their hash.
std::optional<std::string> cellOf(const SQLite::Column& value) {
    if (value.isNull()) return std::nullopt;
    if (value.isFloat()) return fmt::format("{}", value.getDouble());
    if (value.isBlob())
        return sha256Hex(
            {static_cast<const char*>(value.getBlob()), static_cast<std::size_t>(value.getBytes())});
    return value.getString();
}

std::optional<std::string> cellOf(const std::optional<std::string>& text, const TableColumn& column) {
    if (!text || column.type != "REAL") return text;
    return fmt::format("{}", numberIn<double>(*text));
}

}  // namespace

std::string rowsOf(const ParticipantTable& table, const std::string& participant) {
    std::string out = table.participant_rows;
    return out.replace(out.find("?1"), 2, participant);
}

std::string ParticipantPush::literal(const SQLite::Column& value) {
    if (value.isNull()) return "NULL";
    if (value.isFloat()) return fmt::format("'{}'", value.getDouble());
    if (!value.isBlob()) return server_.quoted(value.getString());
    constexpr const char* digits = "0123456789abcdef";
    const auto* bytes = static_cast<const unsigned char*>(value.getBlob());
    std::string out = "'\\x";
    out.reserve(2 * static_cast<std::size_t>(value.getBytes()) + 4);
    for (int i = 0; i < value.getBytes(); ++i) {
        out += digits[bytes[i] >> 4];
        out += digits[bytes[i] & 15];
    }
    return out + "'";
}

std::int64_t ParticipantPush::nextId(const std::string& table) {
    const auto [known, is_new] = next_id_.try_emplace(table, 0);
    if (is_new)
        known->second =
            numberIn<std::int64_t>(server_.value("SELECT coalesce(max(id), 0) FROM " + table).value());
    return ++known->second;
}

void ParticipantPush::flush(const std::string& into, std::string& values, std::size_t enough) {
    if (values.size() <= enough) return;
    server_.run(into + values);
    values.clear();
}

void ParticipantPush::pushWhole(const std::string& table) {
    const std::vector<TableColumn> columns = columnsOf(file_, table);
    const std::string into = fmt::format("INSERT INTO {} ({}) VALUES ", table, namesOf(columns));
    std::string values;
    Statement rows(file_, fmt::format("SELECT {} FROM {} ORDER BY 1", namesOf(columns), table));
    while (rows.executeStep()) {
        values += values.empty() ? "(" : ", (";
        for (int i = 0; i < rows.getColumnCount(); ++i)
            values += (i > 0 ? ", " : "") + literal(rows.getColumn(i));
        values += ")";
        ++outcome_.rows;
    }
    flush(into, values, 0);
}

Result<void> ParticipantPush::push(const std::string& participant) {
    counted_.clear();
    server_.run("SAVEPOINT participant");
    PushedRows all;
    std::map<std::string, long long> added;
    for (const ParticipantTable& table : participant_tables) {
        const auto pushed = pushTable(table, participant);
        if (!pushed) return tl::unexpected(pushed.error());
        added[table.name] = pushed->added;
        all.added += pushed->added;
        all.changed += pushed->changed;
        all.older = all.older || pushed->older;
    }
    if (all.older && all.added > 0)
        return fail(
            path_.string(),
            fmt::format(
                "participant {} continued in two files: this one and {} each have rows that the other lacks",
                participant, address_.shown),
            "Run each participant's sessions into one file");
    if (all.older) {
        server_.run("ROLLBACK TO SAVEPOINT participant");
        outcome_.older.push_back(participant);
        return {};
    }
    server_.run("RELEASE SAVEPOINT participant");
    outcome_.participants += added["participants"];
    outcome_.sessions += added["sessions"];
    outcome_.responses += added["responses"];
    outcome_.rows += all.added;
    outcome_.changed += all.changed;
    return {};
}

Result<ParticipantPush::PushedRows> ParticipantPush::pushTable(const ParticipantTable& table,
                                                               const std::string& participant) {
    const std::vector<TableColumn> columns = columnsOf(file_, table.name);
    std::vector<bool> is_new;
    auto pushed = compare(table, columns, participant, fetch(table, columns, participant), is_new);
    if (pushed && pushed->added > 0) insertNew(table, columns, participant, is_new);
    return pushed;
}

std::map<std::string, ParticipantPush::Known> ParticipantPush::fetch(const ParticipantTable& table,
                                                                     const std::vector<TableColumn>& columns,
                                                                     const std::string& participant) {
    std::string names;
    for (const TableColumn& column : columns)
        names +=
            (names.empty() ? "" : ", ") +
            (column.type == "BLOB" ? fmt::format("encode(sha256({}), 'hex')", column.name) : column.name);
    const pqxx::result rows =
        server_.run(fmt::format("SELECT {} FROM {} WHERE {}{}", names, table.name,
                                rowsOf(table, server_.quoted(participant)), order(table)));
    Counted& counted = counted_[table.name];
    std::map<std::string, Known> out;
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        Known known;
        std::string key;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            Cell cell = cellOf(textOf(rows, i, static_cast<int>(c)), columns[c]);
            if (isColumn(table.own_id, columns[c])) {
                known.server_id = numberIn<std::int64_t>(*cell);
                cell = std::to_string(i + 1);
                counted.place_on_server[known.server_id] = i + 1;
                counted.server_id[i + 1] = known.server_id;
            } else if (isColumn(table.session, columns[c])) {
                cell = std::to_string(counted_["sessions"].place_on_server.at(numberIn<std::int64_t>(*cell)));
            } else if (isColumn(table.response, columns[c])) {
                cell =
                    std::to_string(counted_["responses"].place_on_server.at(numberIn<std::int64_t>(*cell)));
            }
            if (isListed(table.key, columns[c].name)) key += *cell + "\n";
            known.cells.push_back(std::move(cell));
        }
        out.emplace(std::move(key), std::move(known));
    }
    return out;
}

Result<ParticipantPush::PushedRows> ParticipantPush::compare(const ParticipantTable& table,
                                                             const std::vector<TableColumn>& columns,
                                                             const std::string& participant,
                                                             std::map<std::string, Known> there,
                                                             std::vector<bool>& is_new) {
    PushedRows pushed;
    Counted& counted = counted_[table.name];
    Statement rows(file_, fmt::format("SELECT {} FROM {} WHERE {}{}", namesOf(columns), table.name,
                                      table.participant_rows, order(table)));
    rows.bind(1, participant);
    while (rows.executeStep()) {
        const int place = static_cast<int>(is_new.size()) + 1;
        const auto placeOf = [&](std::size_t c) -> std::optional<int> {
            const SQLite::Column value = rows.getColumn(static_cast<int>(c));
            if (isColumn(table.own_id, columns[c])) return place;
            if (isColumn(table.session, columns[c]))
                return counted_["sessions"].place_in_file.at(value.getInt64());
            if (isColumn(table.response, columns[c]))
                return counted_["responses"].place_in_file.at(value.getInt64());
            return std::nullopt;
        };
        const auto cellAt = [&](std::size_t c) -> Cell {
            if (const auto counted_place = placeOf(c)) return std::to_string(*counted_place);
            return cellOf(rows.getColumn(static_cast<int>(c)));
        };
        std::string key, shown_key;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (isColumn(table.own_id, columns[c]))
                counted.place_in_file[rows.getColumn(static_cast<int>(c)).getInt64()] = place;
            if (!isListed(table.key, columns[c].name)) continue;
            const Cell cell = cellAt(c);
            key += *cell + "\n";
            shown_key += fmt::format(", {} {}", columns[c].name, *cell);
        }
        const auto known = there.find(key);
        is_new.push_back(known == there.end());
        if (known == there.end()) {
            ++pushed.added;
            continue;
        }
        std::string changes;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (isColumn(table.own_id, columns[c]) || cellAt(c) == known->second.cells[c]) continue;
            const bool filled = isListed(table.filled_later, columns[c].name);
            if (filled && !cellAt(c)) continue;
            if (!isListed(table.changing, columns[c].name) && !(filled && !known->second.cells[c]))
                return fail(path_.string(),
                            fmt::format("table {}, participant {}{}: {} is not what {} has", table.name,
                                        participant, shown_key, columns[c].name, address_.shown),
                            "What is stored there is never altered. Does another person have the same id, or "
                            "was the file changed?");
            changes += fmt::format("{}{} = {}", changes.empty() ? "" : ", ", columns[c].name,
                                   literal(rows.getColumn(static_cast<int>(c))));
        }
        if (!changes.empty()) {
            std::string which = rowsOf(table, server_.quoted(participant));
            if (knownByPlace(table)) {
                which = fmt::format("{} = {}", table.own_id, known->second.server_id);
            } else {
                for (std::size_t c = 0; c < columns.size(); ++c)
                    if (isListed(table.key, columns[c].name))
                        which += fmt::format(
                            " AND {} = {}", columns[c].name,
                            literalOnServer(table, columns[c], rows.getColumn(static_cast<int>(c))));
            }
            server_.run(fmt::format("UPDATE {} SET {} WHERE {}", table.name, changes, which));
            ++pushed.changed;
        }
        there.erase(known);
    }
    pushed.older = !there.empty();
    return pushed;
}

std::string ParticipantPush::literalOnServer(const ParticipantTable& table, const TableColumn& column,
                                             const SQLite::Column& value) {
    const char* counts = isColumn(table.session, column)    ? "sessions"
                         : isColumn(table.response, column) ? "responses"
                                                            : nullptr;
    if (counts == nullptr) return literal(value);
    Counted& counted = counted_[counts];
    return std::to_string(counted.server_id.at(counted.place_in_file.at(value.getInt64())));
}

void ParticipantPush::insertNew(const ParticipantTable& table, const std::vector<TableColumn>& columns,
                                const std::string& participant, const std::vector<bool>& is_new) {
    Counted& counted = counted_[table.name];
    const std::string into = fmt::format("INSERT INTO {} ({}) VALUES ", table.name, namesOf(columns));
    std::string values;
    Statement rows(file_, fmt::format("SELECT {} FROM {} WHERE {}{}", namesOf(columns), table.name,
                                      table.participant_rows, order(table)));
    rows.bind(1, participant);
    for (std::size_t row = 0; rows.executeStep(); ++row) {
        if (!is_new[row]) continue;
        values += values.empty() ? "(" : ", (";
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (c > 0) values += ", ";
            if (isColumn(table.own_id, columns[c])) {
                const std::int64_t id = nextId(table.name);
                counted.server_id[static_cast<int>(row) + 1] = id;
                values += std::to_string(id);
            } else {
                values += literalOnServer(table, columns[c], rows.getColumn(static_cast<int>(c)));
            }
        }
        values += ")";
        flush(into, values, statement_bytes);
    }
    flush(into, values, 0);
}

}  // namespace deixis::results
