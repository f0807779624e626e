#include "studies/study_file/kept_values.hpp"

namespace deixis::studies {

std::optional<double> keptNumber(const std::vector<KeptValue>& values, std::string_view name) {
    for (const KeptValue& one : values)
        if (one.name == name) return one.value;
    return std::nullopt;
}

int keptPlace(const std::vector<KeptValue>& values, std::string_view name) {
    return static_cast<int>(keptNumber(values, name).value_or(-1.0));
}

}  // namespace deixis::studies
