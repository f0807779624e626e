#include "rays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "results/page/html_table.hpp"
#include "results/statistics/descriptive.hpp"

namespace deixis::results {

std::vector<double> rayErrors_deg(const SystemEvaluation& system, motion::PointingRay ray) {
    std::vector<double> out;
    for (const MeasuredClip* clip : system.clips)
        if (const auto& error = clip->ray_errors_deg.at(static_cast<std::size_t>(ray)); error)
            out.push_back(*error);
    return out;
}

std::string raysFinding(const Evaluation& evaluation) {
    // Rays that put the systems in the same order are told together.
    std::map<std::vector<std::size_t>, std::vector<std::string>> orders;
    std::map<std::size_t, std::vector<std::string>> errors;  // by system, in the order of the rays
    for (const motion::PointingRay ray : compared_rays) {
        std::vector<std::pair<double, std::size_t>> means;
        for (std::size_t i = 0; i < evaluation.systems.size(); ++i)
            if (const auto of = rayErrors_deg(evaluation.systems[i], ray); !of.empty())
                means.emplace_back(mean(of), i);
        if (means.empty()) continue;
        std::stable_sort(means.begin(), means.end());
        std::vector<std::size_t> order;
        for (const auto& [error, system] : means) order.push_back(system);
        orders[order].emplace_back(motion::pointingRayName(ray));
        if (ray == motion::PointingRay::forearm || ray == motion::PointingRay::eye_fingertip)
            for (const auto& [error, system] : means)
                errors[system].push_back(
                    fmt::format("{:.1f}\u00b0 by {}", error, motion::pointingRayName(ray)));
    }
    if (orders.empty()) return "";
    std::string out = "Mean angle between ray and target: ";
    bool first = true;
    for (const auto& [system, said] : errors) {
        out += fmt::format("{}{} {}", first ? "" : "; ", strongHtml(evaluation.systems[system].system),
                           fmt::join(said, ", "));
        first = false;
    }
    out += ".";
    if (orders.size() > 1 && evaluation.systems.size() > 1) {
        out += " " + strongHtml("The rays do not rank the systems in the same order") + ":";
        first = true;
        for (const auto& [order, rays] : orders) {
            std::vector<std::string> names;
            for (const std::size_t system : order)
                names.push_back(escapeHtml(evaluation.systems[system].system));
            out +=
                fmt::format("{} {} by {}", first ? "" : ";", fmt::join(names, ", "), fmt::join(rays, ", "));
            first = false;
        }
        out += " (best first).";
    } else if (evaluation.systems.size() > 1) {
        out += " All rays rank the systems in the same order.";
    }
    return out;
}

std::string raysHtml(const Evaluation& evaluation, Numbering& tables) {
    Table table{"rays", units::clips, "", {{"system", ColumnKind::text}}};
    for (const motion::PointingRay ray : compared_rays) {
        table.columns.emplace_back(std::string(motion::pointingRayName(ray)), ColumnKind::number);
        table.columns.back().label = table.columns.back().name;
    }
    for (const SystemEvaluation& system : evaluation.systems) {
        Table::Row& row = table.rows.emplace_back(Table::Row{{system.system}});
        for (const motion::PointingRay ray : compared_rays) {
            const auto errors = rayErrors_deg(system, ray);
            row.cells.push_back(errors.empty() ? Cell()
                                               : fmt::format("{:.1f} [{:.1f}, {:.1f}]", mean(errors),
                                                             quantile(errors, 0.25), quantile(errors, 0.75)));
        }
    }
    return tableHtml(table,
                     "All rays side by side: the angle to the target, in degrees, in the frame of the "
                     "accuracy; mean and quartiles over clips. Equation\u00a02 uses the forearm. Which of "
                     "them people read is an open question that this table does not answer.",
                     tables, dense_table);
}

}  // namespace deixis::results
