// Several movements of one item on one page, each rated.
#include <numeric>

#include "studies/study_file/stage_kind.hpp"

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

}  // namespace
}  // namespace parallel_rating

extern const StageDeclaration parallel_rating_declaration{.name = "parallel-rating",
                                                          .keys = parallel_rating::keys,
                                                          .min_stimuli = 2,
                                                          .max_stimuli = parallel_rating::max,
                                                          .shown = parallel_rating::allTogether,
                                                          .arrangement = Arrangement::shuffled,
                                                          .checks = parallel_rating::checks,
                                                          .questions = ratingQuestion,
                                                          .measures = parallel_rating::measures};

}  // namespace deixis::studies
