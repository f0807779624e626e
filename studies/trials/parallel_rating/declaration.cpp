// Several movements of one item on one page, each rated.
#include <fmt/format.h>

#include <numeric>

#include "study_reading.hpp"

namespace deixis::studies {

namespace parallel_rating {
namespace {

constexpr int max = 6;
constexpr std::string_view keys[] = {"measure", "scale"};
constexpr CheckKind checks[] = {CheckKind::number, CheckKind::repeat};
constexpr DeclaredMeasure measures[] = {{"rating", AnswerKind::rating, ""}};

std::vector<std::vector<int>> allTogether(int systems) {
    std::vector<int> all(static_cast<std::size_t>(systems));
    std::iota(all.begin(), all.end(), 0);
    return {all};
}

void checkLevels(TomlTable& table, const Study& /*study*/, const Stage& stage) {
    const std::size_t n = stage.design.systems.size();
    if (!table.faulty("systems") && n > 0 && (n < 2 || n > max))
        table.problem("systems", fmt::format("found {} system{}, expected 2 to {}: they are on one page", n,
                                             n == 1 ? "" : "s", max));
}

}  // namespace
}  // namespace parallel_rating

extern const StageDeclaration parallel_rating_declaration{.name = "parallel-rating",
                                                          .keys = parallel_rating::keys,
                                                          .read = readTrials,
                                                          .min_stimuli = 2,
                                                          .max_stimuli = parallel_rating::max,
                                                          .shown = parallel_rating::allTogether,
                                                          .arrangement = Arrangement::shuffled,
                                                          .checks = parallel_rating::checks,
                                                          .checkLevels = parallel_rating::checkLevels,
                                                          .questions = ratingQuestion,
                                                          .measures = parallel_rating::measures};

}  // namespace deixis::studies
