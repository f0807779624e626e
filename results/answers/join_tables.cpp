#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "core/hash.hpp"
#include "results/answers/response_table.hpp"
#include "results/tables/csv_table.hpp"

namespace deixis::results {

namespace {

void addOnce(std::vector<std::string>& known, const std::vector<std::string>& more) {
    for (const std::string& name : more)
        if (std::find(known.begin(), known.end(), name) == known.end()) known.push_back(name);
}

void joinFactors(std::vector<Factor>& to, const std::vector<Factor>& from) {
    for (const Factor& one : from) {
        const auto known =
            std::find_if(to.begin(), to.end(), [&](const Factor& f) { return f.name == one.name; });
        if (known == to.end())
            to.push_back(one);
        else
            addOnce(known->levels, one.levels);
    }
}

/// A row holds its levels in the order of its table's factors.
void joinWithin(ResponseTable& out, ResponseTable& next) {
    const std::vector<Factor> before = out.within;
    joinFactors(out.within, next.within);
    const auto reorder = [&](const std::vector<Factor>& from, std::vector<ResponseRow>& rows) {
        for (ResponseRow& row : rows) {
            std::vector<std::string> levels(out.within.size());
            for (std::size_t i = 0; i < from.size(); ++i)
                for (std::size_t k = 0; k < out.within.size(); ++k)
                    if (out.within[k].name == from[i].name) levels[k] = row.within[i];
            row.within = std::move(levels);
        }
    };
    reorder(before, out.rows);
    for (auto* rows : {&out.rows, &out.left_out_rows, &out.skipped_rows}) reorder(before, *rows);
    for (auto* rows : {&next.rows, &next.left_out_rows, &next.skipped_rows}) reorder(next.within, *rows);
}

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& from) {
    to.insert(to.end(), from.begin(), from.end());
}

/// The first that is of another kind than the one of its name; null: none.
const Measure* otherKind(const std::vector<Measure>& known, const std::vector<Measure>& next) {
    for (const Measure& one : next)
        for (const Measure& same : known)
            if (one.name == same.name && one.kind != same.kind) return &one;
    return nullptr;
}

void joinMeasures(std::vector<Measure>& to, const std::vector<Measure>& from) {
    for (const Measure& one : from) {
        const auto known =
            std::find_if(to.begin(), to.end(), [&](const Measure& m) { return m.name == one.name; });
        if (known == to.end()) {
            to.push_back(one);
            continue;
        }
        known->planned += one.planned;
        known->balls = std::max(known->balls, one.balls);
        known->min_balls = std::min(known->min_balls, one.min_balls);
        known->low = std::min(known->low, one.low);
        known->high = std::max(known->high, one.high);
    }
    std::stable_partition(to.begin(), to.end(),
                          [](const Measure& one) { return one.kind == MeasureKind::accuracy; });
}

void joinChecks(std::vector<CheckCount>& to, const std::vector<CheckCount>& from) {
    for (const CheckCount& one : from) {
        const auto known = std::find_if(to.begin(), to.end(), [&](const CheckCount& c) {
            return c.stage == one.stage && c.kind == one.kind;
        });
        if (known == to.end()) {
            to.push_back(one);
            continue;
        }
        known->passed += one.passed;
        known->failed += one.failed;
    }
}

}  // namespace

Result<ResponseTable> joinTables(std::vector<ResponseTable> tables) {
    ResponseTable out = std::move(tables.front());
    std::vector<std::string> files;
    std::map<std::string, std::size_t> file_of;  // by participant
    const auto claim = [&](const ResponseTable& table) -> Result<void> {
        files.push_back(table.database);
        for (const auto* rows : {&table.rows, &table.left_out_rows, &table.skipped_rows}) {
            for (const ResponseRow& row : *rows) {
                if (const auto [known, is_new] = file_of.try_emplace(row.participant, files.size() - 1);
                    !is_new && known->second != files.size() - 1)
                    return fail(
                        table.database,
                        fmt::format("participant {} is also in {}", row.participant, files[known->second]),
                        "Analyse one of the two, or give the participants different names");
            }
        }
        return {};
    };
    if (tables.size() > 1)
        if (auto claimed = claim(out); !claimed) return tl::unexpected(claimed.error());
    for (std::size_t i = 1; i < tables.size(); ++i) {
        ResponseTable& next = tables[i];
        if (next.study_hash != out.study_hash || next.alpha != out.alpha)
            return fail(next.database,
                        fmt::format("its study (SHA-256 {:.12}) is not that of {} ({:.12})", next.study_hash,
                                    out.database, out.study_hash),
                        "Only databases of the same study file can be analysed together");
        if (auto claimed = claim(next); !claimed) return tl::unexpected(claimed.error());
        if (const Measure* other = otherKind(out.measures, next.measures))
            return fail(
                next.database,
                fmt::format("\"{}\" has another kind of answers than in {}", other->name, out.database),
                "Give the two measures different names");
        addOnce(out.systems, next.systems);
        addOnce(out.built_in_systems, next.built_in_systems);
        if (next.processing) {
            if (!out.processing) out.processing.emplace();
            out.processing->insert(next.processing->begin(), next.processing->end());
        }
        out.not_compared.insert(next.not_compared.begin(), next.not_compared.end());
        addOnce(out.layouts, next.layouts);
        addOnce(out.distances, next.distances);
        joinFactors(out.between, next.between);
        joinWithin(out, next);
        out.groups.insert(next.groups.begin(), next.groups.end());
        out.failed_checks.insert(next.failed_checks.begin(), next.failed_checks.end());
        addOnce(out.program_versions, next.program_versions);
        addOnce(out.operating_systems, next.operating_systems);
        addOnce(out.avatar_hashes, next.avatar_hashes);
        joinMeasures(out.measures, next.measures);
        joinChecks(out.checks, next.checks);
        append(out.left_out, next.left_out);
        append(out.scores, next.scores);
        append(out.fields, next.fields);
        out.session_minutes.insert(next.session_minutes.begin(), next.session_minutes.end());
        append(out.stations, next.stations);
        append(out.notes, next.notes);
        append(out.rows, next.rows);
        append(out.left_out_rows, next.left_out_rows);
        append(out.skipped_rows, next.skipped_rows);
        append(out.choices, next.choices);
        out.target_positions.insert(next.target_positions.begin(), next.target_positions.end());
        append(out.watched, next.watched);
        out.planned_answers.insert(next.planned_answers.begin(), next.planned_answers.end());
        out.planned_participants += next.planned_participants;
        out.withdrawn += next.withdrawn;
        out.database += ", " + next.database;
    }
    const auto by_participant = [](const auto& a, const auto& b) { return a.participant < b.participant; };
    const auto sort = [&](auto& rows) {
        if (!std::is_sorted(rows.begin(), rows.end(), by_participant))
            std::stable_sort(rows.begin(), rows.end(), by_participant);
    };
    sort(out.rows);
    sort(out.left_out_rows);
    sort(out.skipped_rows);
    sort(out.choices);
    return out;
}

std::string answersHash(const ResponseTable& table) {
    constexpr std::size_t usual_row_bytes = 64;
    std::string text;
    text.reserve(table.rows.size() * usual_row_bytes);
    for (const ResponseRow& row : table.rows) {
        for (const std::string* one : {&row.participant, &row.measure, &row.system, &row.other_system,
                                       &row.layout, &row.distance, &row.target_id}) {
            text += *one;
            text += '\t';
        }
        appendNumber(text, row.value);
        text += '\n';
    }
    return sha256Hex(text);
}

}  // namespace deixis::results
