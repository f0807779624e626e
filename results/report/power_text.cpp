// What a power analysis comes to, for people and for other programs.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "results/analysis/power.hpp"
#include "results/tables/table.hpp"

namespace deixis::results {

namespace {

using PowerJson = nlohmann::ordered_json;

constexpr const char* no_evidence =
    "Answers are simulated from assumed effects. They are no evidence about people, and the power is only as "
    "good as the assumptions.";

std::string contrastText(const ContrastPower& contrast) {
    std::string out = fmt::format("{} - {}", contrast.a, contrast.b);
    return contrast.system.empty() ? out : fmt::format("{}: {}", contrast.system, out);
}

std::string shareText(const PowerResult& result, int count) {
    const Proportion share = result.share(count);
    return fmt::format("{:.3f} [{:.3f}, {:.3f}]", *share.estimate, *share.lower, *share.upper);
}

PowerJson shareJson(const PowerResult& result, int count) {
    const Proportion share = result.share(count);
    return {
        {"studies", count}, {"estimate", *share.estimate}, {"lower", *share.lower}, {"upper", *share.upper}};
}

}  // namespace

std::string powerText(const PowerResult& result, std::optional<double> goal) {
    std::string out = fmt::format(
        "{}: power at alpha {} after Holm's correction, {} simulated studies per number of participants, "
        "seed "
        "{}, "
        "{:.4g} % intervals (Clopper-Pearson).\n{}\n",
        result.study_name, result.alpha, result.options.studies, result.options.seed,
        100.0 * result.options.level, no_evidence);
    if (!result.not_simulated.empty())
        out += fmt::format("Not simulated, since nothing is assumed about them: {}.\n",
                           fmt::join(result.not_simulated, ", "));
    std::size_t width = std::string_view("at least one of them").size();
    for (const ContrastPower& contrast : result.contrasts)
        width = std::max(width, contrastText(contrast).size());
    constexpr int column = 23;
    for (const FamilyPower& family : result.families) {
        out += fmt::format("\n{} ({} tests)\n{:{}}", family.name, family.tests, "participants", width);
        for (const int participants : result.participants) out += fmt::format("{:>{}}", participants, column);
        if (goal) out += fmt::format("{:>{}}", fmt::format("for {:.4g}", *goal), 12);
        out += '\n';
        for (const ContrastPower& contrast : result.contrasts) {
            if (contrast.family != family.name) continue;
            out += fmt::format("{:{}}", contrastText(contrast), width);
            for (const auto& [participants, found] : contrast.found)
                out += fmt::format("{:>{}}", shareText(result, found.either()), column);
            if (goal) {
                const auto needed = participantsFor(result, contrast, *goal);
                out += fmt::format("{:>12}", needed ? fmt::format("{}", *needed)
                                                    : fmt::format("> {}", result.participants.back()));
            }
            out += '\n';
        }
        for (const auto& [name, counts] :
             {std::pair{"at least one of them", &family.any}, std::pair{"all of them", &family.all}}) {
            out += fmt::format("{:{}}", name, width);
            for (const auto& [participants, count] : *counts)
                out += fmt::format("{:>{}}", shareText(result, count), column);
            out += '\n';
        }
    }
    return out;
}

std::string powerJson(const PowerResult& result, std::optional<double> goal) {
    PowerJson out;
    out["schema"] = {{"name", "deixis-power"}, {"version", 1}};
    out["note"] = no_evidence;
    out["study"] = {{"name", result.study_name}, {"hash", result.study_hash}};
    out["settings"] = {{"studies", result.options.studies},
                       {"seed", result.options.seed},
                       {"alpha", result.alpha},
                       {"level", result.options.level}};
    out["settings"]["goal"] = goal ? PowerJson(*goal) : PowerJson();
    out["not_simulated"] = result.not_simulated;
    out["participants"] = result.participants;
    out["contrasts"] = PowerJson::array();
    for (const ContrastPower& contrast : result.contrasts) {
        PowerJson row{{"family", contrast.family}, {"measure", contrast.measure}};
        row["system"] = contrast.system.empty() ? PowerJson() : PowerJson(contrast.system);
        row["a"] = contrast.a;
        row["b"] = contrast.b;
        row["power"] = PowerJson::array();
        for (const auto& [participants, found] : contrast.found) {
            PowerJson one{{"participants", participants}};
            one.update(shareJson(result, found.either()));
            one["a_higher"] = found.a_higher;
            one["b_higher"] = found.b_higher;
            row["power"].push_back(std::move(one));
        }
        if (goal) {
            const auto needed = participantsFor(result, contrast, *goal);
            row["participants_for_goal"] = needed ? PowerJson(*needed) : PowerJson();
        }
        out["contrasts"].push_back(std::move(row));
    }
    out["families"] = PowerJson::array();
    for (const FamilyPower& family : result.families) {
        PowerJson row{{"family", family.name}, {"tests", family.tests}, {"power", PowerJson::array()}};
        for (const int participants : result.participants)
            row["power"].push_back({{"participants", participants},
                                    {"any", shareJson(result, family.any.at(participants))},
                                    {"all", shareJson(result, family.all.at(participants))}});
        out["families"].push_back(std::move(row));
    }
    return out.dump(2, ' ', false, PowerJson::error_handler_t::replace) + "\n";
}

std::string powerCsv(const PowerResult& result) {
    Table table{"power", units::none};
    for (const char* name : {"family", "measure", "system", "a", "b"})
        table.columns.emplace_back(name, ColumnKind::text);
    for (const char* name :
         {"participants", "studies", "significant", "a_higher", "b_higher", "power", "lower", "upper"})
        table.columns.emplace_back(name, ColumnKind::number);
    for (const ContrastPower& contrast : result.contrasts)
        for (const auto& [participants, found] : contrast.found) {
            const Proportion share = result.share(found.either());
            table.rows.push_back({{contrast.family, contrast.measure, contrast.system, contrast.a, contrast.b,
                                   participants, result.options.studies, found.either(), found.a_higher,
                                   found.b_higher, share.estimate, share.lower, share.upper}});
        }
    return csvText(table);
}

}  // namespace deixis::results
