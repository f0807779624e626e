// What the store tells of what it holds.
#include <fmt/core.h>

#include <algorithm>

#include "core/order_statistics.hpp"
#include "response_values.hpp"
#include "results/database/counted_participants.hpp"
#include "store_impl.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::results {

namespace {

studies::CheckKind checkKind(const std::string& name) {
    using studies::CheckKind;
    for (const CheckKind kind : {CheckKind::number, CheckKind::catch_trial})
        if (name == studies::checkKindName(kind)) return kind;
    return CheckKind::repeat;  // the table knows no other
}

}  // namespace

std::optional<Registration> Store::registration(const std::string& participant) const {
    auto row = impl_->query("SELECT number, language FROM participants WHERE id = ?");
    row << participant;
    if (!row.next()) return std::nullopt;
    Registration out{participant, row[0].getInt(), row.text(1), {}};
    auto group = impl_->query("SELECT factor, level FROM participant_groups WHERE participant = ?");
    group << participant;
    while (group.next()) out.groups[group.text(0)] = group.text(1);
    return out;
}

std::vector<std::string> Store::participants() const {
    auto row = impl_->query("SELECT id FROM participants ORDER BY id");
    std::vector<std::string> ids;
    while (row.next()) ids.push_back(row.text(0));
    return ids;
}

int Store::firstFreeNumber() const {
    auto row = impl_->query("SELECT coalesce(max(number), 0) + 1 FROM participants");
    row.next();
    return row[0].getInt();
}

bool Store::numberTaken(int number) const {
    auto row = impl_->query("SELECT 1 FROM participants WHERE number = ?");
    row << number;
    return row.next();
}

studies::GroupSizes Store::Impl::countGroups(const std::string& people) {
    auto row = query(fmt::format("SELECT p.id, g.factor, g.level FROM {} AS p LEFT JOIN participant_groups "
                                 "AS g ON g.participant = p.id ORDER BY p.number",
                                 people)
                         .c_str());
    std::vector<studies::Groups> each;
    std::string last;
    while (row.next()) {
        if (each.empty() || row.text(0) != last) each.emplace_back();
        last = row.text(0);
        if (!row[1].isNull()) each.back()[row.text(1)] = row.text(2);
    }
    studies::GroupSizes out;
    for (studies::Groups& groups : each) ++out[std::move(groups)];
    return out;
}

studies::GroupSizes Store::groupsTaken() const {
    if (impl_->groups_taken) return *impl_->groups_taken;
    auto out = impl_->countGroups(
        fmt::format("(SELECT * FROM {} WHERE status = 'active')", effectiveParticipants()));
    if (impl_->durability == Durability::whole_run) impl_->groups_taken = out;
    return out;
}

studies::GroupSizes Store::groupsRegistered() const {
    if (impl_->groups_registered) return *impl_->groups_registered;
    auto out = impl_->countGroups("participants");
    if (impl_->durability == Durability::whole_run) impl_->groups_registered = out;
    return out;
}

studies::Resume Store::resume(const std::string& participant, double now_utc_s) const {
    studies::Resume out;
    auto answer = impl_->query(
        "SELECT r.trial_index, t.kind, coalesce((SELECT value FROM response_values WHERE response = r.id AND "
        "name "
        "= 'correct'), 0) FROM responses AS r "
        "JOIN trials AS t USING (participant, trial_index) WHERE r.participant = ? AND r.superseded IS NULL "
        "AND NOT EXISTS (SELECT 1 FROM consents AS c WHERE c.participant = r.participant AND c.stage = "
        "t.stage AND c.session = r.session AND NOT c.agreed)");
    answer << participant;
    while (answer.next()) {
        const studies::StageDeclaration* kind = studies::findDeclaration(answer.text(1));
        const bool can_be_wrong = kind != nullptr && kind->right_or_wrong;
        out.answered[answer[0].getInt()] = !can_be_wrong || answer[2].getInt() != 0;
    }
    auto failed = impl_->query(
        "SELECT t.stage, t.check_kind FROM responses AS r JOIN trials AS t USING (participant, trial_index) "
        "WHERE r.participant = ?1 AND r.superseded IS NULL AND r.check_passed = 0 AND r.session > coalesce("
        "(SELECT max(e.session) FROM events AS e JOIN sessions AS s ON s.id = e.session WHERE s.participant "
        "= ?1 AND e.kind = 'included'), 0)");
    failed << participant;
    while (failed.next()) ++out.check_failures[{failed.text(0), checkKind(failed.text(1))}];
    auto begun = impl_->query(
        "SELECT DISTINCT e.trial_index FROM events AS e JOIN sessions AS s ON s.id = e.session "
        "WHERE s.participant = ? AND e.kind = 'stimulus_onset' AND e.trial_index IS NOT NULL");
    begun << participant;
    while (begun.next())
        if (!out.answered.contains(begun[0].getInt())) out.begun.insert(begun[0].getInt());
    auto last = impl_->query(
        "SELECT max(max(started_utc_s, coalesce(ended_utc_s, 0.0), "
        "coalesce((SELECT max(utc_s) FROM events WHERE session = s.id AND kind <> 'included'), 0.0), "
        "coalesce((SELECT max(answered_utc_s) FROM responses AS r WHERE r.participant = s.participant AND "
        "r.session = s.id), 0.0))) FROM sessions AS s WHERE participant = ?");
    last << participant;
    if (last.next() && !last[0].isNull()) out.gap_s = std::max(0.0, now_utc_s - last[0].getDouble());
    // What a repeat is held against.
    auto first = impl_->query(
        "SELECT r.id, r.trial_index, r.status FROM responses AS r "
        "WHERE r.participant = ?1 AND r.superseded IS NULL AND r.trial_index IN (SELECT check_of_trial FROM "
        "trials WHERE participant = ?1 AND check_of_trial IS NOT NULL) ORDER BY r.trial_index");
    first << participant;
    while (first.next()) {
        studies::Response& response = out.first_answers.emplace_back();
        response.trial_index = first[1].getInt();
        response.status = studies::responseStatusNamed(first.text(2));
        response.values = readResponseValues(impl_->database, first[0].getInt64());
        auto answers = impl_->query(
            "SELECT question, stimulus, value, text FROM answers WHERE response = ? ORDER BY "
            "position");
        answers << first[0].getInt64();
        while (answers.next()) {
            studies::Answer& one = response.answers.emplace_back();
            one.question = answers.text(0);
            if (!answers[1].isNull()) one.stimulus = answers[1].getInt();
            if (!answers[2].isNull()) one.value = answers[2].getDouble();
            if (!answers[3].isNull()) one.text = answers.text(3);
        }
    }
    return out;
}

bool Store::hasSession(const std::string& participant, bool synthetic) const {
    auto row = impl_->query("SELECT 1 FROM sessions WHERE participant = ? AND synthetic = ? LIMIT 1");
    row << participant << synthetic;
    return row.next();
}

std::map<std::string, double> Store::secondsPerUnit() const {
    // A unit starts with its first clip, or when its page is shown. The last one of a stage has none after it
    // in the stage: it takes until its answer.
    auto row = impl_->query(
        "SELECT stage, coalesce(next_start, answered_utc_s) - start FROM ("
        "  SELECT *, lead(start) OVER (PARTITION BY session, stage ORDER BY start) AS next_start FROM ("
        "    SELECT r.session, t.stage, r.answered_utc_s,"
        "           min(r.onset_utc_s, coalesce(e.first_utc_s, r.onset_utc_s)) AS start"
        "      FROM responses AS r JOIN trials AS t USING (participant, trial_index)"
        "      JOIN sessions AS s ON s.id = r.session"
        "      LEFT JOIN (SELECT session, trial_index, min(utc_s) AS first_utc_s FROM events"
        "           WHERE kind = 'stimulus_onset' GROUP BY session, trial_index) AS e"
        "        ON e.session = r.session AND e.trial_index = r.trial_index"
        "     WHERE s.outcome = 'finished' AND r.status <> 'skipped' AND r.superseded IS NULL))");
    std::map<std::string, std::vector<double>> seconds;
    while (row.next()) seconds[row.text(0)].push_back(row[1].getDouble());
    std::map<std::string, double> out;
    for (auto& [stage, each] : seconds) out[stage] = median(std::move(each));
    return out;
}

}  // namespace deixis::results
