#include "report_details.hpp"

#include "report_people.hpp"
#include "results/page/report_tables.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace deixis::results {

namespace {

std::string chanceTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.chance.empty()) return "";
    const Measure accuracy = measureOf(result, "accuracy");
    const bool known = accuracy.balls > 1;
    std::string out = openTable(
        units::means_and_choices,
        fmt::format(
            "Correct choices of each system, over all participants{}.",
            known ? fmt::format(", and against chance ({}): signed-rank tests of participants' means of "
                                "correct choices less each trial's own chance. n counts participants",
                                ballsText(accuracy))
                  : ""),
        "<th>System</th><th>correct</th><th>of</th><th>Share</th><th>Chance</th><th>Mean above</th><th>n</th>"
        "<th>p</th><th>p (Holm)</th>",
        numbering);
    for (const ChanceResult& one : result.chance) {
        const bool tested = one.test.n_pairs > 0 && result.participants > 1;
        out += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
            "<td>{}</td><td>{}</td></tr>",
            escapeHtml(one.system), one.successes, one.n,
            one.n > 0 ? scoreText(accuracy, static_cast<double>(one.successes) / one.n) : dash,
            one.n_known > 0 ? scoreText(accuracy, one.chance) : dash,
            one.n_known > 0 ? scoreText(accuracy, one.mean_above) : dash, one.test.n_pairs,
            tested ? pText(one.test.p_two_sided) : dash, tested ? pText(one.p_holm) : dash);
    }
    return out + close_table;
}

std::string unansweredTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.unanswered.empty()) return "";
    const Measure accuracy = measureOf(result, "accuracy");
    std::string out = openTable(
        units::means_and_choices,
        "Choices that were not made. A choice that timed out counts as wrong; one that the experimenter "
        "skipped is left out. Accuracy (means of participants' means) in this way, of the choices that were "
        "made alone, and with all others as wrong.",
        "<th>System</th><th>made</th><th>timed out</th><th>skipped</th><th>Accuracy</th><th>made alone</th>"
        "<th>all others wrong</th>",
        numbering);
    const auto share = [&](const std::optional<double>& mean) {
        return mean ? scoreText(accuracy, *mean) : std::string(dash);
    };
    for (const UnansweredResult& one : result.unanswered)
        out += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
            "</tr>",
            escapeHtml(one.system), one.answered, one.timed_out, one.skipped, share(one.headline),
            share(one.answered_only), share(one.unanswered_wrong));
    return out + close_table;
}

std::string orderTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.order.empty() || result.participants < 2) return "";
    std::string out = openTable(
        units::means,
        "Answers while a participant goes on: first and second half of each participant's answers, "
        "signed-rank test over participants, Holm over the measures.",
        "<th>Measure</th><th>First half</th><th>Second half</th><th>n</th><th>p</th><th>p (Holm)</th>",
        numbering);
    for (const OrderResult& one : result.order) {
        const Measure measure = measureOf(result, one.measure);
        out += fmt::format(
            "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
            escapeHtml(capitalised(one.measure)), scoreText(measure, one.first),
            scoreText(measure, one.second), one.test.n_pairs, pText(one.test.p_two_sided), pText(one.p_holm));
    }
    return out + close_table;
}

std::string timesTable(const AnalysisResult& result, Numbering& numbering) {
    if (result.times.empty()) return "";
    std::string out =
        openTable(units::answers, "Response times over answers, seconds.",
                  "<th>Measure</th><th class=\"text\">System</th><th>25&#160;%</th><th>Median</th>"
                  "<th>75&#160;%</th><th>n</th>",
                  numbering);
    for (const TimeResult& one : result.times)
        out += fmt::format(
            "<tr><th scope=\"row\">{}</th><td "
            "class=\"text\">{}</td><td>{:.2f}</td><td>{:.2f}</td><td>{:.2f}</td>"
            "<td>{}</td></tr>",
            escapeHtml(capitalised(one.measure)), escapeHtml(one.system), one.q25_s, one.median_s, one.q75_s,
            one.n);
    return out + close_table;
}

std::string itemsTable(const AnalysisResult& result, Numbering& numbering) {
    constexpr std::size_t most_shown = 5;
    std::string rows;
    for (const Measure& measure : result.measures) {
        std::vector<const ItemResult*> items;
        for (const ItemResult& one : result.items)
            if (one.measure == measure.name) items.push_back(&one);
        if (items.size() < 2) continue;
        const auto row = [&](const ItemResult& one, const char* end) {
            rows += fmt::format(
                "<tr><th scope=\"row\">{}</th><td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}</td>"
                "<td>{}</td></tr>",
                escapeHtml(capitalised(measure.name)), end, escapeHtml(one.item),
                scoreText(measure, one.mean), one.n);
        };
        const std::size_t shown = std::min(most_shown, items.size() / 2);
        for (std::size_t i = 0; i < shown; ++i) row(*items[i], "lowest");
        for (std::size_t i = items.size() - shown; i < items.size(); ++i) row(*items[i], "highest");
    }
    if (rows.empty()) return "";
    return openTable(
               units::answers,
               "Items with the lowest and the highest means, over systems and participants. All of them: "
               "<code>--csv</code>.",
               "<th>Measure</th><th class=\"text\"></th><th class=\"text\">Item</th><th>Mean</th><th>n</th>",
               numbering) +
           rows + close_table;
}

}  // namespace

std::string detailsHtml(const AnalysisResult& result, Numbering& numbering) {
    // One after another: the tables count.
    std::string tables = chanceTable(result, numbering);
    tables += unansweredTable(result, numbering);
    tables += orderTable(result, numbering);
    tables += timesTable(result, numbering);
    tables += timeTestsHtml(result, numbering);
    tables += itemsTable(result, numbering);
    return tables.empty() ? "" : "<h2>Chance, order, time and items</h2>" + tables;
}

std::string presenceHtml(const AnalysisResult& result, Numbering& numbering) {
    bool even = true;
    for (std::size_t m = 0; m < result.measures.size(); ++m)
        for (const PresenceRow& row : result.presence)
            for (const int answers : row.answers[m])
                even = even && answers == result.presence.front().answers[m].front();
    if (even) return "";
    std::string over;
    std::string names;
    for (const Measure& measure : result.measures) {
        over += fmt::format("<th colspan=\"{}\">{}</th>", result.systems.size(),
                            escapeHtml(capitalised(measure.name)));
        for (const SystemResult& system : result.systems)
            names += fmt::format("<th>{}</th>", escapeHtml(system.system));
    }
    const std::string number = numbering.next();
    std::string out = fmt::format(
        "<h2>Who answered what</h2>{}<table><caption>{} Answers of each participant on each system. "
        "{}</caption>"
        "<thead><tr class=\"over\"><th></th>{}</tr><tr><th>Participant</th>{}</tr></thead><tbody>",
        openScroll(numbering.name()), number, unitText(units::answers), over, names);
    for (const PresenceRow& row : result.presence) {
        out += fmt::format("<tr><th scope=\"row\">{}</th>", escapeHtml(row.participant));
        for (const auto& of_measure : row.answers)
            for (const int answers : of_measure)
                out += answers > 0 ? fmt::format("<td>{}</td>", answers)
                                   : fmt::format("<td class=\"missing\">{}</td>", "none");
        out += "</tr>";
    }
    return out + close_table;
}

}  // namespace deixis::results
