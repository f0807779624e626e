#include "app/stations/simulated_sessions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <future>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "app/program/version.hpp"
#include "app/session/recorders.hpp"
#include "app/session/session_loop.hpp"
#include "app/stations/simulated_setup.hpp"
#include "core/parallel.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "studies/study_file/standing.hpp"

namespace deixis::app {

namespace {

/// Keeps in memory what happens, until it is this participant's turn to be written.
class RememberingRecorder : public Recorder {
  public:
    void record(const studies::SessionEvent& event) override { events_.push_back(event); }
    void sample(const studies::TrackingSample&, int) override {}
    [[nodiscard]] bool answersKept() const override { return true; }
    [[nodiscard]] std::vector<studies::SessionEvent> taken() { return std::move(events_); }

  private:
    std::vector<studies::SessionEvent> events_;
};

struct Session {
    studies::StationInfo station;
    std::vector<studies::SessionEvent> events;
    studies::SessionOutcome outcome = studies::SessionOutcome::running;
    double ended_utc_s = 0.0;
    std::optional<Error> failure;
};

struct Participant {
    const studies::StudyPlan* plan = nullptr;
    double now_utc_s = 0.0;
    std::optional<std::size_t> answered_before;  ///< when the last session began
    studies::Resume resume;
    Session session;
};

class Sessions {
  public:
    Sessions(const StudySetup& setup, const assets::Avatar& avatar, const StimulusLibrary& stimuli,
             const studies::SimulatedParameters& parameters, results::Store& store)
        : study_(setup.study),
          stood_(studies::standingAs(setup.study, studies::Standing::desktop)),
          avatar_(avatar),
          idle_(motion::relaxedPose(avatar.skeleton)),
          stimuli_(stimuli),
          records_(stimuli.records()),
          parameters_(parameters),
          store_(store) {}

    /// The next session of those who have trials left. Returns who may have another. While some take part,
    /// what happened in the sessions before theirs is written.
    Result<std::vector<Participant>> round(const std::vector<Participant>& waiting) {
        std::vector<Participant> again;
        std::vector<Participant> played;
        for (std::size_t first = 0; first < waiting.size(); first += at_once) {
            auto next =
                withTrialsLeft(std::span(waiting).subspan(first, std::min(at_once, waiting.size() - first)));
            if (!next) return tl::unexpected(next.error());
            auto playing = std::async(std::launch::async, [&] { takePart(*next); });
            if (auto kept = keep(played, again); !kept) return tl::unexpected(kept.error());
            playing.get();
            played = std::move(*next);
        }
        if (auto kept = keep(played, again); !kept) return tl::unexpected(kept.error());
        return again;
    }
    [[nodiscard]] int answered() const { return answered_; }

  private:
    static constexpr std::size_t at_once = 64;  // what happened in twice so many sessions is held in memory

    [[nodiscard]] std::string where(const Participant& one) const {
        return fmt::format("study '{}': {}", study_.name, one.plan->participant);
    }

    Result<std::vector<Participant>> withTrialsLeft(std::span<const Participant> waiting) {
        std::vector<Participant> out;
        for (const Participant& one : waiting) {
            studies::Resume resume = store_.resume(one.plan->participant, one.now_utc_s);
            if (studies::trialsLeft(study_, *one.plan, resume.answered).empty()) continue;
            if (one.answered_before == resume.answered.size())
                return fail(where(one), "a session ended without an answer, and trials are left");
            const std::size_t answered = resume.answered.size();
            out.push_back({one.plan, one.now_utc_s, answered, std::move(resume), {}});
        }
        return out;
    }

    void takePart(std::vector<Participant>& some) const {
        forRanges(some.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) takePart(some[i]);
        });
    }

    void takePart(Participant& one) const {
        studies::SimulatedStation station(parameters_, avatar_.skeleton, simulatedSeed(*one.plan));
        Session& session = one.session;
        session.station = withProgram(station.info());
        studies::SessionRunner runner(stood_, *one.plan, stimuli_, avatar_.skeleton, idle_, one.resume, true);
        RememberingRecorder recorder;
        session.ended_utc_s = runSession(runner, station, recorder).utc_s;
        session.events = recorder.taken();
        session.outcome = runner.outcome();
        session.failure = station.failure();
    }

    Result<void> keep(std::vector<Participant>& played, std::vector<Participant>& again) {
        for (Participant& one : played) {
            if (auto kept = keep(one); !kept) return kept;
            if (one.session.outcome == studies::SessionOutcome::finished) again.push_back(std::move(one));
        }
        return {};
    }

    Result<void> keep(Participant& one) {
        const Session& session = one.session;
        store_.beginSession(
            {one.plan->participant, session.station, programVersion(), avatar_.content_hash, one.now_utc_s});
        DirectRecorder recorder(store_, study_, *one.plan, records_);
        for (const studies::SessionEvent& event : session.events) recorder.record(event);
        answered_ += recorder.answered();
        store_.endSession(session.outcome, session.ended_utc_s);
        if (session.failure) return fail(where(one), session.failure->message, session.failure->hint);
        one.now_utc_s = session.ended_utc_s;
        one.session.events.clear();
        return {};
    }

    const studies::Study& study_;
    const studies::Study stood_;
    const assets::Avatar& avatar_;
    const motion::LocalPose idle_;
    const StimulusLibrary& stimuli_;
    const results::ClipRecords records_;
    const studies::SimulatedParameters& parameters_;
    results::Store& store_;
    int answered_ = 0;
};

}  // namespace

Result<int> simulateSessions(const StudySetup& setup, const std::vector<studies::StudyPlan>& plans,
                             const assets::Avatar& avatar, const StimulusLibrary& stimuli,
                             const studies::SimulatedParameters& parameters, results::Store& store) {
    Sessions sessions(setup, avatar, stimuli, parameters, store);
    std::vector<Participant> waiting;
    for (const studies::StudyPlan& plan : plans) waiting.push_back({&plan, 0.0, {}, {}, {}});
    while (!waiting.empty()) {
        auto again = sessions.round(waiting);
        if (!again) return tl::unexpected(again.error());
        waiting = std::move(*again);
    }
    return sessions.answered();
}

}  // namespace deixis::app
