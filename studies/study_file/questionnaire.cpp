#include "studies/study_file/questionnaire.hpp"

#include <algorithm>

namespace deixis::studies {

const Question* Questionnaire::find(std::string_view id) const {
    const auto found = std::find_if(questions.begin(), questions.end(),
                                    [&](const Question& question) { return question.id == id; });
    return found == questions.end() ? nullptr : &*found;
}

int Questionnaire::pages() const {
    return (static_cast<int>(questions.size()) + per_page - 1) / per_page;
}

std::vector<const Question*> Questionnaire::page(int index) const {
    const std::size_t max = static_cast<std::size_t>(per_page);
    const std::size_t first = static_cast<std::size_t>(index) * max;
    std::vector<const Question*> out;
    for (std::size_t i = first; i < std::min(first + max, questions.size()); ++i)
        out.push_back(&questions[i]);
    return out;
}

std::optional<double> computeScore(const Questionnaire& questionnaire, const Score& score,
                                   const std::map<std::string, double>& answers) {
    if (score.items.empty()) return {};
    double sum = 0.0;
    for (const std::string& item : score.items) {
        const Question* question = questionnaire.find(item);
        const auto answer = answers.find(item);
        if (question == nullptr || answer == answers.end()) return {};
        const bool reversed =
            std::find(score.reversed.begin(), score.reversed.end(), item) != score.reversed.end();
        sum += reversed ? question->scale.low + question->scale.high - answer->second : answer->second;
    }
    if (score.mean) sum /= static_cast<double>(score.items.size());
    return score.offset + score.factor * sum;
}

}  // namespace deixis::studies
