#include <doctest/doctest.h>

#include <array>

#include "core/csv_sheet.hpp"
#include "learning/corpus/corpus_statistics.hpp"

using namespace deixis;
using motion::GestureClass;
using motion::Hands;

namespace {

/// Ten seconds in which the right hand goes 30 cm up from frame 30 to 34, stays to frame 45, and comes down.
learning::CorpusTake smallTake() {
    learning::CorpusTake take;
    take.utterance.duration_s = 10.0;
    take.utterance.words = {{"Look", 1.0, 1.4}, {"up", 2.0, 2.4}, {"look", 5.0, 5.3}};
    take.utterance.accents = {{2.1, 2.3, 0.8, 1}};
    motion::UpperBodyJoints joints = motion::jointsOf(motion::relaxedUpperBody());
    auto& wrist = joints[static_cast<std::size_t>(motion::UpperJoint::right_wrist)];
    const auto& elbow = joints[static_cast<std::size_t>(motion::UpperJoint::right_elbow)];
    for (int f = 0; f < 150; ++f) {
        // By the forearm alone, so that lengths stay: from hanging to straight ahead.
        const double share = f < 30   ? 0.0
                             : f < 34 ? (f - 30) / 4.0
                             : f < 45 ? 1.0
                             : f < 49 ? (49 - f) / 4.0
                                      : 0.0;
        const double angle = share * 0.5 * pi;
        wrist = elbow + 0.33 * Vec3(0.0, -std::cos(angle), std::sin(angle));
        take.motion.frames.push_back(motion::poseFromJoints(joints));
    }
    motion::SpeechStroke stroke;
    stroke.gesture = "point_up";
    stroke.gesture_class = GestureClass::deictic;
    stroke.hands = Hands::right;
    stroke.begin_s = 1.8;
    stroke.stroke_s = 2.0;
    stroke.apex_s = 34.0 / 15.0;
    stroke.word = 1;
    stroke.accent = 0;
    take.strokes.push_back(stroke);
    stroke.accent.reset();
    stroke.gesture_class = GestureClass::beat;
    stroke.hands = Hands::both;
    stroke.stroke_s = 5.0;
    stroke.apex_s = 5.5;
    take.strokes.push_back(stroke);
    return take;
}

}  // namespace

TEST_SUITE("corpus/statistics") {
    TEST_CASE("A corpus worked out by hand") {
        learning::Corpus corpus;
        corpus.takes.push_back(smallTake());
        corpus.takes.push_back(smallTake());
        const auto found = learning::corpusStatistics(corpus);
        CHECK(found.takes == 2);
        CHECK(found.minutes == doctest::Approx(20.0 / 60.0));
        CHECK(found.words == 6);
        CHECK(found.word_forms == 2);
        CHECK(found.accents_per_minute == doctest::Approx(6.0));
        CHECK(found.strokes.strokes_per_minute == doctest::Approx(12.0));
        CHECK(found.strokes.with_accent == doctest::Approx(0.5));
        CHECK(found.both_hands == doctest::Approx(0.5));
        CHECK(found.stroke_s.mean == doctest::Approx(0.5 * (34.0 / 15.0 - 2.0 + 0.5)));
        CHECK(found.before_accent_s.count == 2);
        CHECK(found.before_accent_s.mean == doctest::Approx(0.1));
        // Held from frame 34 to 45, still until the way down; and after the beat to the end.
        CHECK(found.hold_s.count == 4);
        CHECK(found.hold_s.mean == doctest::Approx(0.5 * (11.0 / 15.0 + (149.0 - 83.0) / 15.0)));
        // A forearm that points ahead: the wrist is an upper arm below the shoulder.
        const auto& deictic = found.places[static_cast<std::size_t>(GestureClass::deictic)];
        CHECK(deictic.height_m.mean == doctest::Approx(-0.34).epsilon(0.06));
        CHECK(deictic.outward_m.mean > 0.15);
        // A quarter of a circle of 33 cm in 4 frames: each a chord of 22.5 degrees.
        CHECK(found.wrist_most_m_s ==
              doctest::Approx(15.0 * 2.0 * 0.33 * std::sin(pi / 16.0)).epsilon(0.001));
        CHECK(found.still == doctest::Approx((149.0 - 8.0) / 149.0));
    }

    TEST_CASE("The table has a row for each number, with what is published, in text and in CSV") {
        learning::Corpus made, recorded;
        made.takes.push_back(smallTake());
        recorded.takes.push_back(smallTake());
        recorded.takes[0].strokes.clear();
        const std::array columns{learning::StatisticsColumn{"rules, A", learning::corpusStatistics(made)},
                                 learning::StatisticsColumn{"a lab", learning::corpusStatistics(recorded)}};
        const auto rows = learning::statisticsTable(columns);
        const auto row = [&](std::string_view what) {
            for (const auto& one : rows)
                if (one.what == what) return one;
            FAIL(what);
            return rows.front();
        };
        CHECK(row("strokes a minute").found == std::vector<std::string>{"12.0", "-"});
        CHECK(row("strokes a minute").published == "67");
        CHECK(row("beat strokes").published == "44.7 %");
        CHECK(row("words").found == std::vector<std::string>{"3", "3"});
        const auto sheet = parseCsvSheet(learning::statisticsCsv(columns), "table");
        REQUIRE(sheet.has_value());
        CHECK(sheet->rows.size() == rows.size());
        CHECK(sheet->header.fields ==
              std::vector<std::string>{"what", "rules, A", "a lab", "published", "source"});
        const std::string text = learning::statisticsText(columns);
        CHECK(text.find("strokes with an accent") != std::string::npos);
        CHECK(text.find("Loehr 2004") != std::string::npos);
    }

    TEST_CASE("Nothing has no statistics") {
        const auto found = learning::corpusStatistics(learning::Corpus{});
        CHECK(found.takes == 0);
        CHECK(found.hold_s.count == 0);
        CHECK(found.still == 0.0);
    }
}
