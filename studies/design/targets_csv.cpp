// A study's targets as a table.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "studies/design/angles.hpp"
#include "studies/design/targets.hpp"
#include "target_text.hpp"

namespace deixis::studies {

namespace {

using Column = std::pair<std::string, std::vector<std::string>>;  // name, a cell by target

std::string csvOf(const std::vector<TargetItem>& targets, const std::vector<DistanceBand>& bands,
                  const std::vector<Column>& more) {
    std::string out = "target_id,x,y,z";
    for (const DistanceBand& band : bands)
        for (int i = 1; i <= band.distractors; ++i)
            out += fmt::format(",{0}d{1}_x,{0}d{1}_y,{0}d{1}_z", bands.size() > 1 ? band.name + "_" : "", i);
    for (const auto& column : more) out += "," + column.first;
    out += '\n';
    for (std::size_t row = 0; row < targets.size(); ++row) {
        const TargetItem& item = targets[row];
        out += item.id + "," + (item.placed ? positionText(item.target) : ",,");
        for (std::size_t b = 0; b < bands.size(); ++b)
            for (int i = 0; i < bands[b].distractors; ++i)
                out += "," + (item.placed ? positionText(item.distractors.at(b).at(i)) : ",,");
        for (const auto& column : more) out += "," + column.second[row];
        out += '\n';
    }
    return out;
}

/// A column of numbers; those of items without a place are empty.
template <typename Value>
Column numbers(std::string name, const std::vector<TargetItem>& targets, const char* format,
               const Value& value) {
    Column out{std::move(name), std::vector<std::string>{}};
    for (const TargetItem& item : targets)
        out.second.push_back(item.placed ? fmt::format(fmt::runtime(format), value(item)) : "");
    return out;
}

double smallest(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

void addSeen(const Study& study, const std::vector<TargetItem>& targets, std::size_t band,
             const std::string& prefix, std::vector<Column>& out) {
    for (const Viewpoint& viewpoint : viewpoints(study))
        out.push_back(numbers(
            fmt::format("{}seen_{}_{}", prefix, viewpoint.layout, standingName(viewpoint.standing)), targets,
            "{:.3f}", [&](const TargetItem& item) {
                return seenOf(study, item, band, {viewpoint}, StandingAvatar::reference()).front().min();
            }));
}

void addAngles(const Study& study, const std::vector<TargetItem>& targets, std::size_t band,
               const std::string& prefix, std::vector<Column>& out) {
    const std::vector<Viewpoint> places = viewpoints(study);
    const auto angles = [&](const TargetItem& item, const std::string& layout) {
        return ballAngles(study, *study.findLayout(layout), item.target, item.distractors[band]);
    };
    if (!places.empty())
        out.push_back(numbers(prefix + "angle_avatar", targets, "{:.2f}", [&](const TargetItem& item) {
            return smallest(angles(item, places.front().layout).avatar_deg);
        }));
    for (const Viewpoint& place : places)
        out.push_back(numbers(
            fmt::format("{}angle_{}_{}", prefix, place.layout, standingName(place.standing)), targets,
            "{:.2f}",
            [&](const TargetItem& item) { return smallest(angles(item, place.layout).of(place.standing)); }));
}

}  // namespace

std::string targetsCsv(const std::vector<TargetItem>& targets, const std::vector<DistanceBand>& bands) {
    return csvOf(targets, bands, {});
}

std::string targetsCsv(const Study& study, const std::vector<TargetItem>& targets) {
    std::vector<Column> more;
    for (std::size_t band = 0; band < study.distances.size(); ++band) {
        const std::string prefix = study.distances.size() > 1 ? study.distances[band].name + "_" : "";
        addSeen(study, targets, band, prefix, more);
        addAngles(study, targets, band, prefix, more);
    }
    if (!viewpoints(study).empty()) {
        Column& column = more.emplace_back("drawn_anew", std::vector<std::string>(targets.size()));
        if (const auto drawn = redrawn(study, targets))  // the bare rule may find no place in narrow bands
            for (std::size_t i = 0; i < drawn->size(); ++i)
                column.second[i] = (*drawn)[i] == Redrawn::target        ? "target"
                                   : (*drawn)[i] == Redrawn::distractors ? "distractors"
                                                                         : "";
    }
    return csvOf(targets, study.distances, more);
}

}  // namespace deixis::studies
