// What a session tells its operator.
#include "app/session/operator_feed.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <vector>

using namespace deixis;
using namespace deixis::app;
using studies::Note;
using studies::StageProgress;

namespace {

// Counts what it is given.
struct Kept : Recorder {
    int events = 0, samples = 0, frames = 0;
    bool finished = false, on_disk = true;
    std::string why;
    void record(const studies::SessionEvent&) override { ++events; }
    void sample(const studies::TrackingSample&, int) override { ++samples; }
    [[nodiscard]] bool answersKept() const override { return on_disk; }
    [[nodiscard]] std::string failure() const override { return why; }
    void finish() override { finished = true; }
    void presented(const studies::InputFrame&, const studies::PresentedFrame&) override { ++frames; }
};

struct Fixture {
    studies::Study study{};
    studies::SessionProgress progress{};
    Kept kept{};
    std::shared_ptr<OperatorFeed> feed = std::make_shared<OperatorFeed>();
    std::filesystem::path database = std::filesystem::temp_directory_path() / "study.sqlite";
    OperatorFeedWriter writer{feed,     "P07", study, [this] { return progress; }, {{"rating", 10.0}},
                              database, kept};

    void frame(double time_s, bool answers_kept = true,
               studies::PresentedState state = studies::PresentedState::rating) {
        studies::InputFrame input;
        input.time_s = time_s;
        input.answers_kept = answers_kept;
        studies::PresentedFrame shown;
        shown.state = state;
        writer.presented(input, shown);
    }
};

}  // namespace

TEST_SUITE("operator/operator_feed") {
    TEST_CASE("everything goes on to the recorder that keeps it") {
        Fixture f;
        f.writer.record(Note{studies::NoteKind::pause, -1, {1.0, 1.0}, "menu"});
        f.writer.record(studies::Response{});
        f.writer.sample({}, 3);
        f.frame(1.0);
        f.writer.finish();
        CHECK(f.kept.events == 2);
        CHECK(f.kept.samples == 1);
        CHECK(f.kept.frames == 1);
        CHECK(f.kept.finished);
        CHECK(f.writer.answersKept());
        f.kept.on_disk = false;
        CHECK_FALSE(f.writer.answersKept());
    }

    TEST_CASE("elapsed time counts from the first frame, and the time left from the study's history") {
        Fixture f;
        f.progress.stages = {{"rating", 2, 8, true}};
        f.frame(1000.0);
        CHECK(f.feed->participant == "P07");
        CHECK(f.feed->elapsed_s == 0.0);
        REQUIRE(f.feed->left_s);
        CHECK(*f.feed->left_s == doctest::Approx(60.0));
        f.frame(1004.0);
        CHECK(f.feed->elapsed_s == doctest::Approx(4.0));
        CHECK(*f.feed->left_s == doctest::Approx(56.0));
    }

    TEST_CASE("how long answers wait for the disk is told until they are there") {
        Fixture f;
        f.frame(10.0);
        CHECK(f.feed->waiting_s == 0.0);
        f.frame(11.0, false);
        f.frame(13.5, false);
        CHECK(f.feed->waiting_s == doctest::Approx(2.5));
        f.frame(14.0);
        CHECK(f.feed->waiting_s == 0.0);
    }

    TEST_CASE("the free space is that of the database's disk, and unknown where there is no such folder") {
        Fixture f;
        f.frame(0.0);
        REQUIRE(f.feed->disk_free_bytes);
        const auto here = std::filesystem::space(std::filesystem::temp_directory_path());
        CHECK(*f.feed->disk_free_bytes <= here.capacity);
        OperatorFeedWriter nowhere(
            f.feed, "P07", f.study, [&] { return f.progress; }, {}, "/no such folder/study.sqlite", f.kept);
        nowhere.presented({}, {});
        CHECK_FALSE(f.feed->disk_free_bytes);
    }

    TEST_CASE("only the stages of the visit under way are shown") {
        Fixture f;
        for (const auto& [name, visit] : {std::pair{"first", 1}, {"second", 2}, {"third", 2}}) {
            studies::Stage stage;
            stage.name = name;
            stage.session = visit;
            f.study.stages.push_back(stage);
        }
        f.progress.stages = {{"first", 4, 4, false}, {"second", 1, 4, true}, {"third", 0, 4, false}};
        f.frame(0.0);
        REQUIRE(f.feed->progress.stages.size() == 2);
        CHECK(f.feed->progress.stages[0].name == "second");
        // Also when no stage is under way any more.
        for (StageProgress& stage : f.progress.stages) stage.current = false;
        f.frame(1.0);
        CHECK(f.feed->progress.stages.size() == 2);
    }

    TEST_CASE("what the operator did, pauses, checks and exclusions are told; what every trial has is not") {
        Fixture f;
        f.frame(100.0);
        for (const studies::NoteKind kind : {studies::NoteKind::stimulus_onset, studies::NoteKind::motion_end,
                                             studies::NoteKind::operator_note, studies::NoteKind::stage_start,
                                             studies::NoteKind::check_failed})
            f.writer.record(Note{kind, 3, {130.0, 0.0}, "detail"});
        f.writer.record(studies::Exclusion{"attention", {140.0, 0.0}});
        REQUIRE(f.feed->events.size() == 3);
        CHECK(f.feed->events[0].kind == studies::NoteKind::operator_note);
        CHECK(f.feed->events[0].detail == "detail");
        CHECK(f.feed->events[0].elapsed_s == doctest::Approx(30.0));
        CHECK(f.feed->events[1].kind == studies::NoteKind::check_failed);
        CHECK(f.feed->events[2].kind == studies::NoteKind::excluded);
        for (int i = 0; i < 100; ++i)
            f.writer.record(Note{studies::NoteKind::pause, -1, {200.0 + i, 0.0}, ""});
        CHECK(f.feed->events.size() == 20);
        CHECK(f.feed->events.back().elapsed_s == doctest::Approx(199.0));
    }

    TEST_CASE("that nothing more can be kept is told once, with the reason") {
        Fixture f;
        f.frame(1.0);
        f.kept.why = "a.sqlite: the disk is full";
        CHECK(f.writer.failure() == f.kept.why);
        for (const double time_s : {2.0, 3.0}) {
            studies::InputFrame input;
            input.time_s = time_s;
            input.recording_failed = true;
            f.writer.presented(input, {});
        }
        REQUIRE(f.feed->events.size() == 1);
        CHECK(f.feed->events[0].kind == studies::NoteKind::recording_failed);
        CHECK(f.feed->events[0].detail == f.kept.why);
        CHECK(f.feed->failure == f.kept.why);
        CHECK(f.feed->events[0].elapsed_s == doctest::Approx(1.0));
    }
}
