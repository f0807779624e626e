#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <sstream>

#include "motion/networks/taking.hpp"
#include "physics/policy/amp_system.hpp"

namespace deixis::physics {

namespace {

using motion::NamedArray;
using motion::NetworkWeights;
using motion::Side;

constexpr std::size_t phases = std::tuple_size_v<motion::PhaseDurations>;
constexpr int most = 100'000;

std::optional<std::vector<int>> naturals(const std::string& text) {
    std::istringstream in(text);
    std::vector<int> out;
    for (int value = 0; in >> value;) {
        if (value < 1 || value > 4096) return std::nullopt;
        out.push_back(value);
    }
    if (!in.eof() || out.empty() || out.size() > 8) return std::nullopt;
    return out;
}

Result<void> readTargets(const NetworkWeights& weights, int count, AmpModel& out) {
    const auto n = static_cast<std::size_t>(count);
    const auto places = weights.array("targets", {n, 3});
    const auto hands = weights.array("hands", {n});
    const auto durations = weights.array("durations", {n, phases});
    const auto clusters = weights.array("clusters", {n});
    for (const auto* array : {&places, &hands, &durations, &clusters})
        if (!*array) return tl::unexpected(array->error());
    const auto number = [](const NamedArray* array, std::size_t at) {
        return static_cast<double>(array->values[at]);
    };
    for (std::size_t i = 0; i < n; ++i) {
        AmpTarget& target = out.targets.emplace_back();
        for (std::size_t axis = 0; axis < 3; ++axis)
            target.target_m[static_cast<int>(axis)] = number(*places, 3 * i + axis);
        target.hand = number(*hands, i) > 0.5 ? Side::right : Side::left;
        for (std::size_t p = 0; p < phases; ++p) {
            target.durations_s[p] = number(*durations, phases * i + p);
            if (!(target.durations_s[p] > 0.0 && target.durations_s[p] <= 60.0))
                return fail(
                    weights.file + ": durations",
                    fmt::format("found {} s, expected more than 0 and at most 60", target.durations_s[p]));
        }
        const double cluster = number(*clusters, i);
        if (!(cluster >= 0.0 && cluster < out.clusters && cluster == std::floor(cluster)))
            return fail(weights.file + ": clusters",
                        fmt::format("found cluster {}, expected 0 to {}", cluster, out.clusters - 1));
        target.cluster = static_cast<int>(cluster);
    }
    return {};
}

}  // namespace

void writeModel(const AmpModel& model, NetworkWeights& weights) {
    weights.architecture = amp_architecture;
    weights.settings["system"] = model.system;
    weights.settings["stance"] = std::string(model.stance == Stance::pinned ? "pinned" : "free");
    weights.settings["with_phase"] = model.with_phase ? 1.0 : 0.0;
    weights.settings["clusters"] = static_cast<double>(model.clusters);
    weights.settings["hidden"] = fmt::format("{}", fmt::join(model.hidden, " "));
    weights.settings["demonstrations"] = static_cast<double>(model.targets.size());
    weights.settings["features"] = model.features;
    const std::size_t n = model.targets.size();
    NamedArray places{"targets", {n, 3}, {}}, hands{"hands", {n}, {}},
        durations{"durations", {n, phases}, {}}, clusters{"clusters", {n}, {}};
    const auto add = [](NamedArray& array, double value) {
        array.values.push_back(static_cast<float>(value));
    };
    for (const AmpTarget& target : model.targets) {
        for (int axis = 0; axis < 3; ++axis) add(places, target.target_m[axis]);
        add(hands, target.hand == Side::right ? 1.0 : 0.0);
        for (const double duration : target.durations_s) add(durations, duration);
        add(clusters, target.cluster);
    }
    weights.arrays.insert(weights.arrays.end(), {places, hands, durations, clusters});
    weights.arrays.push_back(
        {"base", {model.base.size()}, std::vector<float>(model.base.begin(), model.base.end())});
}

Result<AmpModel> readModel(const NetworkWeights& weights) {
    if (weights.architecture != amp_architecture)
        return fail(weights.file, fmt::format("these are weights of '{}', expected '{}'",
                                              weights.architecture, amp_architecture));
    if (weights.settings.contains("only_cluster"))
        return fail(weights.file, "these are weights of one cluster alone",
                    "'deixis learn join' puts them together");
    AmpModel out;
    motion::Taking take;
    std::string stance, hidden;
    int phase = 0, count = 0;
    take(out.system, weights.text("system"));
    take(stance, weights.text("stance"));
    take(phase, weights.count("with_phase", 0, 1));
    take(out.clusters, weights.count("clusters", 1, most));
    take(hidden, weights.text("hidden"));
    take(count, weights.count("demonstrations", 1, most));
    take(out.features, weights.text("features"));
    if (take.problem()) return tl::unexpected(*take.problem());
    if (stance != "pinned" && stance != "free")
        return fail(weights.file + ": settings.stance",
                    fmt::format("found '{}', expected pinned or free", stance));
    out.stance = stance == "pinned" ? Stance::pinned : Stance::free;
    out.with_phase = phase == 1;
    const auto units = naturals(hidden);
    if (!units)
        return fail(weights.file + ": settings.hidden",
                    fmt::format("found '{}', expected whole numbers from 1 to 4096", hidden));
    out.hidden = *units;
    if (const auto read = readTargets(weights, count, out); !read) return tl::unexpected(read.error());
    for (const NamedArray& array : weights.arrays)
        if (array.name == "base") out.base.assign(array.values.begin(), array.values.end());
    return out;
}

}  // namespace deixis::physics
