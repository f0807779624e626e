#include "long_table_warnings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "core/order_statistics.hpp"
#include "core/text.hpp"
#include "long_table_cells.hpp"

namespace deixis::results {

namespace {

/// Lowered, without spaces, and numbers without zeros before them: names that agree in it may be one.
std::string likeness(const std::string& name) {
    std::string out;
    for (const char c : plainWord(name)) {
        if (c == ' ' || c == '\t') continue;
        if (isDigit(c) && !out.empty() && out.back() == '0' &&
            (out.size() == 1 || !isDigit(out[out.size() - 2])))
            out.pop_back();
        out += c;
    }
    return out;
}

void warnNames(const std::set<std::string>& names, const std::string& of, std::vector<std::string>& notes) {
    std::map<std::string, std::vector<std::string>> alike;
    for (const std::string& name : names) alike[likeness(name)].push_back(fmt::format("\"{}\"", name));
    std::vector<std::string> doubtful;
    for (const auto& [key, together] : alike)
        if (together.size() > 1) doubtful.push_back(fmt::format("{}", fmt::join(together, " and ")));
    if (!doubtful.empty())
        notes.push_back(
            fmt::format("{} that differ only in case, spaces or zeros count as different: {}. If they are "
                        "the same, write them in the same way.",
                        of, fmt::join(doubtful, "; ")));
}

void warnAllNames(const ResponseTable& table, std::vector<std::string>& notes) {
    const auto setOf = [](const std::vector<std::string>& names) {
        return std::set<std::string>(names.begin(), names.end());
    };
    std::set<std::string> participants;
    std::set<std::string> items;
    for (const auto* rows : {&table.rows, &table.left_out_rows})
        for (const ResponseRow& row : *rows) {
            participants.insert(row.participant);
            if (!row.target_id.empty()) items.insert(row.target_id);
        }
    warnNames({participants.begin(), participants.end()}, "Participants", notes);
    warnNames(setOf(table.systems), "Systems", notes);
    warnNames(setOf(table.layouts), "Layouts", notes);
    warnNames(setOf(table.distances), "Distances", notes);
    warnNames({items.begin(), items.end()}, "Items", notes);
    std::set<std::string> measures;
    for (const Measure& measure : table.measures) measures.insert(measure.name);
    warnNames(measures, "Measures", notes);
    for (const auto* factors : {&table.between, &table.within})
        for (const Factor& factor : *factors)
            warnNames(setOf(factor.levels), fmt::format("Levels of {}", factor.name), notes);
}

/// Rows stand by participant. Without an item and a place among the trials two answers may be alike.
void warnDuplicates(const ResponseTable& table, std::vector<std::string>& notes) {
    int twice = 0;
    const ResponseRow* first = nullptr;
    const auto key = [](const ResponseRow& row) {
        return std::tie(row.trial, row.measure, row.system, row.other_system, row.target_id, row.layout,
                        row.distance, row.within);
    };
    std::vector<const ResponseRow*> of_one;
    const auto count = [&] {
        std::sort(of_one.begin(), of_one.end(),
                  [&](const auto* a, const auto* b) { return key(*a) < key(*b); });
        for (std::size_t i = 1; i < of_one.size(); ++i) {
            if (key(*of_one[i - 1]) != key(*of_one[i])) continue;
            ++twice;
            if (first == nullptr) first = of_one[i];
        }
        of_one.clear();
    };
    for (const auto* rows : {&table.rows, &table.left_out_rows}) {
        for (const ResponseRow& row : *rows) {
            if (!of_one.empty() && of_one.back()->participant != row.participant) count();
            if (row.trial >= 0 || !row.target_id.empty()) of_one.push_back(&row);
        }
        count();
    }
    if (first == nullptr) return;
    notes.push_back(
        fmt::format("{} {} the same participant, measure, system, item and position among the trials as "
                    "another one, such as {}'s of {} in {}{}: {} counted. Remove duplicates.",
                    twice, twice == 1 ? "answer has" : "answers have", first->participant, first->measure,
                    first->system, first->target_id.empty() ? "" : fmt::format(", item {}", first->target_id),
                    twice == 1 ? "it is" : "they are"));
}

/// Numbers by which other programs code that there is no answer.
void warnSentinels(const ResponseTable& table, std::vector<std::string>& notes) {
    constexpr std::array<double, 12> codes{-9999, -999, -99, -88, -77, -9, -1, 88, 99, 888, 999, 9999};
    struct Seen {
        double low = std::numeric_limits<double>::infinity();
        double high = -std::numeric_limits<double>::infinity();
        std::map<double, int> coded{};
    };
    std::map<std::string, Seen> by_measure;
    for (const ResponseRow& row : table.rows) {
        Seen& seen = by_measure[row.measure];
        if (std::find(codes.begin(), codes.end(), row.value) != codes.end()) {
            ++seen.coded[row.value];
            continue;
        }
        seen.low = std::min(seen.low, row.value);
        seen.high = std::max(seen.high, row.value);
    }
    for (const Measure& measure : table.measures) {
        if (measure.kind != MeasureKind::rating) continue;
        const Seen& of = by_measure[measure.name];
        const double range = of.high - of.low;
        for (const auto& [code, n] : of.coded)
            if (code < 0 ? of.low >= 0.0 && range >= 2.0 : code - of.high > range && range > 0.0)
                notes.push_back(fmt::format(
                    "{} {} of {} {} {:g}, far from the others ({:g} to {:g}), and {} counted. Empty these "
                    "cells if that means no answer; --scale {}={:g}..{:g} would reject them.",
                    n, n == 1 ? "answer" : "answers", measure.name, n == 1 ? "is" : "are", code, of.low,
                    of.high, n == 1 ? "is" : "are", measure.name, of.low, of.high));
    }
}

void warnTimes(const ResponseTable& table, std::vector<std::string>& notes) {
    constexpr double long_s = 100.0;
    std::vector<double> times;
    for (const ResponseRow& row : table.rows)
        if (row.response_time_s > 0.0) times.push_back(row.response_time_s);
    if (times.empty()) return;
    const double middle_s = upperMedian(times);
    if (middle_s >= long_s)
        notes.push_back(
            fmt::format("Half of the response times are {:g} s or longer. If the file has milliseconds, name "
                        "the column: --column rt_ms=NAME.",
                        middle_s));
}

void warnLetters(const ForeignCsv& csv, std::vector<std::string>& notes) {
    if (!csv.taken_for_windows_1252.empty())
        notes.push_back(
            fmt::format("The file is not in UTF-8 and was read as Windows-1252 (Latin-1), in which its first "
                        "letter beyond ASCII is \"{}\". If that is wrong, save it in UTF-8.",
                        csv.taken_for_windows_1252));
    // A capital A with a tilde before a sign: the two bytes of a letter, each taken for one.
    const auto at = csv.text.find("\xC3\x83\xC2");
    if (at != std::string::npos)
        notes.push_back(fmt::format(
            "Letters look as if UTF-8 had been read as Latin-1 and saved, the first in line {}.",
            1 + std::count(csv.text.begin(), csv.text.begin() + static_cast<std::ptrdiff_t>(at), '\n')));
}

}  // namespace

std::optional<std::string> warningOfUnread(const std::vector<std::string>& unread) {
    std::vector<std::string> found;
    for (const std::string& column : unread)
        for (const char* word : {"attention", "attn", "check", "catch", "fail", "exclu"})
            if (plainWord(column).find(word) != std::string::npos) {
                found.push_back(column);
                break;
            }
    if (found.empty()) return std::nullopt;
    return fmt::format(
        "{} may be about attention checks or exclusions, and {} not used. --column excluded={} leaves those "
        "participants out; --column attention={} treats marked lines as checks.",
        fmt::join(found, ", "), found.size() == 1 ? "is" : "are", found.front(), found.front());
}

void addWarnings(const ForeignCsv& csv, ResponseTable& table) {
    warnLetters(csv, table.notes);
    warnAllNames(table, table.notes);
    warnDuplicates(table, table.notes);
    warnSentinels(table, table.notes);
    warnTimes(table, table.notes);
}

}  // namespace deixis::results
