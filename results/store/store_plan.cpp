// A study, its participants and their plans on their way into the store, and back.
#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/hash.hpp"
#include "results/database/participant_token.hpp"
#include "store_differences.hpp"
#include "store_impl.hpp"
#include "studies/study_file/stage_kind.hpp"

namespace deixis::results {

namespace {

using Json = nlohmann::ordered_json;

const char* kindName(studies::QuestionKind kind) {
    switch (kind) {
        case studies::QuestionKind::scale:
            return "scale";
        case studies::QuestionKind::choice:
            return "choice";
        case studies::QuestionKind::choices:
            return "choices";
        case studies::QuestionKind::number:
            return "number";
        case studies::QuestionKind::text:
            return "text";
    }
    throw std::logic_error("no such kind of question");
}

Json leaveOutJson(const studies::LeaveOutRule& rule) {
    Json out = Json::object();
    const auto add = [&out](const char* key, const std::optional<double>& value) {
        if (value) out[key] = *value;
    };
    add("same_rating_share", rule.same_rating_share);
    add("one_side_share", rule.one_side_share);
    add("median_time_below_s", rule.median_time_below_s);
    return out;
}

/// What reports must say of systems; those of which there is nothing to say are not among them.
Json systemsJson(const std::vector<studies::SystemSource>& systems) {
    Json out = Json::object();
    for (const studies::SystemSource& system : systems) {
        if (!system.processing.empty()) out[system.name]["processing"] = system.processing;
        if (system.compared) continue;
        out[system.name]["compared"] = false;
        out[system.name]["remark"] = system.remark;
    }
    return out;
}

/// Questions whose answers rate a system.
Json ratesJson(const std::vector<studies::Stage>& stages) {
    Json out = Json::array();
    for (const studies::Stage& stage : stages)
        for (const studies::Question& question : stage.questionnaire.questions)
            if (question.rates)
                out.push_back({{"stage", stage.name},
                               {"question", question.id},
                               {"measure", question.rates->measure},
                               {"system", question.rates->system}});
    return out;
}

}  // namespace

std::optional<studies::StudyPlan> Store::Impl::plan(const std::string& participant) {
    auto kept = query("SELECT json FROM plans WHERE participant = ?");
    kept << participant;
    if (!kept.next()) return std::nullopt;
    auto stored = studies::planFromJson(kept.text(0));
    if (!stored)
        throw std::runtime_error(fmt::format("{}: the stored plan of participant {} cannot be read: {}",
                                             path.string(), participant, stored.error().text()));
    return std::move(*stored);
}

std::optional<studies::StudyPlan> Store::plan(const std::string& participant) const {
    return impl_->plan(participant);
}

Result<void> Store::storePlan(const studies::Study& study, const Registration& registration,
                              const studies::StudyPlan& plan, const std::string& locked_hash) {
    Result<void> outcome{};
    impl_->transaction([&] {
        if (auto objection = impl_->objection(study, registration, plan, locked_hash)) {
            outcome = tl::unexpected(std::move(*objection));
            return;
        }
        if (!impl_->query("SELECT 1 FROM study").next()) impl_->insertStudy(study, locked_hash);
        auto known = impl_->query("SELECT 1 FROM plans WHERE participant = ?");
        known << plan.participant;
        if (known.next()) return;
        impl_->insertRegistration(registration);
        impl_->insertPlan(plan, studies::planJson(plan), locked_hash);
    });
    return outcome;
}

Result<void> Store::exclusively(const std::function<Result<void>()>& work) {
    Result<void> outcome{};
    struct Undone {};
    try {
        impl_->transaction([&] {
            outcome = work();
            if (!outcome) throw Undone();
        });
    } catch (const Undone&) {
        // The transaction has been rolled back.
    }
    return outcome;
}

std::optional<Error> Store::Impl::objection(const studies::Study& study, const Registration& registration,
                                            const studies::StudyPlan& plan, const std::string& locked_hash) {
    const std::string where = path.string();
    if (registration.participant != plan.participant || registration.number != plan.number ||
        registration.groups != plan.groups)
        throw std::logic_error(fmt::format("Store::storePlan: participant {} is registered, the plan is {}'s",
                                           registration.participant, plan.participant));
    if (locked_hash.empty()) {
        if (plan.study_hash != study.hash)
            return Error{where,
                         fmt::format("the plan of participant {} was made for another study file (hash "
                                     "{:.12}, not {:.12})",
                                     plan.participant, plan.study_hash, study.hash)};
        if (auto other = studyObjection(study)) return other;
    }
    auto earlier = query("SELECT hash FROM plans WHERE participant = ?");
    earlier << plan.participant;
    if (earlier.next()) {
        const std::string hash = sha256Hex(studies::planJson(plan));
        if (earlier.text(0) == hash) return std::nullopt;
        return Error{
            where,
            fmt::format("the database has another plan for participant {} (hash {:.12}, not {:.12}){}",
                        plan.participant, earlier.text(0), hash,
                        listed(planDifferences(*this->plan(plan.participant), plan))),
            "Continue with the stored plan, or use another participant id"};
    }
    if (!locked_hash.empty()) {
        auto known = query("SELECT name, coalesce(locked_hash, '') FROM study");
        if (known.next() && known.text(1) != locked_hash)
            return Error{where,
                         fmt::format("the database has the study '{}' with other files (locked as {:.12}, "
                                     "not {:.12}): another station has begun or changed it meanwhile",
                                     known.text(0), known.text(1), locked_hash),
                         "Run this again: it then says what differs"};
    }
    auto namesake = query("SELECT id FROM participants WHERE number = ?");
    namesake << registration.number;
    if (namesake.next())
        return Error{where,
                     fmt::format("participant {} cannot have number {}: it is participant {}'s",
                                 registration.participant, registration.number, namesake.text(0)),
                     "Give another one with --number, or none: the next free one is then used"};
    return std::nullopt;
}

void Store::Impl::insertStudy(const studies::Study& study, const std::string& locked_hash) {
    auto row = query(
        "INSERT INTO study (id, name, title, hash, source, alpha, ball_diameter_m, locked_hash, analysis) "
        "VALUES (1, ?, ?, ?, ?, ?, ?, ?, ?)");
    row << study.name << study.title << study.hash;
    row.textOrNull(study.source) << study.alpha << study.targets.ball_diameter_m;
    row.textOrNull(locked_hash);
    row << Json{{"stations", study.stations_together ? "together" : "apart"},
                {"unit", study.by_ratings ? "ratings" : "participants"},
                {"equivalence", Json(study.equivalence)},
                {"leave_out", leaveOutJson(study.leave_out)},
                {"systems", systemsJson(study.systems)},
                {"rates", ratesJson(study.stages)}}
               .dump();
    row.run();
    int position = 0;
    for (const auto& system : study.systems) {
        auto insert = query("INSERT INTO systems VALUES (?, ?, ?, ?, ?)");
        insert << position++ << system.name;
        insert.textOrNull(system.generator)
                .textOrNull(system.projects.empty() ? system.manifest : system.projects)
            << Json(system.levels).dump();
        insert.run();
    }
    position = 0;
    for (const auto& layout : study.layouts) {
        auto insert = query("INSERT INTO layouts VALUES (?, ?, ?, ?, ?)");
        insert << position++ << layout.name << layout.viewer_x_m << layout.viewer_z_m << layout.heading_deg;
        insert.run();
    }
    position = 0;
    for (const auto& band : study.distances) {
        auto insert = query("INSERT INTO distances VALUES (?, ?, ?, ?, ?)");
        insert << position++ << band.name << band.distance_m.low << band.distance_m.high << band.distractors;
        insert.run();
    }
    position = 0;
    const auto& words = study.words.texts().empty() ? studies::LanguageTable::english() : study.words;
    for (const auto& stage : study.stages) insertStage(stage, position++, words);
}

void Store::Impl::insertStage(const studies::Stage& stage, int position,
                              const studies::LanguageTable& words) {
    auto row = query("INSERT INTO stages VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
    row << position << stage.name << studies::stageKindName(stage.kind) << stage.session;
    row.textOrNull(stage.practice ? stage.practice->of : "").textOrNull(stage.measure);
    const studies::StageDeclaration& kind = studies::declarationOf(stage.kind);
    if (kind.showsClips() && kind.has("scale"))
        row << stage.scale.low << stage.scale.high;
    else
        row.null(2);
    row.textOrNull(stage.question);
    row.run();

    int place = 0;
    const auto questions =
        kind.questions != nullptr ? kind.questions(stage, words) : std::vector<studies::Question>{};
    for (const studies::Question& question : questions) {
        auto insert = query("INSERT INTO questions VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)");
        insert << stage.name << question.id << place++ << kindName(question.kind) << question.text;
        if (question.kind == studies::QuestionKind::scale)
            insert << question.scale.low << question.scale.high;
        else if (question.kind == studies::QuestionKind::number)
            insert << question.low << question.high;
        else
            insert.null(2);
        Json options = Json::array();
        for (const auto& option : question.options)
            options.push_back(Json{{"id", option.id}, {"text", option.text}});
        insert.textOrNull(options.empty() ? "" : options.dump());
        const auto& labels = question.scale.labels;
        insert.textOrNull(labels.empty() ? "" : Json(labels).dump());
        insert.run();
    }
    place = 0;
    for (const studies::Score& score : stage.questionnaire.scores) {
        auto insert = query("INSERT INTO scores VALUES (?, ?, ?, ?, ?, ?, ?, ?)");
        insert << stage.name << score.name << place++ << Json(score.items).dump()
               << Json(score.reversed).dump() << score.mean << score.factor << score.offset;
        insert.run();
    }
}

void Store::Impl::insertRegistration(const Registration& registration) {
    // The first session says when.
    auto row = query(
        "INSERT INTO participants (id, number, language, registered_utc_s, token) VALUES (?, ?, ?, 0.0, ?)");
    row << registration.participant << registration.number << registration.language << drawToken();
    row.run();
    for (const auto& [factor, level] : registration.groups) {
        auto group = query("INSERT INTO participant_groups VALUES (?, ?, ?)");
        group << registration.participant << factor << level;
        group.run();
    }
    for (auto* sizes : {&groups_taken, &groups_registered})
        if (*sizes) ++(**sizes)[registration.groups];
}

void Store::Impl::insertPlan(const studies::StudyPlan& plan, const std::string& json,
                             const std::string& locked_hash) {
    auto row = query("INSERT INTO plans (participant, seed, hash, json, locked_hash) VALUES (?, ?, ?, ?, ?)");
    row << plan.participant << std::to_string(plan.seed) << sha256Hex(json) << json;
    row.textOrNull(locked_hash);
    row.run();
    for (const auto& trial : plan.trials) insertTrial(plan.participant, trial);
}

void Store::Impl::insertTrial(const std::string& participant, const studies::Trial& trial) {
    auto row = query(
        "INSERT INTO trials (participant, trial_index, stage, kind, practice, attempt, page, layout, "
        "distance, visibility, angles, "
        "target_id, target_x_m, target_y_m, target_z_m, check_kind, "
        "check_stimulus, check_expected, check_of_trial) "
        "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    row << participant << trial.index << trial.stage << studies::stageKindName(trial.kind) << trial.practice
        << trial.attempt << trial.page;
    row.textOrNull(trial.layout).textOrNull(trial.distance).textOrNull(studies::visibilityJson(trial));
    row.textOrNull(studies::anglesJson(trial));
    if (trial.stimuli.empty())
        row.null(4);
    else
        row << trial.stimuli.front().item;
    if (!trial.stimuli.empty() && trial.target != Vec3(0.0))  // an item may have none
        row << trial.target;
    else if (!trial.stimuli.empty())
        row.null(3);
    if (trial.check) {
        using studies::CheckKind;
        const studies::TrialCheck& check = *trial.check;
        const bool number = check.kind == CheckKind::number;
        row << studies::checkKindName(check.kind);
        if (number)
            row << check.stimulus << check.expected;
        else
            row.null(2);
        if (check.kind == CheckKind::repeat) row << check.of_trial;
    }
    row.run();
    for (const studies::KeptValue& kept : studies::keptValues(trial)) {
        auto insert = query("INSERT INTO trial_values VALUES (?, ?, ?, ?, ?)");
        insert << participant << trial.index << kept.name << kept.value;
        if (!kept.value) insert << kept.text;
        insert.run();
    }
    for (std::size_t i = 0; i < trial.stimuli.size(); ++i) {
        auto stimulus = query("INSERT INTO trial_stimuli VALUES (?, ?, ?, ?, ?, ?, ?)");
        stimulus << participant << trial.index << i << trial.stimuli[i].system << trial.stimuli[i].item
                 << trial.scored(static_cast<int>(i)) << trial.stimuli[i].clip;
        stimulus.run();
    }
}

}  // namespace deixis::results
