// Whole studies with a simulated participant, from the study file to the answers.
#pragma once

#include <doctest/doctest.h>
#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/files.hpp"
#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "motion/synthesis/generator.hpp"
#include "paths.hpp"
#include "studies/session/session.hpp"
#include "studies/simulation/simulated_participant.hpp"
#include "studies/study_file/standing.hpp"

namespace deixis::tests {

using namespace deixis::studies;

inline const std::filesystem::path source_tree = sourceDir();
inline const StudyFolders source_folders{source_tree / "assets/data/languages",
                                         source_tree / "assets/data/questionnaires"};

inline Study loadedStudy(const std::filesystem::path& file) {
    auto study = loadStudy(file, source_folders);
    std::string problems;
    if (!study)
        for (const Error& error : study.error()) problems += error.text() + "\n";
    REQUIRE_MESSAGE(study.has_value(), problems);
    return std::move(*study);
}

inline Study written(const std::string& text) {
    const auto path = std::filesystem::temp_directory_path() / "deixis_simulated_study.toml";
    REQUIRE(writeFile(path, text).has_value());
    return loadedStudy(path);
}

/// Clips of the study's built-in systems for its targets, made when asked for.
class GeneratedClips : public ClipSource {
  public:
    GeneratedClips(const Study& study, const std::vector<TargetItem>& targets) : study_(study) {
        for (const TargetItem& item : targets) targets_[item.id] = item.target;
    }
    [[nodiscard]] const motion::Clip& clip(const Stimulus& stimulus) const override {
        const auto found = clips_.find(stimulus);
        if (found != clips_.end()) return found->second;
        const SystemSource& system = *study_.findSystem(stimulus.system);
        auto& generator = generators_[system.generator];
        if (!generator) {
            auto made = motion::makeGenerator(system.generator, motion::referenceHumanoid(), {});
            REQUIRE(made.has_value());
            generator = std::move(*made);
        }
        const motion::GenerationRequest request{stimulus.item,
                                                targets_.at(stimulus.item),
                                                deriveSeed(1, stimulus.item),
                                                {system.hold_s, system.unsteadiness_m}};
        return clips_.emplace(stimulus, generator->generate(request).clip).first->second;
    }

  private:
    const Study& study_;
    std::map<std::string, Vec3> targets_;
    mutable std::map<std::string, std::unique_ptr<motion::Generator>> generators_;
    mutable std::map<Stimulus, motion::Clip> clips_;
};

/// A study with its plan and clips.
struct Prepared {
    explicit Prepared(Study made, int number = 1)
        : study(std::move(made)),
          stood(standingAs(study, Standing::desktop)),
          targets(sampled(study)),
          plan(planned(study, targets, number)),
          clips(study, targets) {}

    Study study;
    Study stood;  ///< as simulated participants meet it
    std::vector<TargetItem> targets;
    StudyPlan plan;
    GeneratedClips clips;
    const motion::Skeleton& avatar = motion::referenceHumanoid();
    motion::LocalPose idle = motion::relaxedPose(avatar);

    static std::vector<TargetItem> sampled(const Study& study) {
        auto targets = sampleTargets(study);
        REQUIRE_MESSAGE(targets.has_value(), (targets ? "" : targets.error().text()));
        return std::move(*targets);
    }
    static StudyPlan planned(const Study& study, const std::vector<TargetItem>& targets, int number) {
        auto plan =
            buildPlan(study, targets, fmt::format("P{:02}", number), number, assignGroups(study, {}, number));
        REQUIRE_MESSAGE(plan.has_value(), (plan ? "" : plan.error().text()));
        return std::move(*plan);
    }
};

/// What came of one participant.
struct Outcome {
    SessionOutcome session = SessionOutcome::running;
    std::vector<Response> responses;
    std::vector<Note> notes;
    int frames = 0;
    int presses = 0;
    int not_looked_at = 0;  ///< presses on what lay more than 15 degrees off the looking direction

    [[nodiscard]] int count(NoteKind kind) const {
        return static_cast<int>(std::count_if(notes.begin(), notes.end(),
                                              [kind](const Note& note) { return note.kind == kind; }));
    }
};

/// One session. `disturb` may change what the station tells, such as a pause.
inline void sit(const Prepared& prepared, const StudyPlan& plan, SimulatedStation& station, bool keyboard,
                Resume resume, Outcome& outcome, const std::function<void(InputFrame&)>& disturb = {}) {
    SessionRunner session(prepared.stood, plan, prepared.clips, prepared.avatar, prepared.idle,
                          std::move(resume), keyboard);
    std::optional<RayView> shown_ray;
    const auto keep = [&outcome](std::vector<SessionEvent> events) {
        for (SessionEvent& event : events) {
            if (auto* response = std::get_if<Response>(&event)) outcome.responses.push_back(*response);
            if (auto* note = std::get_if<Note>(&event)) outcome.notes.push_back(*note);
        }
    };
    for (int i = 0; i < 500000 && session.outcome() == SessionOutcome::running; ++i) {
        InputFrame input = station.beginFrame();
        if (disturb) disturb(input);
        if (input.select) {
            ++outcome.presses;
            REQUIRE(shown_ray.has_value());
            const Vec3 met = shown_ray->ray.origin + shown_ray->length_m * shown_ray->ray.direction;
            const Vec3 looking = input.stage_from_head.orientation * Vec3(0.0, 0.0, -1.0);
            const double off_rad = angleBetween(looking, met - input.stage_from_head.position);
            if (off_rad > radiansFromDegrees(15.0)) ++outcome.not_looked_at;
        }
        const SessionStep step = session.step(input);
        keep(step.events);
        shown_ray = step.frame.ray;
        keep(session.shown(station.present(step.frame)));
        ++outcome.frames;
    }
    outcome.session = session.outcome();
}

/// All sessions, one after the other.
inline Outcome simulate(const Prepared& prepared, const StudyPlan& plan, std::uint64_t seed,
                        const SimulatedParameters& parameters = {}, bool keyboard = true) {
    SimulatedStation station(parameters, prepared.avatar, seed, keyboard);
    Outcome outcome;
    Resume resume;
    for (int visit = 0; visit < 5; ++visit) {
        sit(prepared, plan, station, keyboard, resume, outcome);
        for (const Response& response : outcome.responses)
            resume.answered[response.trial_index] = response.correct() || response.chosenPlace() < 0;
        if (outcome.session != SessionOutcome::finished ||
            trialsLeft(prepared.study, plan, resume.answered).empty())
            break;
    }
    return outcome;
}

inline Outcome simulate(const Prepared& prepared, std::uint64_t seed,
                        const SimulatedParameters& parameters = {}, bool keyboard = true) {
    return simulate(prepared, prepared.plan, seed, parameters, keyboard);
}

/// Every trial that is to be done has one answer, and nothing went wrong on the way.
inline void checkWhole(const Prepared& prepared, const Outcome& outcome) {
    CHECK(outcome.session == SessionOutcome::finished);
    std::map<int, bool> answered;
    for (const Response& response : outcome.responses) {
        CHECK(response.status == ResponseStatus::answered);
        CHECK(answered.count(response.trial_index) == 0);
        const Trial& trial = prepared.plan.trials.at(static_cast<std::size_t>(response.trial_index));
        answered[response.trial_index] = response.correct() || trial.kind != StageKind::game;
        // Without a keyboard a page of texts alone asks nothing.
        const bool asked = trial.kind != StageKind::questionnaire || !response.answers.empty();
        CHECK((response.response_time_s > 0.2) == asked);
    }
    CHECK(trialsLeft(prepared.study, prepared.plan, answered).empty());
    for (const NoteKind kind : {NoteKind::early_select, NoteKind::pointer_lost, NoteKind::off_place,
                                NoteKind::pause, NoteKind::replay}) {
        CAPTURE(noteKindName(kind));
        CHECK(outcome.count(kind) == 0);
    }
    CHECK(outcome.not_looked_at == 0);
}

inline Study everyKind() {
    return loadedStudy(source_tree / "tests/studies/fixtures/simulated_every_kind.toml");
}

}  // namespace deixis::tests
