#include <fmt/format.h>

#include "study_reading.hpp"

namespace deixis::studies {

namespace parallel_rating {
namespace {

void checkLevels(TomlTable& table, const Study& /*study*/, const Stage& stage) {
    const auto most = static_cast<std::size_t>(declarationOf(stage.kind).max_stimuli);
    const std::size_t n = stage.design.systems.size();
    if (!table.faulty("systems") && n > 0 && (n < 2 || n > most))
        table.problem("systems", fmt::format("found {} system{}, expected 2 to {}: they are on one page", n,
                                             n == 1 ? "" : "s", most));
}

}  // namespace
}  // namespace parallel_rating

extern const KindReader parallel_rating_reader{readTrials, parallel_rating::checkLevels};

}  // namespace deixis::studies
