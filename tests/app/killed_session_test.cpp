// A session that is killed again and again, wherever it happens to be.
#include <sys/wait.h>
#include <unistd.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <csignal>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "app/session/recorders.hpp"
#include "app/stations/simulated_setup.hpp"
#include "app/study/enrolment.hpp"
#include "app/study/locked_study.hpp"
#include "app/study/stimuli.hpp"
#include "assets/data/data_paths.hpp"
#include "core/random.hpp"
#include "motion/humanoid/reference_humanoid.hpp"
#include "program.hpp"
#include "studies/simulation/simulated_participant.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

constexpr int kills = 200;

/// Ends the process, as a kill does, as soon as a clip of a trial has begun and that is kept.
class DiesWithinTrial : public app::DirectRecorder {
  public:
    using DirectRecorder::DirectRecorder;
    void record(const studies::SessionEvent& event) override {
        DirectRecorder::record(event);
        const auto* note = std::get_if<studies::Note>(&event);
        if (note != nullptr && note->kind == studies::NoteKind::stimulus_onset) ::raise(SIGKILL);
    }
};

/// What a run of the program does between its start and its end, with a simulated participant.
class Life {
  public:
    explicit Life(std::string database)
        : database_(std::move(database)),
          setup_(app::loadStudySetup("pointing2023-stand-ins")),
          avatar_(app::loadShippedAvatar()),
          parameters_(studies::loadSimulatedParameters(assets::dataFile("simulated_participant.toml"))) {
        REQUIRE(setup_);
        REQUIRE(avatar_);
        REQUIRE(parameters_);
        // Every clip once, so that a life need not read them.
        auto store = results::Store::open(database_, results::Durability::each_answer);
        REQUIRE(store);
        std::vector<studies::StudyPlan> plans;
        for (int number = 1; number <= max_participants; ++number) {
            auto plan =
                studies::buildPlan(setup_->study, setup_->targets, fmt::format("P{:02}", number), number, {});
            REQUIRE(plan);
            plans.push_back(std::move(*plan));
        }
        const auto hash = app::lockStudy(*setup_, {database_, sharedStimuli(), {}, {}, false});
        REQUIRE(hash);
        const auto locked = app::openLocked(database_, *hash);
        REQUIRE(locked);
        stimuli_ = std::make_unique<Result<app::StimulusLibrary>>(
            app::StimulusLibrary::load(*locked, plans, *avatar_));
        REQUIRE(*stimuli_);
    }

    static constexpr int max_participants = 12;

    /// Whether the participant's session is over.
    template <class Recorder = app::DirectRecorder>
    bool run(const std::string& participant) const {
        auto store = results::Store::open(database_, results::Durability::each_answer);
        if (!store) return false;
        const auto enrolment = app::enrol(*setup_, *store, participant, {}, 2e9);
        if (!enrolment) return false;
        if (enrolment->left.empty()) return true;
        if (!store->storePlan(setup_->study, enrolment->registration, enrolment->plan)) return false;
        studies::SimulatedStation station(*parameters_, avatar_->skeleton,
                                          app::simulatedSeed(enrolment->plan));
        const motion::LocalPose idle = motion::relaxedPose(avatar_->skeleton);
        studies::SessionRunner session(setup_->study, enrolment->plan, **stimuli_, avatar_->skeleton, idle,
                                       enrolment->resume, true);
        store->beginSession({participant, station.info(), "test", avatar_->content_hash, 2e9});
        const auto records = (*stimuli_)->records();
        Recorder recorder(*store, setup_->study, enrolment->plan, records);
        const studies::Moment end = app::runSession(session, station, recorder);
        store->endSession(session.outcome(), end.utc_s);
        return true;
    }

  private:
    std::string database_;
    Result<app::StudySetup> setup_;
    Result<assets::Avatar> avatar_;
    Result<studies::SimulatedParameters> parameters_;
    std::unique_ptr<Result<app::StimulusLibrary>> stimuli_;
};

int answersIn(const std::string& database) {
    SQLite::Database kept(database, SQLite::OPEN_READONLY, 5000);
    return kept.execAndGet("SELECT count(*) FROM responses").getInt();
}

}  // namespace

TEST_SUITE("app/killed_session") {
    TEST_CASE(
        "Sessions of 60 trials killed at 200 random moments end with 60 answers each: none lost, none "
        "doubled") {
        const Scratch scratch;
        const std::string database = scratch / "study.sqlite";
        const Life life(database);
        Random random(20211, "moments");
        int killed = 0, finished = 0, participants = 0;
        // Short enough that a session takes many lives, and long enough that every third gets to an answer,
        // however fast the machine is.
        double longest_s = 0.02;
        int answers = 0;
        while (killed < kills && participants < Life::max_participants) {
            const std::string participant = fmt::format("P{:02}", ++participants);
            for (bool over = false; !over;) {
                const pid_t child = ::fork();
                REQUIRE(child >= 0);
                if (child == 0) ::_exit(life.run(participant) ? 0 : 1);
                bool struck = false;
                if (killed < kills) {
                    ::usleep(static_cast<useconds_t>(1e6 * random.uniform(0.0, longest_s)));
                    struck = ::kill(child, SIGKILL) == 0;
                }
                int status = 0;
                REQUIRE(::waitpid(child, &status, 0) == child);
                if (struck && WIFSIGNALED(status)) {
                    ++killed;
                    const int before = std::exchange(answers, answersIn(database));
                    longest_s *= answers > before ? 0.9 : 1.05;
                    continue;
                }
                REQUIRE(WIFEXITED(status));
                REQUIRE(WEXITSTATUS(status) == 0);
                over = true;
                ++finished;
            }
        }
        MESSAGE(fmt::format("{} kills over {} sessions", killed, finished));
        CHECK(killed == kills);

        SQLite::Database kept(database, SQLite::OPEN_READONLY);
        CHECK(kept.execAndGet("PRAGMA integrity_check").getString() == "ok");
        CHECK(kept.execAndGet("SELECT count(*) FROM pragma_foreign_key_check").getInt() == 0);
        SQLite::Statement counts(
            kept,
            "SELECT t.participant, sum(NOT t.practice AND s.participant IS NOT NULL), count(r.id), "
            "count(*) FROM trials AS t LEFT JOIN trial_stimuli AS s ON s.participant = "
            "t.participant AND s.trial_index = t.trial_index LEFT JOIN responses AS r ON "
            "r.participant = t.participant AND r.trial_index = t.trial_index GROUP BY 1");
        int seen = 0;
        while (counts.executeStep()) {
            CAPTURE(counts.getColumn(0).getString());
            CHECK(counts.getColumn(1).getInt() == 60);
            CHECK(counts.getColumn(2).getInt() == counts.getColumn(3).getInt());  // each unit answered once
            ++seen;
        }
        CHECK(seen == participants);
        CHECK(kept.execAndGet("SELECT count(*) FROM responses WHERE superseded IS NOT NULL").getInt() == 0);
    }

    TEST_CASE("Whoever is cut off within a trial begins it again, and its answer says so") {
        const Scratch scratch;
        const std::string database = scratch / "study.sqlite";
        const Life life(database);
        constexpr int deaths = 3;
        for (int death = 0; death < deaths; ++death) {
            const pid_t child = ::fork();
            REQUIRE(child >= 0);
            if (child == 0) ::_exit(life.run<DiesWithinTrial>("P01") ? 0 : 1);
            int status = 0;
            REQUIRE(::waitpid(child, &status, 0) == child);
            REQUIRE(WIFSIGNALED(status));
        }
        REQUIRE(life.run("P01"));
        SQLite::Database kept(database, SQLite::OPEN_READONLY);
        // Each died in the first trial that shows a clip.
        SQLite::Statement begun(kept, "SELECT trial_index FROM responses WHERE begun_before");
        REQUIRE(begun.executeStep());
        const int first = kept.execAndGet("SELECT min(trial_index) FROM trial_stimuli").getInt();
        CHECK(begun.getColumn(0).getInt() == first);
        CHECK(!begun.executeStep());
        CHECK(kept.execAndGet("SELECT count(*) FROM events WHERE kind = 'stimulus_onset' AND trial_index = " +
                              std::to_string(first))
                  .getInt() == deaths + 1);
        CHECK(answersIn(database) == kept.execAndGet("SELECT count(*) FROM trials").getInt());
    }
}
