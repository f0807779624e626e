#include "results/answers/response_table.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "participant_fields.hpp"
#include "response_context.hpp"
#include "results/answers/data_quality.hpp"
#include "results/answers/questionnaire_scores.hpp"
#include "results/answers/response_reading.hpp"
#include "results/database/counted_participants.hpp"
#include "results/database/database_open.hpp"
#include "results/database/game_values.hpp"
#include "results/database/locked_history.hpp"
#include "studies/study_file/stage_kind.hpp"
#include "survey_ratings.hpp"

namespace deixis::results {

namespace {

namespace fs = std::filesystem;
using SQLite::Statement;

std::vector<std::string> textColumn(SQLite::Database& database, const std::string& sql) {
    std::vector<std::string> out;
    Statement query(database, sql);
    while (query.executeStep()) out.push_back(query.getColumn(0).getString());
    return out;
}

studies::LeaveOutRule leaveOutFrom(const nlohmann::json& declared) {
    const auto share = [&](const char* key) {
        return declared.contains(key) ? std::optional(declared.at(key).get<double>()) : std::nullopt;
    };
    return {share("same_rating_share"), share("one_side_share"), share("median_time_below_s")};
}

void readSystems(const nlohmann::json& systems, ResponseTable& table) {
    table.processing.emplace();
    for (const auto& [name, system] : systems.items()) {
        if (system.contains("processing"))
            table.processing->emplace(name, system.at("processing").get<std::string>());
        if (!system.value("compared", true))
            table.not_compared.emplace(name, system.at("remark").get<std::string>());
    }
}

void readStudy(SQLite::Database& database, const std::string& people, ResponseTable& table) {
    Statement study(database, "SELECT name, title, hash, alpha, analysis FROM study");
    study.executeStep();
    table.study_name = study.getColumn(0).getString();
    table.study_title = study.getColumn(1).getString();
    table.study_hash = study.getColumn(2).getString();
    table.alpha = study.getColumn(3).getDouble();
    if (!study.getColumn(4).isNull()) {
        const auto analysis = nlohmann::json::parse(study.getColumn(4).getString());
        table.stations_together = analysis.at("stations").get<std::string>() == "together";
        table.by_ratings = analysis.value("unit", "participants") == "ratings";
        table.equivalence = analysis.at("equivalence").get<std::map<std::string, double>>();
        table.leave_out = leaveOutFrom(analysis.value("leave_out", nlohmann::json::object()));
        if (analysis.contains("systems")) readSystems(analysis.at("systems"), table);
    }
    table.systems =
        textColumn(database,
                   "SELECT name FROM systems WHERE name IN (SELECT system FROM trial_stimuli WHERE scored) "
                   "ORDER BY position");
    table.layouts =
        textColumn(database,
                   "SELECT name FROM layouts WHERE name IN (SELECT t.layout FROM trials AS t JOIN "
                   "trial_stimuli AS s USING (participant, trial_index) WHERE s.scored) ORDER BY position");
    table.distances =
        textColumn(database,
                   "SELECT name FROM distances WHERE name IN (SELECT distance FROM trials WHERE NOT "
                   "practice AND check_kind IS NOT 'catch') ORDER BY position");
    table.planned_participants =
        database.execAndGet(fmt::format("SELECT count(*) FROM {} WHERE status = 'active'", people)).getInt();
    table.withdrawn = database.execAndGet("SELECT count(*) FROM withdrawals").getInt();
}

// How many values of the scored trials of a stage were planned, of participants who count.
int planned(SQLite::Database& database, const std::string& people, const std::string& stage,
            bool each_stimulus, const std::string& measure, ResponseTable& table) {
    Statement counts(
        database,
        fmt::format(
            "SELECT t.participant, count(*) FROM trial_stimuli AS s JOIN trials AS t USING (participant, "
            "trial_index) JOIN {} AS p ON p.id = t.participant WHERE s.scored AND p.status = 'active' AND "
            "t.stage = ? AND (? OR s.position = 0) GROUP BY t.participant",
            people));
    counts.bind(1, stage);
    counts.bind(2, each_stimulus ? 1 : 0);
    int all = 0;
    while (counts.executeStep()) {
        const int of_participant = counts.getColumn(1).getInt();
        table.planned_answers[counts.getColumn(0).getString()][measure] += of_participant;
        all += of_participant;
    }
    return all;
}

void addMeasure(ResponseTable& table, const Measure& measure) {
    const auto same = std::find_if(table.measures.begin(), table.measures.end(),
                                   [&](const Measure& known) { return known.name == measure.name; });
    if (same == table.measures.end()) {
        table.measures.push_back(measure);
        return;
    }
    same->planned += measure.planned;
    same->balls = std::max(same->balls, measure.balls);
    same->min_balls = std::min(same->min_balls, measure.min_balls);
}

Measure& measureNamed(ResponseTable& table, const std::string& name) {
    return *std::find_if(table.measures.begin(), table.measures.end(),
                         [&](const Measure& one) { return one.name == name; });
}

/// What is measured in a unit has no scale: its end is that of the answers, rounded up.
void fitMeasured(ResponseTable& table) {
    for (Measure& measure : table.measures) {
        if (measure.unit.empty()) continue;
        double max = 0.0;
        for (const ResponseRow& row : table.rows)
            if (row.measure == measure.name) max = std::max(max, row.value);
        measure.high = 1.0;
        for (int i = 0; measure.high < max; ++i) measure.high *= i % 3 == 1 ? 2.5 : 2.0;
    }
}

/// What the answers to a question of a stage measure, and on which scale.
struct StageScale {
    std::string stage;
    std::string_view question;
    std::string measure;
    double low = 0.0;
    double high = 0.0;
    bool each_stimulus = true;
    std::string unit{};
};

/// By stage and question.
using MeasureOfAnswers = std::map<std::pair<std::string, std::string_view>, std::string>;

/// Measures that are asked on several scales get these in their names. Returns what such ones were called.
std::set<std::string> nameByScale(std::vector<StageScale>& scales) {
    std::map<std::string, std::set<std::pair<double, double>>> asked;
    for (const StageScale& one : scales) asked[one.measure].insert({one.low, one.high});
    std::set<std::string> renamed;
    for (StageScale& one : scales) {
        if (asked[one.measure].size() < 2) continue;
        renamed.insert(one.measure);
        one.measure = fmt::format("{} ({:g} to {:g})", one.measure, one.low, one.high);
    }
    return renamed;
}

/// How many balls there were in a stage's trials: the most and the fewest.
std::pair<int, int> ballsIn(SQLite::Database& database, const std::string& stage) {
    Statement balls(
        database,
        "SELECT coalesce(max(json_array_length(g.balls)), 0), coalesce(min(json_array_length(g.balls)), 0) "
        "FROM "
        "trials JOIN game_trials AS g USING (participant, trial_index) WHERE stage = ? AND check_kind IS NOT "
        "'catch'");
    balls.bind(1, stage);
    balls.executeStep();
    return {balls.getColumn(0).getInt(), balls.getColumn(1).getInt()};
}

/// What the kinds of the stages declare to be measured. Choices first, then preferences, then ratings.
MeasureOfAnswers readMeasures(SQLite::Database& database, const std::string& people, ResponseTable& table) {
    Statement stages(
        database,
        "SELECT name, kind, coalesce(measure, '') FROM stages WHERE practice_of IS NULL AND name "
        "IN (SELECT stage FROM trials) ORDER BY position");
    Statement question(database, "SELECT low, high FROM questions WHERE stage = ? AND question = ?");
    std::vector<Measure> preferences;
    std::vector<StageScale> scales;
    while (stages.executeStep()) {
        const std::string name = stages.getColumn(0).getString();
        const studies::StageDeclaration* kind = studies::findDeclaration(stages.getColumn(1).getString());
        if (kind == nullptr) continue;
        for (const studies::DeclaredMeasure& declared : kind->measures) {
            const bool each = kind->answersEach();
            const std::string measure =
                declared.name.empty() ? stages.getColumn(2).getString() : std::string(declared.name);
            if (declared.kind == studies::AnswerKind::accuracy) {
                const auto [max, min] = ballsIn(database, name);
                addMeasure(table, {measure, MeasureKind::accuracy, 0.0, 1.0, max,
                                   planned(database, people, name, each, measure, table), min});
                continue;
            }
            question.reset();
            question.bind(1, name);
            question.bind(2, std::string(declared.question));
            if (!question.executeStep()) continue;  // it need not be asked
            const double low = question.getColumn(0).getDouble();
            const double high = question.getColumn(1).getDouble();
            if (declared.kind == studies::AnswerKind::preference)
                preferences.push_back({measure, MeasureKind::preference, low, high, 0,
                                       planned(database, people, name, each, measure, table)});
            else
                scales.push_back(
                    {name, declared.question, measure, low, high, each, std::string(declared.unit)});
        }
    }
    for (const Measure& preference : preferences) addMeasure(table, preference);
    MeasureOfAnswers measures;
    for (const std::string& name : nameByScale(scales))
        table.notes.push_back(
            fmt::format("{} is asked on different scales: each scale is a separate measure here, since their "
                        "answers have no common mean.",
                        name));
    for (const StageScale& one : scales) {
        addMeasure(table, {one.measure, MeasureKind::rating, one.low, one.high, 0,
                           planned(database, people, one.stage, one.each_stimulus, one.measure, table)});
        if (!one.unit.empty()) measureNamed(table, one.measure).unit = one.unit;
        measures[{one.stage, one.question}] = one.measure;
    }
    return measures;
}

void readSessions(SQLite::Database& database, ResponseTable& table) {
    Statement stations(database,
                       "SELECT station, station_details, synthetic, count(*) FROM sessions "
                       "GROUP BY 1, 2, 3 ORDER BY 1, 2, 3");
    while (stations.executeStep())
        table.stations.push_back({stations.getColumn(0).getString(), stations.getColumn(1).getString(),
                                  stations.getColumn(2).getInt() != 0, stations.getColumn(3).getInt()});
    table.program_versions = textColumn(database, "SELECT DISTINCT program_version FROM sessions ORDER BY 1");
    table.operating_systems = textColumn(
        database, "SELECT DISTINCT value FROM session_properties WHERE name = 'operating_system' ORDER BY 1");
    table.avatar_hashes = textColumn(database, "SELECT DISTINCT avatar_hash FROM sessions ORDER BY 1");
}

void readLeftOut(SQLite::Database& database, const std::string& people, ResponseTable& table) {
    Statement left(
        database,
        fmt::format("SELECT id, status, reason FROM {} WHERE status <> 'active' ORDER BY id", people));
    while (left.executeStep())
        table.left_out.push_back({left.getColumn(0).getString(), left.getColumn(1).getString() == "dropped",
                                  left.getColumn(2).getString()});
    Statement checks(
        database,
        "SELECT t.stage, t.check_kind, sum(r.check_passed), sum(NOT r.check_passed) FROM responses AS r "
        "JOIN trials AS t USING (participant, trial_index) JOIN stages AS s ON s.name = t.stage "
        "WHERE r.superseded IS NULL AND r.check_passed IS NOT NULL GROUP BY s.position, t.check_kind "
        "ORDER BY s.position, t.check_kind");
    while (checks.executeStep())
        table.checks.push_back({checks.getColumn(0).getString(), checks.getColumn(1).getString(),
                                checks.getColumn(2).getInt(), checks.getColumn(3).getInt()});
}

// The clip that was shown, and in which of its author's trials it was made.
constexpr const char* clip_shown =
    "LEFT JOIN response_stimuli AS x ON x.response = r.id AND x.position = s.position ";

// What all rows of a measure have in common.
constexpr const char* row_columns =
    "r.participant, s.system, t.layout, t.distance, t.target_id, r.response_time_s, e.synthetic, r.pauses, "
    "r.trial_index, p.status, p.reason, e.station";
constexpr int next_column = 12;
std::string rowTables(const std::string& people) {
    return fmt::format(
        "FROM responses AS r JOIN {} AS p ON p.id = r.participant "
        "JOIN trials AS t ON t.participant = r.participant AND t.trial_index = r.trial_index "
        "JOIN sessions AS e ON e.id = r.session ",
        people);
}
constexpr const char* row_counts = "r.superseded IS NULL AND s.scored ";

ResponseRow baseRow(Statement& rows, const std::string& measure) {
    ResponseRow row;
    row.participant = rows.getColumn(0).getString();
    row.measure = measure;
    row.system = rows.getColumn(1).getString();
    row.layout = rows.getColumn(2).getString();
    row.distance = rows.getColumn(3).getString();
    row.target_id = rows.getColumn(4).getString();
    row.response_time_s = rows.getColumn(5).getDouble();
    row.synthetic = rows.getColumn(6).getInt() != 0;
    row.pauses = rows.getColumn(7).getInt();
    row.trial = rows.getColumn(8).getInt();
    row.station = rows.getColumn(11).getString();
    if (rows.getColumn(9).getString() != "active")
        row.excluded = fmt::format("{}: {}", rows.getColumn(9).getString(), rows.getColumn(10).getString());
    return row;
}

/// Parts those who are left out from those who count, and skipped choices from the others.
void keepRow(ResponseTable& table, ResponseRow row) {
    const bool skipped = row.unanswered == "skipped";
    if (skipped && !row.excluded.empty()) return;
    auto& rows = skipped ? table.skipped_rows : row.excluded.empty() ? table.rows : table.left_out_rows;
    rows.push_back(std::move(row));
}

void readRatings(SQLite::Database& database, const std::string& people, const MeasureOfAnswers& measures,
                 ResponseTable& table) {
    Statement rows(database,
                   fmt::format("SELECT {}, a.value, t.stage, x.author_trial, a.question {}"
                               "JOIN answers AS a ON a.response = r.id "
                               "JOIN trial_stimuli AS s ON s.participant = r.participant AND s.trial_index = "
                               "r.trial_index AND s.position = coalesce(a.stimulus, 0) {}"
                               "WHERE {} AND a.value IS NOT NULL "
                               "ORDER BY r.participant, r.trial_index, s.position, a.position",
                               row_columns, rowTables(people), clip_shown, row_counts));
    while (rows.executeStep()) {
        const std::string question = rows.getColumn(next_column + 3).getString();
        const auto measure = measures.find({rows.getColumn(next_column + 1).getString(), question});
        if (measure == measures.end()) continue;
        ResponseRow row = baseRow(rows, measure->second);
        row.value = rows.getColumn(next_column).getDouble();
        row.author_trial = rows.getColumn(next_column + 2).getInt();
        keepRow(table, std::move(row));
    }
}

void readChoices(SQLite::Database& database, const std::string& people, ResponseTable& table) {
    Statement rows(
        database,
        fmt::format(
            "SELECT {}, h.correct, json_array_length(g.balls), h.chosen_place IS NULL, r.status {}{}"
            "JOIN trial_stimuli AS s ON s.participant = r.participant AND s.trial_index = r.trial_index AND "
            "s.position = 0 WHERE {} ORDER BY r.participant, r.trial_index",
            row_columns, rowTables(people), game_values, row_counts));
    while (rows.executeStep()) {
        ResponseRow row = baseRow(rows, "accuracy");
        row.value = rows.getColumn(next_column).getInt();
        row.balls = rows.getColumn(next_column + 1).getInt();
        if (rows.getColumn(next_column + 2).getInt() != 0) {
            row.unanswered = rows.getColumn(next_column + 3).getString();
            row.value = 0.0;
            row.response_time_s = 0.0;
        }
        keepRow(table, std::move(row));
    }
}

void readPreferences(SQLite::Database& database, const std::string& people, ResponseTable& table) {
    Statement rows(
        database,
        fmt::format(
            "SELECT {}, a.value, o.system {}JOIN answers AS a ON a.response = r.id AND a.question = "
            "'preference' JOIN trial_stimuli AS s ON s.participant = r.participant AND s.trial_index = "
            "r.trial_index AND s.position = 0 JOIN trial_stimuli AS o ON o.participant = r.participant "
            "AND o.trial_index = r.trial_index AND o.position = 1 WHERE {} "
            "ORDER BY r.participant, r.trial_index",
            row_columns, rowTables(people), row_counts));
    while (rows.executeStep()) {
        ResponseRow row = baseRow(rows, "preference");
        row.value = rows.getColumn(next_column).getDouble();
        row.other_system = rows.getColumn(next_column + 1).getString();
        keepRow(table, std::move(row));
    }
}

/// `people`: SQL in place of the table `participants`.
ResponseTable readTable(SQLite::Database& database, const fs::path& path, const std::string& people) {
    ResponseTable table;
    table.database = path.filename().string();
    readStudy(database, people, table);
    table.notes = changeNotes(database);
    const MeasureOfAnswers measures = readMeasures(database, people, table);
    readSessions(database, table);
    readLeftOut(database, people, table);
    readChoices(database, people, table);
    readRatings(database, people, measures, table);
    readSurveyRatings(database, people, table);
    readPreferences(database, people, table);
    fitMeasured(table);
    readResponseContext(database, people, table);
    readParticipantFields(database, people, table);
    const auto active =
        textColumn(database, fmt::format("SELECT id FROM {} WHERE status = 'active' ORDER BY id", people));
    for (QuestionnaireScore& score : readQuestionnaireScores(database))
        if (score.value && std::binary_search(active.begin(), active.end(), score.participant))
            table.scores.push_back({score.participant, score.stage, score.score, *score.value});
    return table;
}

Result<ResponseTable> readSound(SQLite::Database& database, const fs::path& path) {
    if (database.execAndGet("SELECT count(*) FROM study").getInt() == 0)
        return fail(path.string(), "the database has no study yet", "Run a session with it first");
    ResponseTable table = readTable(database, path, effectiveParticipants());
    const auto by_rule = leftOutByRule(table);
    if (!by_rule.empty()) table = readTable(database, path, effectiveParticipants(by_rule));
    if (table.rows.empty() && table.scores.empty() && !table.left_out_rows.empty())
        return fail(path.string(), "everybody who answered is excluded or dropped out",
                    by_rule.empty() ? "deixis participants include counts them again; those without consent "
                                      "only once they give it"
                                    : "The study's rule [analysis.leave_out] leaves out " +
                                          std::to_string(by_rule.size()) + " of them");
    if (table.rows.empty() && table.scores.empty())
        return fail(path.string(),
                    fmt::format("the database has no answers yet ({} participants planned)",
                                table.planned_participants),
                    "Run a session with it first");
    return table;
}

}  // namespace

Result<ResponseTable> readResponses(SQLite::Database& database, const fs::path& path) {
    try {
        return readSound(database, path);
    } catch (const nlohmann::json::exception& problem) {
        return fail(
            path.string(),
            fmt::format("the database is damaged: a text that should be JSON is not ({})", problem.what()),
            "Continue with a copy from before the damage");
    }
}

std::vector<Factor> withinFactors(const ResponseTable& table) {
    std::vector<Factor> out;
    if (!table.layouts.empty()) out.push_back({"layout", table.layouts});
    if (!table.distances.empty()) out.push_back({"distance", table.distances});
    out.insert(out.end(), table.within.begin(), table.within.end());
    return out;
}

std::string levelOf(const ResponseTable& table, const ResponseRow& row, const std::string& factor) {
    if (factor == "layout") return row.layout;
    if (factor == "distance") return row.distance;
    for (std::size_t i = 0; i < table.within.size() && i < row.within.size(); ++i)
        if (table.within[i].name == factor) return row.within[i];
    return {};
}

Result<ResponseTable> loadResponses(const fs::path& database) {
    int version = 0;
    auto table = readDatabase(
        database, [&](SQLite::Database& opened) { return readResponses(opened, database); }, &version);
    if (table) table->schema_version = version;
    return table;
}

}  // namespace deixis::results
