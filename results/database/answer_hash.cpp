#include "results/database/answer_hash.hpp"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include "core/hash.hpp"

namespace deixis::results {

namespace {

using SQLite::Statement;

// The columns of version 5, in which what the game keeps stood among them: kept values of these names are
// told where they were, so that its answers keep their hashes. All other kept values come behind, and so does
// what a later version adds, in hashes of its own answers only.
constexpr const char* once_in_trials[]{"distractors", "balls", "target_place"};
constexpr const char* once_in_responses[]{"chosen_place", "correct"};
constexpr int first_hashed = 4;   ///< of response_columns: id, hash, participant and trial_index come before
constexpr int before_chosen = 5;  ///< of response_columns: they stood from here on
constexpr int before_balls = 11;  ///< of trial_columns: likewise
constexpr const char* response_columns =
    "r.id, r.hash, r.participant, r.trial_index, r.status, r.check_passed, "
    "r.onset_s, r.onset_utc_s, r.motion_end_s, r.motion_end_utc_s, r.answered_s, r.answered_utc_s, "
    "r.response_time_s, r.paused_s, r.replays, r.pauses, r.begun_before, r.reason, r.input, r.head_x_m, "
    "r.head_y_m, r.head_z_m, r.head_qw, r.head_qx, r.head_qy, r.head_qz, r.ray_x_m, r.ray_y_m, r.ray_z_m, "
    "r.ray_dx, r.ray_dy, r.ray_dz, r.viewer_x_m, r.viewer_z_m, r.viewer_heading_deg, r.superseded, "
    "r.superseded_utc_s, s.station, s.synthetic";
constexpr const char* trial_columns =
    "stage, kind, practice, attempt, page, layout, distance, target_id, target_x_m, target_y_m, target_z_m, "
    "check_kind, check_stimulus, check_expected, check_of_trial, "
    "visibility, angles";

// What is the same in each database of a study, whatever the language of its texts.
constexpr std::array<const char*, 7> study_queries{
    "SELECT name, hash, alpha, ball_diameter_m FROM study",
    "SELECT position, name, kind, sitting, practice_of, measure, scale_low, scale_high FROM stages ORDER BY "
    "1",
    "SELECT position, name, generator, levels FROM systems ORDER BY 1",
    "SELECT position, name, viewer_x_m, viewer_z_m, heading_deg FROM layouts ORDER BY 1",
    "SELECT position, name, low_m, high_m, distractors FROM distances ORDER BY 1",
    "SELECT stage, question, position, kind, low, high FROM questions ORDER BY 1, 2",
    "SELECT stage, name, position, items, reversed, mean, factor, offset_ FROM scores ORDER BY 1, 2"};

std::string select(const char* what, const char* key, const char* order, AnswerHasher::Scope scope) {
    return fmt::format("SELECT {}{} ORDER BY {}", what,
                       scope == AnswerHasher::Scope::one ? fmt::format(" WHERE {} = ?", key) : "", order);
}

void append(std::string& content, const SQLite::Column& value) {
    const auto out = std::back_inserter(content);
    if (value.isNull()) {
        content += 'n';
    } else if (value.isInteger()) {
        fmt::format_to(out, "i{};", value.getInt64());
    } else if (value.isFloat()) {
        fmt::format_to(out, "f{:016x}", std::bit_cast<std::uint64_t>(value.getDouble()));
    } else {
        const int bytes = value.getBytes();
        fmt::format_to(out, "t{}:", bytes);
        content.append(static_cast<const char*>(value.getBlob()), static_cast<std::size_t>(bytes));
    }
}

void appendRow(std::string& content, const Statement& row, int from) {
    for (int i = from; i < row.getColumnCount(); ++i) append(content, row.getColumn(i));
    content += '\n';
}

/// The same, with kept values told before column `at`.
void appendRow(std::string& content, const Statement& row, int from, int at, const std::string& kept) {
    for (int i = from; i < at; ++i) append(content, row.getColumn(i));
    content += kept;
    appendRow(content, row, at);
}

/// Whole numbers as such: version 5 had columns of that type.
std::string keptContent(const SQLite::Column& value, const SQLite::Column& text) {
    std::string content;
    const double number = value.getDouble();
    if (value.isNull())
        append(content, text);
    else if (number == std::trunc(number) && std::abs(number) < 1e15)
        content = fmt::format("i{};", static_cast<std::int64_t>(number));
    else
        append(content, value);
    return content;
}

/// Those of these names, which are taken out.
template <std::size_t N>
std::string taken(std::map<std::string, std::string>& kept, const char* const (&names)[N]) {
    std::string content;
    for (const char* name : names) {
        const auto found = kept.extract(name);
        content += found ? found.mapped() : "n";
    }
    return content;
}

std::string studyContent(SQLite::Database& database) {
    std::string content;
    for (const char* query : study_queries) {
        Statement rows(database, query);
        while (rows.executeStep()) appendRow(content, rows, 0);
        content += '|';
    }
    return sha256Hex(content);
}

}  // namespace

AnswerHasher::AnswerHasher(SQLite::Database& database, Scope scope)
    : responses_(database, select(fmt::format("{} FROM responses AS r JOIN sessions AS s ON s.id = r.session",
                                              response_columns)
                                      .c_str(),
                                  "r.id", "r.id", scope)),
      answers_{Statement(database, select("response, position, question, stimulus, value, text FROM answers",
                                          "response", "response, position", scope))},
      clips_{
          Statement(database, select("response, position, clip_file, clip_hash, plays, author, author_trial "
                                     "FROM response_stimuli",
                                     "response", "response, position", scope))},
      kept_{Statement(database, select("response, name, value, text FROM response_values", "response",
                                       "response, name", scope))},
      trial_(database,
             fmt::format("SELECT {} FROM trials WHERE participant = ? AND trial_index = ?", trial_columns)),
      trial_kept_(database,
                  "SELECT name, value, text FROM trial_values WHERE participant = ? AND trial_index = ? "
                  "ORDER BY name"),
      stimuli_(database,
               "SELECT position, system, item, scored, clip FROM trial_stimuli WHERE participant = ? AND "
               "trial_index = ? ORDER BY position"),
      groups_(database, "SELECT factor, level FROM participant_groups WHERE participant = ? ORDER BY factor"),
      study_(studyContent(database)) {
    if (scope == Scope::one) return;
    kept_.there = kept_.rows.executeStep();
    answers_.there = answers_.rows.executeStep();
    clips_.there = clips_.rows.executeStep();
}

std::string AnswerHasher::of(std::int64_t response) {
    for (Statement* rows : {&responses_, &answers_.rows, &clips_.rows, &kept_.rows}) {
        rows->reset();
        rows->bind(1, response);
    }
    if (!responses_.executeStep())
        throw std::logic_error(fmt::format("AnswerHasher: there is no response {}", response));
    answers_.there = answers_.rows.executeStep();
    clips_.there = clips_.rows.executeStep();
    kept_.there = kept_.rows.executeStep();
    std::string computed = hashed().computed;
    for (Statement* rows : {&responses_, &answers_.rows, &clips_.rows, &kept_.rows}) rows->reset();
    return computed;
}

std::optional<HashedAnswer> AnswerHasher::next() {
    if (!responses_.executeStep()) return std::nullopt;
    return hashed();
}

template <typename Take>
void AnswerHasher::Part::of(std::int64_t response, const Take& take) {
    // Rows of no response come before: what they refer to is looked at elsewhere.
    while (there && rows.getColumn(0).getInt64() < response) there = rows.executeStep();
    while (there && rows.getColumn(0).getInt64() == response) {
        take(rows);
        there = rows.executeStep();
    }
}

HashedAnswer AnswerHasher::hashed() {
    HashedAnswer out;
    out.id = responses_.getColumn(0).getInt64();
    if (!responses_.getColumn(1).isNull()) out.stored = responses_.getColumn(1).getString();
    out.participant = responses_.getColumn(2).getString();
    out.trial_index = responses_.getColumn(3).getInt();
    std::string content =
        fmt::format("{}\n{}{}|{}\n", study_, groupsOf(out.participant), out.participant, out.trial_index);
    Kept given;
    kept_.of(out.id, [&](const Statement& row) {
        given[row.getColumn(1).getString()] = keptContent(row.getColumn(2), row.getColumn(3));
    });
    appendRow(content, responses_, first_hashed, before_chosen, taken(given, once_in_responses));
    Kept planned = appendTrial(content, out.participant, out.trial_index);
    const auto row = [&](const Statement& rows) { appendRow(content, rows, 1); };
    for (Part* part : {&answers_, &clips_}) {
        content += '|';
        part->of(out.id, row);
    }
    for (const Kept& others : {planned, given})
        for (const auto& [name, value] : others) content += fmt::format("|{}:{}", name, value);
    out.computed = sha256Hex(content);
    return out;
}

const std::string& AnswerHasher::groupsOf(const std::string& participant) {
    if (participant == known_participant_) return known_groups_;
    known_groups_.clear();
    groups_.reset();
    groups_.bind(1, participant);
    while (groups_.executeStep()) appendRow(known_groups_, groups_, 0);
    groups_.reset();
    known_participant_ = participant;
    return known_groups_;
}

AnswerHasher::Kept AnswerHasher::appendTrial(std::string& content, const std::string& participant,
                                             int trial_index) {
    for (Statement* rows : {&trial_, &trial_kept_, &stimuli_}) {
        rows->reset();
        rows->bind(1, participant);
        rows->bind(2, trial_index);
    }
    Kept planned;
    while (trial_kept_.executeStep())
        planned[trial_kept_.getColumn(0).getString()] =
            keptContent(trial_kept_.getColumn(1), trial_kept_.getColumn(2));
    content += '|';
    const std::string balls = taken(planned, once_in_trials);
    while (trial_.executeStep()) appendRow(content, trial_, 0, before_balls, balls);
    content += '|';
    while (stimuli_.executeStep()) appendRow(content, stimuli_, 0);
    for (Statement* rows : {&trial_, &trial_kept_, &stimuli_}) rows->reset();
    return planned;
}

}  // namespace deixis::results
