#include "results/store/recording.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "response_values.hpp"
#include "results/database/database_open.hpp"
#include "results/database/tracking_blocks.hpp"

namespace deixis::results {

namespace {

using SQLite::Statement;

// What stands in the database once: the plan, the layouts and the balls' size.
struct Setting {
    studies::StudyPlan plan;
    std::map<std::string, studies::Layout> layouts;
    double ball_diameter_m = 0.1;
};

Result<Setting> readSetting(SQLite::Database& database, const std::string& participant) {
    Statement stored(database, "SELECT json FROM plans WHERE participant = ?");
    stored.bind(1, participant);
    if (!stored.executeStep())
        return fail(participant, "no such participant in this database",
                    "'deixis participants list' lists the participants");
    auto plan = studies::planFromJson(stored.getColumn(0).getString());
    if (!plan) return tl::unexpected(plan.error());
    Setting setting;
    setting.plan = std::move(*plan);
    Statement layouts(database, "SELECT name, viewer_x_m, viewer_z_m, heading_deg FROM layouts");
    while (layouts.executeStep())
        setting.layouts[layouts.getColumn(0).getString()] = {
            layouts.getColumn(0).getString(), layouts.getColumn(1).getDouble(),
            layouts.getColumn(2).getDouble(), layouts.getColumn(3).getDouble()};
    Statement study(database, "SELECT ball_diameter_m FROM study");
    if (study.executeStep() && !study.getColumn(0).isNull())
        setting.ball_diameter_m = study.getColumn(0).getDouble();
    return setting;
}

// "stimulus 2" or "stimulus 2, replay 1" in a note's detail, counted from 1; where there is one stimulus
// nothing is said of it.
int stimulusOf(const std::string& detail) {
    constexpr std::string_view word = "stimulus ";
    if (detail.rfind(word, 0) != 0) return 0;
    int number = 0;
    for (std::size_t i = word.size(); i < detail.size() && detail[i] >= '0' && detail[i] <= '9'; ++i)
        number = 10 * number + (detail[i] - '0');
    return std::max(0, number - 1);
}

// The plays of a trial in a session that came before an answer, and after the one before it.
std::vector<studies::RecordedPlay> readPlays(SQLite::Database& database, long long session, int trial_index,
                                             double after_s, double until_s) {
    std::vector<studies::RecordedPlay> plays;
    Statement notes(
        database,
        "SELECT kind, detail, time_s FROM events WHERE session = ? AND trial_index = ? AND kind IN "
        "('stimulus_onset', 'motion_end') AND time_s > ? AND time_s <= ? ORDER BY id");
    notes.bind(1, static_cast<std::int64_t>(session));
    notes.bind(2, trial_index);
    notes.bind(3, after_s);
    notes.bind(4, until_s);
    while (notes.executeStep()) {
        const int stimulus = stimulusOf(notes.getColumn(1).getString());
        const double time_s = notes.getColumn(2).getDouble();
        if (notes.getColumn(0).getString() == studies::noteKindName(studies::NoteKind::stimulus_onset)) {
            plays.push_back({stimulus, time_s, {}});
            continue;
        }
        const auto begun = std::find_if(plays.rbegin(), plays.rend(), [&](const studies::RecordedPlay& play) {
            return play.stimulus == stimulus && !play.end_s;
        });
        if (begun != plays.rend()) begun->end_s = time_s;
    }
    return plays;
}

Result<std::vector<studies::TrackingSample>> readTracking(SQLite::Database& database, long long session,
                                                          int trial_index, double until_s) {
    std::vector<studies::TrackingSample> samples;
    Statement blocks(
        database,
        "SELECT data FROM tracking_blocks WHERE session = ? AND trial_index = ? ORDER BY first_frame");
    blocks.bind(1, static_cast<std::int64_t>(session));
    blocks.bind(2, trial_index);
    while (blocks.executeStep()) {
        const SQLite::Column data = blocks.getColumn(0);
        auto block = unpackTracking(
            {static_cast<const char*>(data.getBlob()), static_cast<std::size_t>(data.getBytes())});
        if (!block) return tl::unexpected(block.error());
        for (auto& sample : *block)
            if (sample.display_time_s <= until_s) samples.push_back(std::move(sample));
    }
    return samples;
}

void readAnswers(SQLite::Database& database, long long response, studies::RecordedTrial& trial) {
    Statement answers(
        database, "SELECT question, stimulus, value, text FROM answers WHERE response = ? ORDER BY position");
    answers.bind(1, static_cast<std::int64_t>(response));
    while (answers.executeStep()) {
        studies::Answer& answer = trial.answers.emplace_back();
        answer.question = answers.getColumn(0).getString();
        if (!answers.getColumn(1).isNull()) answer.stimulus = answers.getColumn(1).getInt();
        if (!answers.getColumn(2).isNull()) answer.value = answers.getColumn(2).getDouble();
        if (!answers.getColumn(3).isNull()) answer.text = answers.getColumn(3).getString();
    }
}

void readClips(SQLite::Database& database, long long response, RecordedAnswer& out) {
    Statement clips(
        database,
        "SELECT position, clip_file, clip_hash FROM response_stimuli WHERE response = ? ORDER BY position");
    clips.bind(1, static_cast<std::int64_t>(response));
    while (clips.executeStep()) {
        const auto position = static_cast<std::size_t>(clips.getColumn(0).getInt());
        if (position >= out.trial.trial.stimuli.size()) continue;
        out.clips[out.trial.trial.stimuli[position]] = {clips.getColumn(1).getString(),
                                                        clips.getColumn(2).getString()};
    }
}

std::string inWords(const studies::RecordedTrial& trial, studies::ResponseStatus status,
                    double response_time_s) {
    if (status != studies::ResponseStatus::answered && trial.chosenPlace() < 0)
        return status == studies::ResponseStatus::timed_out ? "no answer in time" : "skipped";
    std::string words;
    if (trial.chosenPlace() >= 0)
        words = fmt::format("chose ball {} of {}, {}", trial.chosenPlace() + 1, trial.trial.ball_order.size(),
                            studies::keptNumber(trial.values, "correct") == 1.0 ? "correct" : "wrong");
    for (const studies::Answer& answer : trial.answers) {
        if (!words.empty()) words += ", ";
        words += answer.question;
        if (answer.stimulus >= 0 && trial.trial.stimuli.size() > 1)
            words += fmt::format(" of {}", answer.stimulus + 1);
        if (answer.value) words += fmt::format(" {:g}", *answer.value);
        if (!answer.text.empty()) words += " " + answer.text;
    }
    return fmt::format("{}, after {:.2f} s", words, response_time_s);
}

Result<Recording> readRecording(SQLite::Database& database, const std::string& participant) {
    auto setting = readSetting(database, participant);
    if (!setting) return tl::unexpected(setting.error());
    Recording recording;
    recording.participant = participant;
    recording.study_title = database.execAndGet("SELECT title FROM study").getString();
    recording.study_source = database.execAndGet("SELECT coalesce(source, '') FROM study").getString();
    Statement responses(
        database,
        "SELECT r.id, r.trial_index, r.session, r.status, r.motion_end_s, "
        "r.answered_s, "
        "r.response_time_s, r.superseded IS NOT NULL, e.station, e.synthetic, "
        "r.head_x_m, r.head_y_m, r.head_z_m, r.head_qw, r.head_qx, r.head_qy, r.head_qz, "
        "r.ray_x_m, r.ray_y_m, r.ray_z_m, r.ray_dx, r.ray_dy, r.ray_dz, e.avatar_hash, "
        "r.viewer_x_m, r.viewer_z_m, r.viewer_heading_deg "
        "FROM responses AS r JOIN sessions AS e ON e.id = r.session WHERE r.participant = ? ORDER BY r.id");
    responses.bind(1, participant);
    // By session and trial: when the answer before was given.
    std::map<std::pair<long long, int>, double> before;
    while (responses.executeStep()) {
        const int index = responses.getColumn(1).getInt();
        const auto& trials = setting->plan.trials;
        const auto planned = std::find_if(trials.begin(), trials.end(),
                                          [&](const studies::Trial& trial) { return trial.index == index; });
        if (planned == trials.end() || planned->stimuli.empty()) continue;
        RecordedAnswer& out = recording.answers.emplace_back();
        const long long response = responses.getColumn(0).getInt64();
        out.session = responses.getColumn(2).getInt64();
        out.superseded = responses.getColumn(7).getInt() != 0;
        out.avatar_hash = responses.getColumn(23).getString();
        studies::RecordedTrial& trial = out.trial;
        trial.trial = *planned;
        trial.layout = setting->layouts[planned->layout];
        if (!responses.getColumn(24).isNull())  // else from before it was kept: the layout's own
            trial.layout = {planned->layout, responses.getColumn(24).getDouble(),
                            responses.getColumn(25).getDouble(), responses.getColumn(26).getDouble()};
        trial.ball_diameter_m = setting->ball_diameter_m;
        trial.station = responses.getColumn(8).getString();
        trial.synthetic = responses.getColumn(9).getInt() != 0;
        trial.values = readResponseValues(database, response);
        trial.open_s = responses.getColumn(4).getDouble();
        trial.answered_s = responses.getColumn(5).getDouble();
        const auto number = [&](int column) { return responses.getColumn(column).getDouble(); };
        trial.stage_from_head = {{number(10), number(11), number(12)},
                                 {number(13), number(14), number(15), number(16)}};
        if (!responses.getColumn(17).isNull())
            trial.pointer = Ray{{number(17), number(18), number(19)}, {number(20), number(21), number(22)}};
        constexpr double confirmed_s = 1.0;
        double& answered_before_s = before.try_emplace({out.session, index}, -1.0).first->second;
        trial.plays = readPlays(database, out.session, index, answered_before_s, trial.answered_s);
        auto tracking = readTracking(database, out.session, index, trial.answered_s + confirmed_s);
        if (!tracking) return tl::unexpected(tracking.error());
        std::erase_if(*tracking, [&](const studies::TrackingSample& sample) {
            return sample.display_time_s <= answered_before_s;
        });
        trial.tracking = std::move(*tracking);
        answered_before_s = trial.answered_s;
        readAnswers(database, response, trial);
        readClips(database, response, out);
        out.outcome = inWords(trial, studies::responseStatusNamed(responses.getColumn(3).getString()),
                              responses.getColumn(6).getDouble());
    }
    return recording;
}

}  // namespace

Result<Recording> loadRecording(const std::filesystem::path& database, const std::string& participant) {
    return readDatabase(database,
                        [&](SQLite::Database& opened) { return readRecording(opened, participant); });
}

}  // namespace deixis::results
