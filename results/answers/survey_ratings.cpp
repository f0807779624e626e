#include "survey_ratings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <vector>

namespace deixis::results {

namespace {

struct RatingQuestion {
    std::string stage;
    std::string question;
    std::string measure;
    std::string system;
    double low = 0.0;
    double high = 1.0;
};

std::vector<RatingQuestion> ratingQuestions(SQLite::Database& database) {
    SQLite::Statement query(
        database,
        "SELECT q.stage, q.question, json_extract(e.value, '$.measure'), json_extract(e.value, '$.system'), "
        "q.low, q.high FROM study, json_each(study.analysis, '$.rates') AS e JOIN questions AS q ON q.stage "
        "= "
        "json_extract(e.value, '$.stage') AND q.question = json_extract(e.value, '$.question') "
        "ORDER BY e.key");
    std::vector<RatingQuestion> out;
    while (query.executeStep())
        out.push_back({query.getColumn(0).getString(), query.getColumn(1).getString(),
                       query.getColumn(2).getString(), query.getColumn(3).getString(),
                       query.getColumn(4).getDouble(), query.getColumn(5).getDouble()});
    return out;
}

/// Those that stages show, and those that are only rated, in the order of the study.
void addSystems(SQLite::Database& database, const std::vector<RatingQuestion>& questions,
                ResponseTable& table) {
    std::set<std::string> wanted(table.systems.begin(), table.systems.end());
    for (const RatingQuestion& one : questions) wanted.insert(one.system);
    table.systems.clear();
    SQLite::Statement query(database, "SELECT name FROM systems ORDER BY position");
    while (query.executeStep())
        if (const std::string name = query.getColumn(0).getString(); wanted.contains(name))
            table.systems.push_back(name);
}

/// Everybody whose plan has the questionnaire is asked.
int plannedOf(SQLite::Database& database, const std::string& people, const RatingQuestion& question,
              ResponseTable& table) {
    SQLite::Statement query(
        database, fmt::format("SELECT DISTINCT t.participant FROM trials AS t JOIN {} AS p ON p.id = "
                              "t.participant WHERE t.stage = ? AND p.status = 'active'",
                              people));
    query.bind(1, question.stage);
    int count = 0;
    for (; query.executeStep(); ++count)
        ++table.planned_answers[query.getColumn(0).getString()][question.measure];
    return count;
}

void addSurveyMeasure(const RatingQuestion& question, int planned, ResponseTable& table) {
    const auto known = std::find_if(table.measures.begin(), table.measures.end(),
                                    [&](const Measure& one) { return one.name == question.measure; });
    if (known != table.measures.end()) {
        known->planned += planned;
        known->low = std::min(known->low, question.low);
        known->high = std::max(known->high, question.high);
        return;
    }
    Measure measure{question.measure, MeasureKind::rating, question.low, question.high, 0, planned};
    measure.surveyed = true;
    table.measures.push_back(measure);
}

void readRows(SQLite::Database& database, const std::string& people, const RatingQuestion& question,
              ResponseTable& table) {
    SQLite::Statement rows(
        database,
        fmt::format(
            "SELECT r.participant, t.layout, e.synthetic, r.pauses, r.trial_index, p.status, p.reason, "
            "e.station, a.value FROM responses AS r JOIN {} AS p ON p.id = r.participant JOIN trials "
            "AS t ON t.participant = r.participant AND t.trial_index = r.trial_index JOIN sessions AS "
            "e ON e.id = r.session JOIN answers AS a ON a.response = r.id WHERE r.superseded IS NULL "
            "AND t.stage = ? AND a.question = ? AND a.value IS NOT NULL",
            people));
    rows.bind(1, question.stage);
    rows.bind(2, question.question);
    while (rows.executeStep()) {
        ResponseRow row;
        row.participant = rows.getColumn(0).getString();
        row.measure = question.measure;
        row.system = question.system;
        row.layout = rows.getColumn(1).getString();
        row.synthetic = rows.getColumn(2).getInt() != 0;
        row.pauses = rows.getColumn(3).getInt();
        row.trial = rows.getColumn(4).getInt();
        row.station = rows.getColumn(7).getString();
        row.value = rows.getColumn(8).getDouble();
        const bool counts = rows.getColumn(5).getString() == "active";
        if (!counts)
            row.excluded =
                fmt::format("{}: {}", rows.getColumn(5).getString(), rows.getColumn(6).getString());
        (counts ? table.rows : table.left_out_rows).push_back(std::move(row));
    }
}

}  // namespace

void readSurveyRatings(SQLite::Database& database, const std::string& people, ResponseTable& table) {
    const std::vector<RatingQuestion> questions = ratingQuestions(database);
    if (questions.empty()) return;
    addSystems(database, questions, table);
    for (const RatingQuestion& question : questions) {
        addSurveyMeasure(question, plannedOf(database, people, question, table), table);
        readRows(database, people, question, table);
    }
}

}  // namespace deixis::results
