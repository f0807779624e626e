#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "motion/networks/weights_file.hpp"

namespace deixis::motion {

namespace {

std::string found(const NetworkSetting* setting) {
    if (setting == nullptr) return "found none";
    if (const auto* number = std::get_if<double>(setting)) return fmt::format("found {}", *number);
    return fmt::format("found \"{}\"", std::get<std::string>(*setting));
}

const NetworkSetting* settingOf(const NetworkWeights& weights, const std::string& key) {
    const auto at = weights.settings.find(key);
    return at == weights.settings.end() ? nullptr : &at->second;
}

tl::unexpected<Error> wrongSetting(const NetworkWeights& weights, const std::string& key,
                                   const std::string& expected) {
    return fail(fmt::format("{}: settings.{}", weights.file, key),
                fmt::format("{}, expected {}", found(settingOf(weights, key)), expected));
}

}  // namespace

Result<double> NetworkWeights::number(const std::string& key) const {
    const NetworkSetting* setting = settingOf(*this, key);
    if (setting == nullptr || !std::holds_alternative<double>(*setting))
        return wrongSetting(*this, key, "a number");
    return std::get<double>(*setting);
}

Result<std::string> NetworkWeights::text(const std::string& key) const {
    const NetworkSetting* setting = settingOf(*this, key);
    if (setting == nullptr || !std::holds_alternative<std::string>(*setting))
        return wrongSetting(*this, key, "a text");
    return std::get<std::string>(*setting);
}

Result<void> NetworkWeights::checkFeatures(const std::string& of_avatar) const {
    const auto names = text("features");
    if (!names) return tl::unexpected(names.error());
    if (*names == of_avatar) return {};
    return fail(
        file + ": settings.features",
        "the weights move other joints than this avatar has: found " + *names + ", expected " + of_avatar,
        "Train for this avatar");
}

Result<int> NetworkWeights::count(const std::string& key, int low, int high) const {
    const auto value = number(key);
    if (!value) return tl::unexpected(value.error());
    if (!(*value >= low && *value <= high) || *value != std::floor(*value))
        return wrongSetting(*this, key, fmt::format("a whole number from {} to {}", low, high));
    return static_cast<int>(*value);
}

Result<const NamedArray*> NetworkWeights::array(const std::string& name,
                                                const std::vector<std::size_t>& shape) const {
    const auto at = std::find_if(arrays.begin(), arrays.end(),
                                 [&name](const NamedArray& array) { return array.name == name; });
    const std::string expected = fmt::format("expected one of shape {}", shape);
    if (at == arrays.end())
        return fail(fmt::format("{}: {}", file, name), "the array is missing, " + expected);
    if (at->shape != shape)
        return fail(fmt::format("{}: {}", file, name),
                    fmt::format("found an array of shape {}, {}", at->shape, expected));
    return &*at;
}

}  // namespace deixis::motion
