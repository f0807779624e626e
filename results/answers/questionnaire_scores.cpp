#include "results/answers/questionnaire_scores.hpp"

#include <map>
#include <nlohmann/json.hpp>

#include "studies/study_file/questionnaire.hpp"

namespace deixis::results {

namespace {

using SQLite::Statement;

/// A score and the questions that it is made of, as the database keeps them.
struct KeptScore {
    std::string stage;
    studies::Score score;
};

std::vector<KeptScore> readScores(SQLite::Database& database,
                                  std::map<std::string, studies::Questionnaire>& questionnaires) {
    Statement questions(database,
                        "SELECT stage, question, low, high FROM questions WHERE kind = 'scale' AND low IS "
                        "NOT NULL ORDER BY stage, position");
    while (questions.executeStep()) {
        studies::Question question;
        question.id = questions.getColumn(1).getString();
        question.scale.low = static_cast<int>(questions.getColumn(2).getDouble());
        question.scale.high = static_cast<int>(questions.getColumn(3).getDouble());
        questionnaires[questions.getColumn(0).getString()].questions.push_back(std::move(question));
    }
    std::vector<KeptScore> scores;
    Statement stored(database,
                     "SELECT c.stage, c.name, items, reversed, mean, factor, offset_ FROM scores AS c JOIN "
                     "stages AS g ON g.name = c.stage ORDER BY g.position, c."
                     "position");
    while (stored.executeStep()) {
        KeptScore kept;
        kept.stage = stored.getColumn(0).getString();
        kept.score.name = stored.getColumn(1).getString();
        kept.score.items =
            nlohmann::json::parse(stored.getColumn(2).getString()).get<std::vector<std::string>>();
        kept.score.reversed =
            nlohmann::json::parse(stored.getColumn(3).getString()).get<std::vector<std::string>>();
        kept.score.mean = stored.getColumn(4).getInt() != 0;
        kept.score.factor = stored.getColumn(5).getDouble();
        kept.score.offset = stored.getColumn(6).getDouble();
        scores.push_back(std::move(kept));
    }
    return scores;
}

}  // namespace

std::vector<QuestionnaireScore> readQuestionnaireScores(SQLite::Database& database) {
    std::map<std::string, studies::Questionnaire> questionnaires;
    const std::vector<KeptScore> scores = readScores(database, questionnaires);
    std::vector<QuestionnaireScore> out;
    if (scores.empty()) return out;
    using Answers = std::map<std::string, double>;
    std::map<std::string, std::map<std::string, Answers>> answers;  // by participant and stage
    Statement given(
        database,
        "SELECT r.participant, t.stage, a.question, a.value FROM responses AS r "
        "JOIN trials AS t ON t.participant = r.participant AND t.trial_index = r.trial_index "
        "JOIN answers AS a ON a.response = r.id "
        "WHERE r.superseded IS NULL AND t.stage IN (SELECT stage FROM scores) AND a.value IS NOT NULL");
    while (given.executeStep())
        answers[given.getColumn(0).getString()][given.getColumn(1).getString()]
               [given.getColumn(2).getString()] = given.getColumn(3).getDouble();
    for (const auto& [participant, stages] : answers)
        for (const KeptScore& kept : scores)
            if (const auto stage = stages.find(kept.stage); stage != stages.end())
                out.push_back({participant, kept.stage, kept.score.name,
                               studies::computeScore(questionnaires[kept.stage], kept.score, stage->second)});
    return out;
}

}  // namespace deixis::results
