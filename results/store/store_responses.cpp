// What happens in a session on its way into the store.
#include <fmt/core.h>

#include <stdexcept>

#include "results/database/counted_participants.hpp"
#include "store_impl.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::results {

namespace {

const studies::Stage& stageOf(const studies::Study& study, const studies::Trial& trial) {
    const studies::Stage* stage = study.findStage(trial.stage);
    if (stage == nullptr)
        throw std::logic_error(fmt::format("Store::record: the study has no stage '{}'", trial.stage));
    return *stage;
}

const ClipRecord& clipOf(const ClipRecords& clips, const studies::Stimulus& stimulus) {
    const auto found = clips.find(stimulus);
    if (found == clips.end())
        throw std::logic_error(fmt::format("Store::record: no clip is known for {} of system {}",
                                           stimulus.item, stimulus.system));
    return found->second;
}

}  // namespace

void Store::Impl::insertResponse(const studies::Response& response, const studies::Study& study,
                                 const studies::StudyPlan& plan, const ClipRecords& clips) {
    const studies::Trial& trial = plan.trials.at(static_cast<std::size_t>(response.trial_index));
    const studies::Stage& stage = stageOf(study, trial);
    if (studies::declarationOf(stage.kind).asks_consent)
        supersedeRejection(response.trial_index, response.answered);
    auto row = query(
        "INSERT INTO responses (participant, trial_index, session, status, "
        "check_passed, onset_s, onset_utc_s, motion_end_s, motion_end_utc_s, answered_s, answered_utc_s, "
        "response_time_s, paused_s, replays, pauses, begun_before, viewer_x_m, viewer_z_m, "
        "viewer_heading_deg, reason, input, head_x_m, head_y_m, "
        "head_z_m, head_qw, head_qx, head_qy, head_qz, ray_x_m, ray_y_m, ray_z_m, ray_dx, ray_dy, ray_dz) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
        "?, ?, ?, ?)");
    row << plan.participant << response.trial_index << session
        << studies::responseStatusName(response.status);
    row << response.check_passed << response.onset.time_s << response.onset.utc_s
        << response.motion_end.time_s << response.motion_end.utc_s << response.answered.time_s
        << response.answered.utc_s << response.response_time_s << response.paused_s << response.replays
        << response.pauses << response.begun_before << response.viewer.x_m << response.viewer.z_m
        << response.viewer.heading_deg;
    const Quat& turn = response.stage_from_head.orientation;
    row.textOrNull(response.reason) << response.input << response.stage_from_head.position << turn.w << turn.x
                                    << turn.y << turn.z;
    if (response.pointer) row << response.pointer->origin << response.pointer->direction;
    row.run();
    const std::int64_t id = database.getLastInsertRowid();

    for (std::size_t i = 0; i < trial.stimuli.size(); ++i) {
        const ClipRecord& clip = clipOf(clips, trial.stimuli[i]);
        auto stimulus = query("INSERT INTO response_stimuli VALUES (?, ?, ?, ?, ?, ?, ?)");
        stimulus << id << i << clip.file << clip.content_hash
                 << (i < response.plays.size() ? response.plays[i] : 0);
        stimulus.textOrNull(clip.author) << clip.trial;
        stimulus.run();
    }
    for (const studies::KeptValue& kept : response.values) {
        auto insert = query("INSERT INTO response_values VALUES (?, ?, ?, ?)");
        insert << id << kept.name << kept.value;
        if (!kept.value) insert << kept.text;
        insert.run();
    }
    int position = 0;
    for (const studies::Answer& answer : response.answers) {
        auto insert = query("INSERT INTO answers VALUES (?, ?, ?, ?, ?, ?)");
        insert << id << position++ << answer.question;
        if (answer.stimulus >= 0)
            insert << answer.stimulus;
        else
            insert.null();
        insert << answer.value;
        insert.textOrNull(answer.text);
        insert.run();
        if (studies::declarationOf(stage.kind).asks_consent) insertConsent(answer, response, study, stage);
        if (stage.about_participant) insertField(answer);
    }
    keepHash(id);
    if (!response.exclusion.empty()) exclude(response.exclusion, response.answered);
}

void Store::Impl::supersedeRejection(int trial_index, const studies::Moment& at) {
    auto declined = query(
        "SELECT 1 FROM responses AS r JOIN answers AS a ON a.response = r.id WHERE r.participant = ? AND "
        "r.trial_index = ? AND r.superseded IS NULL AND a.question = 'consent' AND a.value = 0");
    declined << session_participant << trial_index;
    if (declined.next()) supersede({trial_index, "consent was asked anew", at});
}

void Store::Impl::keepHash(std::int64_t response) {
    if (!hasher) hasher.emplace(database, AnswerHasher::Scope::one);
    auto update = query("UPDATE responses SET hash = ? WHERE id = ?");
    update << hasher->of(response) << response;
    update.run();
}

void Store::Impl::insertConsent(const studies::Answer& answer, const studies::Response& response,
                                const studies::Study& study, const studies::Stage& stage) {
    const bool agreed = answer.value.value_or(0.0) != 0.0;
    auto insert = query("INSERT OR REPLACE INTO consents VALUES (?, ?, ?, ?, ?, ?, ?)");
    insert << session_participant << stage.name << session << agreed << response.answered.utc_s
           << study.language << stage.text;
    insert.run();
    if (!agreed) {
        auto out = query(
            "UPDATE participants SET status = 'dropped', reason = ?1 WHERE id = ?2 AND (status = 'active' OR "
            "reason = ?3)");
        out << declined_reason << session_participant << asked_anew_reason;
        out.run();
        groups_taken.reset();
        return;
    }
    static const std::string back_sql = fmt::format(
        "UPDATE participants SET status = 'active', reason = NULL WHERE id = ? AND status = 'dropped' AND "
        "reason IN (?, ?) AND NOT {}",
        declinedConsent("participants.id"));
    auto back = query(back_sql.c_str());
    back << session_participant << declined_reason << asked_anew_reason;
    back.run();
    groups_taken.reset();
}

void Store::Impl::insertField(const studies::Answer& answer) {
    auto insert = query("INSERT OR REPLACE INTO participant_fields VALUES (?, ?, ?, ?)");
    insert << session_participant << answer.question << answer.value;
    insert.textOrNull(answer.text);
    insert.run();
}

void Store::Impl::supersede(const studies::Superseded& superseded) {
    auto counting = query(
        "SELECT id, hash IS NOT NULL FROM responses WHERE participant = ? AND trial_index = ? AND superseded "
        "IS "
        "NULL");
    counting << session_participant << superseded.trial_index;
    if (!counting.next())
        throw std::logic_error(
            fmt::format("Store::record: trial {} of participant {} has no answer yet that "
                        "could be superseded",
                        superseded.trial_index, session_participant));
    const std::int64_t id = counting[0].getInt64();
    const bool hashed = counting[1].getInt() != 0;
    auto update = query("UPDATE responses SET superseded = ?, superseded_utc_s = ? WHERE id = ?");
    update << superseded.reason << superseded.at.utc_s << id;
    update.run();
    if (hashed) keepHash(id);
}

void Store::Impl::exclude(const std::string& reason, const studies::Moment& at) {
    leaveOut(ParticipantStatus::excluded, reason);
    insertNote({studies::NoteKind::excluded, -1, at, reason});
}

void Store::Impl::abort(const std::string& reason) {
    leaveOut(ParticipantStatus::dropped, reason.empty() ? operator_ended_reason : reason);
}

void Store::Impl::insertNote(const studies::Note& note) {
    auto insert = query(
        "INSERT INTO events (session, kind, trial_index, time_s, utc_s, detail) VALUES (?, ?, ?, ?, ?, ?)");
    insert << session << studies::noteKindName(note.kind);
    if (note.trial_index >= 0)
        insert << note.trial_index;
    else
        insert.null();
    insert << note.at.time_s << note.at.utc_s << note.detail;
    insert.run();
}

}  // namespace deixis::results
