// Questionnaires: files of questions with their published scoring. Documented in docs/study-file.md.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "studies/study_file/scale.hpp"

namespace deixis::studies {

/// A score: factor * (sum or mean of items), reversed items counted as low + high - value.
struct Score {
    std::string name;
    std::vector<std::string> items;  ///< ids of scale questions; one that stands twice counts twice
    std::vector<std::string> reversed{};
    bool mean = false;
    double factor = 1.0;
    double offset = 0.0;  ///< added at the end
};

struct Questionnaire {
    std::string name;
    std::string title{};      ///< what the participant sees above it; may be empty
    std::string text{};       ///< likewise: how to answer
    std::string reference{};  ///< where it was published
    std::vector<Question> questions;
    std::vector<Score> scores{};
    int per_page = 4;  ///< most questions on one page

    [[nodiscard]] const Question* find(std::string_view id) const;
    /// Questions are shown in order, `per_page` at a time: the ids of page 0, 1, ...
    [[nodiscard]] int pages() const;
    [[nodiscard]] std::vector<const Question*> page(int index) const;
};

/// A score from the answers given (question id -> value); none where an item is missing.
[[nodiscard]] std::optional<double> computeScore(const Questionnaire& questionnaire, const Score& score,
                                                 const std::map<std::string, double>& answers);

}  // namespace deixis::studies
