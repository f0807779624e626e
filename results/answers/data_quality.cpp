#include "results/answers/data_quality.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/order_statistics.hpp"
#include "rated_units.hpp"
#include "results/answers/response_table.hpp"
#include "results/statistics/descriptive.hpp"
#include "results/statistics/proportion.hpp"

namespace deixis::results {

namespace {

/// A participant's, those of a measure in their order.
using Rows = std::vector<const ResponseRow*>;

/// The rating given most often, the lowest of several such. A measure with enough answers to be judged goes
/// before one with fewer.
void judgeSame(const std::string& measure, std::vector<double> values, ParticipantQuality& out) {
    std::sort(values.begin(), values.end());
    const auto enough = [](std::size_t n) { return n >= studies::LeaveOutRule::min_answers; };
    for (auto first = values.begin(); first != values.end();) {
        const auto last = std::upper_bound(first, values.end(), *first);
        const double share = static_cast<double>(last - first) / static_cast<double>(values.size());
        if (std::pair(enough(values.size()), share) >
            std::pair(enough(static_cast<std::size_t>(out.same_of)), out.same_share)) {
            out.same_measure = measure;
            out.same_rating = *first;
            out.same_share = share;
            out.same_of = static_cast<int>(values.size());
        }
        first = last;
    }
}

int longestRun(const std::vector<double>& values) {
    int longest = 0;
    int run = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        run = i > 0 && values[i] == values[i - 1] ? run + 1 : 1;
        longest = std::max(longest, run);
    }
    return longest;
}

void judgeRatings(const ResponseTable& table, const Rows& rows, ParticipantQuality& out) {
    std::vector<double> values;
    for (const Measure& measure : table.measures) {
        if (measure.kind != MeasureKind::rating || !measure.unit.empty()) continue;
        values.clear();
        for (const ResponseRow* row : rows)
            if (row->measure == measure.name) values.push_back(row->value);
        if (values.empty()) continue;
        out.ratings += static_cast<int>(values.size());
        out.longest_run = std::max(out.longest_run, longestRun(values));
        judgeSame(measure.name, values, out);
    }
}

void judgeSides(const Rows& rows, ParticipantQuality& out) {
    for (const ResponseRow* row : rows)
        if (row->value != 0.0 && !row->other_system.empty()) {
            ++out.decided;
            out.left += row->value < 0.0;
        }
    if (out.decided > 0) out.p_side = proportion(out.left, out.decided, 0.95, 0.5).p_chance;
}

struct Time {
    std::size_t person;
    double time_s;
};

/// One for each trial, by the measure of its first answer.
std::unordered_map<std::string, std::vector<Time>> timesOf(const std::vector<Rows>& rows_of) {
    std::unordered_map<std::string, std::vector<Time>> out;
    for (std::size_t person = 0; person < rows_of.size(); ++person) {
        std::unordered_set<int> seen;
        for (const ResponseRow* row : rows_of[person])
            if (row->response_time_s > 0.0 && (row->trial < 0 || seen.insert(row->trial).second))
                out[row->measure].push_back({person, row->response_time_s});
    }
    return out;
}

void judgeTimes(const std::vector<Rows>& rows_of, std::vector<ParticipantQuality>& people) {
    constexpr double far = 3.0;
    constexpr double mad_of_normal = 1.4826;
    std::vector<std::vector<double>> own(people.size());
    for (const auto& [measure, times] : timesOf(rows_of)) {
        std::vector<double> logarithms;
        for (const Time& one : times) {
            own[one.person].push_back(one.time_s);
            if (!people[one.person].left_out) logarithms.push_back(std::log(one.time_s));
        }
        if (logarithms.empty()) continue;
        const double middle = median(logarithms);
        for (double& one : logarithms) one = std::abs(one - middle);
        const double spread = mad_of_normal * median(logarithms);
        if (spread <= 0.0) continue;
        for (const Time& one : times) {
            const double off = (std::log(one.time_s) - middle) / spread;
            people[one.person].fast += off < -far;
            people[one.person].slow += off > far;
        }
    }
    for (std::size_t i = 0; i < people.size(); ++i) {
        people[i].times = static_cast<int>(own[i].size());
        if (!own[i].empty()) people[i].median_s = median(own[i]);
    }
}

struct People {
    std::vector<ParticipantQuality> judged;  ///< by name
    std::vector<Rows> rows;                  ///< likewise
};

People participantsOf(const ResponseTable& table) {
    std::map<std::string, Rows> by_name;
    for (const auto* rows : {&table.rows, &table.left_out_rows})
        for (const ResponseRow& row : *rows) by_name[row.participant].push_back(&row);
    People out;
    for (auto& [name, rows] : by_name) {
        out.rows.push_back(std::move(rows));
        ParticipantQuality& one = out.judged.emplace_back();
        one.participant = name;
        one.left_out = !out.rows.back().front()->excluded.empty();
        if (!one.left_out) one.failed_check = table.failed_checks.contains(name);
    }
    return out;
}

/// Those who count and those who do not, without what depends on what others answered.
People judgedAlone(const ResponseTable& table) {
    People people = participantsOf(table);
    judgeTimes(people.rows, people.judged);
    for (std::size_t i = 0; i < people.judged.size(); ++i) {
        judgeRatings(table, people.rows[i], people.judged[i]);
        judgeSides(people.rows[i], people.judged[i]);
    }
    return people;
}

}  // namespace

DataQuality dataQuality(const ResponseTable& table) {
    People people = judgedAlone(table);
    const RatedUnits rated(table);
    for (std::size_t i = 0; i < people.judged.size(); ++i)
        people.judged[i].agreement = rated.agreement(people.rows[i]);
    return {std::move(people.judged), rated.reliability(table)};
}

std::map<std::string, std::string> leftOutByRule(const ResponseTable& table) {
    const studies::LeaveOutRule& rule = table.leave_out;
    constexpr int min = studies::LeaveOutRule::min_answers;
    std::map<std::string, std::string> out;
    if (!rule.declared()) return out;
    for (const ParticipantQuality& one : judgedAlone(table).judged) {
        if (one.left_out) continue;
        std::string why;
        const auto add = [&why](const std::string& reason) { why += (why.empty() ? "" : "; ") + reason; };
        if (rule.same_rating_share && one.same_of >= min && one.same_share >= *rule.same_rating_share)
            add(fmt::format("rated {:g} in {:.0f} of {} ({})", one.same_rating, one.same_share * one.same_of,
                            one.same_of, one.same_measure));
        const int side = std::max(one.left, one.decided - one.left);
        if (rule.one_side_share && one.decided >= min && side >= *rule.one_side_share * one.decided)
            add(fmt::format("preferred the {} one in {} of {} pairs", one.left == side ? "left" : "right",
                            side, one.decided));
        if (rule.median_time_below_s && one.times >= min && *one.median_s < *rule.median_time_below_s)
            add(fmt::format("median response time {:.2f} s", *one.median_s));
        if (!why.empty()) out[one.participant] = "by the study's rule: " + why;
    }
    return out;
}

}  // namespace deixis::results
