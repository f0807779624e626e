// The scores of questionnaires, computed from the answers in a database.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <string>
#include <vector>

namespace deixis::results {

struct QuestionnaireScore {
    std::string participant;
    std::string stage;
    std::string score;
    std::optional<double> value;  ///< none where an item was not answered
};

/// Of every stage that a participant has answered anything of; ordered by participant, stage and the score's
/// place in its questionnaire.
[[nodiscard]] std::vector<QuestionnaireScore> readQuestionnaireScores(SQLite::Database& database);

}  // namespace deixis::results
