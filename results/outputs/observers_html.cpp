#include "results/outputs/observers_html.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "results/outputs/analysis_tables.hpp"
#include "results/page/html_table.hpp"

namespace deixis::results {

namespace {

std::string percent(double share) {
    return fixedText(100.0 * share, 1) + "\u00a0%";
}

std::string ranked(const ObserverRanking& ranking) {
    std::string out;
    for (const auto& group : ranking)
        for (const std::string& system : group)
            out += (out.empty() ? "" : system == group.front() ? " &gt; " : " ≈ ") + escapeHtml(system);
    return out;
}

}  // namespace

std::string observersFinding(const std::vector<ObserverReading>& readings) {
    if (readings.empty()) return "";
    std::string out =
        "What a simulated observer chooses after the same arms depends on how it reads pointing. Its "
        "expected "
        "accuracy, from the lowest to the highest over " +
        fmt::format("{} observers: ", observer_names.size());
    std::string last;
    std::string spreads;
    for (const ObserverReading& one : readings) {
        if (one.system == last) continue;
        last = one.system;
        const auto [min, max] = std::minmax_element(one.accuracy.begin(), one.accuracy.end());
        spreads += fmt::format("{}{} {} to {}", spreads.empty() ? "" : ", ", strongHtml(one.system),
                               fixedText(100.0 * *min, 1), percent(*max));
    }
    out += spreads + ".";
    const auto rankings = observerRankings(readings);
    if (readings.front().system != last) {  // there are several
        const bool agree = std::all_of(rankings.begin(), rankings.end(),
                                       [&](const auto& one) { return one == rankings.front(); });
        if (agree) {
            out += " All rank them in the same order: " + ranked(rankings.front()) + ".";
        } else {
            out += " They rank them in different orders: ";
            for (std::size_t i = 0; i < observer_names.size(); ++i)
                out += fmt::format("{}by {}, {}", i == 0 ? "" : "; ", observer_names[i], ranked(rankings[i]));
            out += ".";
        }
        const bool groups = std::any_of(rankings.begin(), rankings.end(), [](const auto& ranking) {
            return std::any_of(ranking.begin(), ranking.end(),
                               [](const auto& group) { return group.size() > 1; });
        });
        if (groups) out += " (≈: within one percentage point.)";
    }
    return out + " None of them has been shown to read as people do.";
}

std::string observersTable(const std::vector<ObserverReading>& readings, const char* trials,
                           Numbering& numbering) {
    if (readings.empty()) return "";
    Table all = tables::observers(readings, trials);
    const auto cell = [&](const char* column) {
        return [place = all.at(column)](const Table::Row& row) -> Cell {
            return percent(*row.cells[place].as<double>());
        };
    };
    const std::size_t of = all.at(trials);
    for (Table::Row& row : all.rows) row.cells[of] = fmt::format("{:.0f}", *row.cells[of].as<double>());
    return tableHtml(
        wide(all, {"system", "layout", trials}, "observer", {observer_names.begin(), observer_names.end()},
             {{[](const std::string& observer) { return observer; }, cell("accuracy")},
              {[](const std::string&) { return "without error"; }, cell("without_error")}}),
        "Expected correct choices of simulated observers after the same arms and with the same balls, with "
        "the default noise and lapses; \u201cwithout error\u201d: with neither, the share in which the "
        "target is what is read. two-cue: the lines of eye and arm and the finger\u2019s place in the "
        "observer\u2019s view, each a reading; arm-finger: the line from the elbow through the fingertip; "
        "eye-fingertip: the line from the avatar\u2019s eye. No evidence about people.",
        numbering, dense_table);
}

std::string nearestText(const NearestCeiling& ceiling) {
    return fmt::format(
        "A system that plays the demonstration with the nearest target would point {} m beside the test "
        "target (median over {}); an observer without error, who sees the balls from between the "
        "avatar’s eyes, would then be correct in {}.",
        fixedText(ceiling.median_distance_m, 2), ceiling.targets, percent(ceiling.share_right));
}

}  // namespace deixis::results
