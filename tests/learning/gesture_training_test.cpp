// Trainings of small models on speakers who raise their hands as loud as they are.
#include "gesture_trainer.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/files.hpp"
#include "learning/gesture_scores/evaluation.hpp"
#include "learning/gestures/training.hpp"
#include "motion/upper_body/upper_body_style.hpp"
#include "small_trainings.hpp"
#include "toy_speakers.hpp"

using namespace deixis;
using namespace deixis::learning;
using motion::SpeechGestureModel;
using motion::SpeechGestureRequest;
using tests::toySettings;
using tests::toyTakes;
using tests::TrainingFolder;

namespace {

const GestureTakes& shortTakes() {
    static const GestureTakes takes = toyTakes(4, 2, 8.0);
    return takes;
}

motion::Style meanStyle(const motion::UpperBodyMotion& motion) {
    const auto styles = motion::styleOf(motion).value();
    return motion::styleNorm({styles}).mean;
}

SpeechGestureRequest requestOf(const GestureTake& take) {
    SpeechGestureRequest out;
    out.samples = take.samples;
    out.utterance = take.utterance;
    out.duration_s = take.utterance.duration_s;
    return out;
}

struct Toy {
    GestureTakes takes = toyTakes(24, 4, 12.0);
    std::vector<double> huber;  ///< of each report
    std::vector<GestureEpoch> curve;
    GestureOutcome outcome;
    motion::NetworkWeights weights;
    SpeechGestureModel model;
};

const Toy& trainedToy() {
    static const Toy out = [] {
        const TrainingFolder folder;
        Toy toy;
        toy.outcome = trainGestures(toy.takes, toySettings(25), {"9.9", "abc"}, folder.path / "toy",
                                    {[&](const TrainingProgress& progress) {
                                         toy.huber.push_back(progress.numbers.at(1).second);
                                         return true;
                                     },
                                     [&](const GestureEpoch& epoch) { toy.curve.push_back(epoch); }})
                          .value();
        toy.weights = motion::readWeights(folder.path / "toy", motion::speech_gestures_architecture).value();
        toy.model = SpeechGestureModel::read(toy.weights).value();
        return toy;
    }();
    return out;
}

/// Of both forearms, summed.
double heightAt(const motion::UpperBodyMotion& motion, std::size_t f) {
    return motion.frames[f][motion::UpperBone::right_forearm].y +
           motion.frames[f][motion::UpperBone::left_forearm].y;
}
double meanHeight(const motion::UpperBodyMotion& motion, std::size_t first, std::size_t last) {
    double sum = 0.0;
    for (std::size_t f = first; f < last; ++f) sum += heightAt(motion, f);
    return sum / static_cast<double>(last - first);
}
/// Pearson's, of the heights.
double correlation(const motion::UpperBodyMotion& a, const motion::UpperBodyMotion& b, std::size_t first,
                   std::size_t last) {
    const double mean_a = meanHeight(a, first, last), mean_b = meanHeight(b, first, last);
    double ab = 0.0, aa = 0.0, bb = 0.0;
    for (std::size_t f = first; f < last; ++f) {
        const double of_a = heightAt(a, f) - mean_a, of_b = heightAt(b, f) - mean_b;
        ab += of_a * of_b;
        aa += of_a * of_a;
        bb += of_b * of_b;
    }
    return ab / std::sqrt(aa * bb);
}

}  // namespace

TEST_SUITE("learning/gesture_training") {
    TEST_CASE("the loss falls, and scores get better than those of the mean pose") {
        const Toy& toy = trainedToy();
        CHECK(toy.huber.back() < 0.5 * toy.huber.front());
        CHECK(toy.curve.size() == 25);
        CHECK(toy.curve.back().epoch == 25);
        CHECK(toy.curve.at(static_cast<std::size_t>(toy.outcome.best_epoch - 1)).best);
        CHECK(toy.curve.back().mean_pose.pcs == toy.outcome.mean_pose.pcs);
        const GestureScores &best = toy.outcome.best, &still = toy.outcome.mean_pose;
        CHECK(best.pcs < 0.6 * still.pcs);
        CHECK(best.scs < 0.7 * still.scs);
        CHECK(best.fgd_no_controls < 0.5 * still.fgd_no_controls);
        CHECK(toy.weights.commit == "abc");
        CHECK(toy.weights.training_data_sha256 == "toy");
        CHECK(toy.weights.metrics.at("validation_pcs") == best.pcs);
        CHECK(toy.model.words().knows("Well,"));
    }

    TEST_CASE("hands rise with the loudness of an unheard speaker, for two minutes, without seams") {
        const GestureTake speaker = tests::toyTake(2000, 120.0);
        const auto made = trainedToy().model.generate(requestOf(speaker)).value();
        REQUIRE(made.frames.size() == 1800);
        CHECK(correlation(made, speaker.motion, 0, 450) > 0.8);
        CHECK(correlation(made, speaker.motion, 1350, 1800) > 0.8);
        CHECK(std::abs(meanHeight(made, 0, 450) - meanHeight(made, 1350, 1800)) < 0.15);
        // Where windows meet, and where one has taken over, it is no rougher than in between.
        double at_seams = 0.0, elsewhere = 0.0;
        int seams = 0, others = 0;
        for (std::size_t f = 60; f + 1 < made.frames.size(); ++f) {
            const Vec3 bend = made.frames[f + 1][motion::UpperBone::left_forearm] -
                              2.0 * made.frames[f][motion::UpperBone::left_forearm] +
                              made.frames[f - 1][motion::UpperBone::left_forearm];
            const bool seam = f % 30 <= 1 || f % 30 == 29;
            (seam ? at_seams : elsewhere) += glm::length(bend);
            ++(seam ? seams : others);
        }
        MESSAGE("at seams ", at_seams / seams, ", elsewhere ", elsewhere / others, "; correlations ",
                correlation(made, speaker.motion, 0, 450), " ",
                correlation(made, speaker.motion, 1350, 1800));
        CHECK(at_seams / seams < 1.5 * elsewhere / others);
    }

    TEST_CASE("style goes where it should, and poses are met more nearly, and exactly where they shall be") {
        const GestureTake& held_out = trainedToy().takes.validation.front();
        const SpeechGestureModel& model = trainedToy().model;
        SpeechGestureRequest request = requestOf(held_out);
        const auto plain = model.generate(request).value();
        const auto styled = [&](const motion::StyleControl& style) {
            request.styles.assign(plain.frames.size(), style);
            return meanStyle(model.generate(request).value());
        };
        CHECK(styled({.speed = 1.5}).speed > 1.3 * styled({.speed = -1.5}).speed);
        CHECK(styled({.space = 1.5}).space > styled({.space = -1.5}).space + 0.05);
        CHECK(styled({.handedness = 1.5}).handedness > styled({.handedness = -1.5}).handedness + 0.3);

        request = requestOf(held_out);
        const std::size_t at = 100;
        motion::UpperBodyPose pose;
        motion::UpperBodyMotion posed;
        double with = 0.0, without = 0.0;
        for (std::size_t k = 0; k < 8; ++k) {
            // Of others, at any loudness.
            pose = trainedToy().takes.training[k].motion.frames[30 + 13 * k];
            request.poses = {{static_cast<int>(at), pose}};
            posed = model.generate(request).value();
            for (const auto bone : {motion::UpperBone::left_forearm, motion::UpperBone::right_forearm}) {
                with += angleBetween(posed.frames[at][bone], pose[bone]);
                without += angleBetween(plain.frames[at][bone], pose[bone]);
            }
        }
        MESSAGE("off by ", without / 16, " without, ", with / 16, " with the control");
        CHECK(with < 0.8 * without);
        request.exact = true;
        const auto exact = model.generate(request).value();
        CHECK(exact.frames[at] == pose);
        CHECK(std::equal(exact.frames.begin(), exact.frames.begin() + 69, posed.frames.begin()));
    }

    TEST_CASE("an evaluation of whole speeches, as the studio makes them") {
        const Toy& toy = trainedToy();
        const auto encoder = MotionEncoder::read(toy.weights).value();
        const auto found = evaluateGestures(toy.model, encoder, toy.takes.validation).value();
        const auto still = evaluateMeanPose(toy.model, encoder, toy.takes.validation).value();
        CHECK(found.parts == 4 * 6);  // of 12 s
        CHECK(found.scores.pcs < 0.6 * still.scores.pcs);
        CHECK(found.scores.scs < 0.8 * still.scores.scs);
        CHECK(found.scores.fgd_no_controls < 0.5 * still.scores.fgd_no_controls);
        CHECK(found.posed_off_deg > 0.0);
        CHECK(found.exact_off_deg < 0.01);
        // By hand: what the model does at the posed frames of one take.
        const std::vector<GestureTake> one{toy.takes.validation[1]};
        SpeechGestureRequest request = requestOf(one[0]);
        for (int f = 0; f < 180; ++f)
            if (f % 30 >= 10 && f % 30 < 15)
                request.poses.push_back({f, one[0].motion.frames[static_cast<std::size_t>(f)]});
        const auto made = toy.model.generate(request).value();
        double sum = 0.0, angles = 0.0;
        for (const motion::PoseControl& pose : request.poses) {
            const auto& frame = made.frames[static_cast<std::size_t>(pose.frame)];
            for (std::size_t n = 0; n < 27; ++n)
                sum += std::abs(motion::numbersOf(frame)[n] - motion::numbersOf(pose.pose)[n]) / 27.0;
            for (std::size_t b = 0; b < 9; ++b)
                angles +=
                    degreesFromRadians(angleBetween(frame.directions[b], pose.pose.directions[b])) / 9.0;
        }
        const auto of_one = evaluateGestures(toy.model, encoder, one).value();
        CHECK(of_one.scores.pcs == doctest::Approx(sum / 30.0));
        CHECK(of_one.posed_off_deg == doctest::Approx(angles / 30.0).epsilon(1e-4));
    }

    TEST_CASE("a recording evaluated against itself is perfect, and takes that are no pair are refused") {
        const Toy& toy = trainedToy();
        const auto encoder = MotionEncoder::read(toy.weights).value();
        std::vector<GestureTake> still = toy.takes.validation;
        for (GestureTake& take : still)
            for (auto& pose : take.motion.frames) pose = toy.model.meanPose();
        const auto found = evaluateMeanPose(toy.model, encoder, still).value();
        CHECK(found.scores.pcs == 0.0);
        CHECK(found.scores.scs == 0.0);
        CHECK(found.posed_off_deg == 0.0);
        CHECK(found.scores.fgd_no_controls == doctest::Approx(0.0));
        still[0].motion.frames.pop_back();
        const auto refused = evaluateGestures(toy.model, encoder, still);
        REQUIRE_FALSE(refused.has_value());
        CHECK(refused.error().message.find("found 179 frames of motion, expected 180") != std::string::npos);
        CHECK_FALSE(evaluateGestures(toy.model, encoder, {}).has_value());
    }

    TEST_CASE("stopped and gone on with it ends as if it had never been stopped") {
        const TrainingFolder folder;
        const auto whole = folder.path / "whole", parts = folder.path / "parts";
        using Line = std::vector<double>;  // what an epoch gave
        std::vector<Line> whole_curve, parts_curve;
        const auto lineOf = [](const GestureEpoch& one) {
            return Line{double(one.epoch), one.losses.huber, one.scores.pcs, one.scores.scs,
                        one.scores.fgd_style_controls};
        };
        REQUIRE(
            trainGestures(shortTakes(), toySettings(4), {}, whole,
                          {tests::goOn, [&](const GestureEpoch& one) { whole_curve.push_back(lineOf(one)); }})
                .has_value());
        const GestureCallbacks stopping{[](const TrainingProgress& progress) { return progress.done < 0.5; },
                                        [&](const GestureEpoch& one) { parts_curve.push_back(lineOf(one)); }};
        const auto first = trainGestures(shortTakes(), toySettings(4), {}, parts, stopping);
        REQUIRE(first.has_value());
        CHECK(first->stopped);
        CHECK(SpeechGestureModel::load(parts).has_value());
        const auto second = trainGestures(
            shortTakes(), toySettings(4), {}, parts,
            {tests::goOn, [&](const GestureEpoch& one) { parts_curve.push_back(lineOf(one)); }});
        REQUIRE(second.has_value());
        CHECK_FALSE(second->stopped);
        CHECK(parts_curve == whole_curve);
        CHECK(readFile(parts).value() == readFile(whole).value());
    }

    TEST_CASE("stopped before its first trial it leaves a file to use, and a state of these settings alone") {
        const TrainingFolder folder;
        const auto file = folder.path / "w";
        GestureSettings settings = toySettings(40);
        settings.validate_every = 30;
        const auto outcome = trainGestures(shortTakes(), settings, {}, file,
                                           {[](const TrainingProgress&) { return false; }, {}});
        REQUIRE(outcome.has_value());
        CHECK(outcome->updates == 10);
        CHECK(SpeechGestureModel::load(file).has_value());
        GestureSettings others = settings;
        others.style_weight = 0.06;
        const auto rejected = trainGestures(shortTakes(), others, {}, file, {});
        REQUIRE_FALSE(rejected.has_value());
        CHECK(rejected.error().text().find("other settings") != std::string::npos);
        REQUIRE(writeFile(file.string() + ".training", "nonsense").has_value());
        const auto damaged = trainGestures(shortTakes(), settings, {}, file, {});
        REQUIRE_FALSE(damaged.has_value());
        CHECK(damaged.error().text().find("damaged") != std::string::npos);
    }

    TEST_CASE("a training that diverges is stopped by name") {
        const TrainingFolder folder;
        GestureSettings settings = toySettings(4);
        settings.learning_rate = 1e30;
        const auto outcome = trainGestures(shortTakes(), settings, {}, folder.path / "w", {});
        REQUIRE_FALSE(outcome.has_value());
        CHECK(outcome.error().message.find("diverged at update") != std::string::npos);
        CHECK(outcome.error().hint.find("No weights were written yet") != std::string::npos);
    }

    TEST_CASE("the baseline has no controls, and says so when it is asked for some") {
        const TrainingFolder folder;
        const auto file = folder.path / "w";
        GestureSettings settings = toySettings(2);
        settings.shape.controls = false;
        GestureEpoch last;
        const auto outcome = trainGestures(shortTakes(), settings, {}, file,
                                           {{}, [&last](const GestureEpoch& one) { last = one; }});
        REQUIRE(outcome.has_value());
        CHECK(last.epoch == 2);
        CHECK_FALSE(last.scores.controls);
        const auto model = SpeechGestureModel::load(file).value();
        SpeechGestureRequest request = requestOf(shortTakes().validation.front());
        CHECK(model.generate(request).value().frames.size() == 120);
        request.poses = {{3, motion::relaxedUpperBody()}};
        const auto refused = model.generate(request);
        REQUIRE_FALSE(refused.has_value());
        CHECK(refused.error().message.find("without controls") != std::string::npos);
    }

    TEST_CASE("the scores of a motion that is the held-out one, and of the mean pose") {
        GestureTrainer trainer(shortTakes(), toySettings(1));
        trainer.trainAutoencoder();
        const GestureScores still = trainer.meanPoseScores();
        // By hand: the mean difference of directions from the mean pose in the frames 40 to 44 of each
        // window.
        const auto mean = meanPoseOf(shortTakes().training);
        double sum = 0.0;
        int count = 0;
        for (const GestureTake& take : shortTakes().validation)
            for (const std::size_t begin : {0, 30, 60})
                for (std::size_t f = begin + 40; f < begin + 45; ++f) {
                    const auto numbers = motion::numbersOf(take.motion.frames[f]);
                    for (std::size_t d = 0; d < numbers.size(); ++d, ++count)
                        sum += std::abs(numbers[d] - mean[static_cast<std::int64_t>(d)].item<double>());
                }
        CHECK(still.pcs == doctest::Approx(sum / count).epsilon(1e-4));
        CHECK(still.fgd_no_controls > 0.0);
        CHECK(still.fgd_no_controls == still.fgd_pose_controls);
    }

    TEST_CASE("without takes, or without sound, it says what is missing") {
        GestureTakes none = shortTakes();
        none.validation.clear();
        const auto outcome = trainGestures(none, toySettings(1), {}, "/tmp/never", {});
        REQUIRE_FALSE(outcome.has_value());
        CHECK(outcome.error().message.find("no takes held out") != std::string::npos);
        GestureTakes silent = shortTakes();
        silent.training[1].samples.clear();
        const auto refused = trainGestures(silent, toySettings(1), {}, "/tmp/never", {});
        REQUIRE_FALSE(refused.has_value());
        CHECK(refused.error().text().find("take 2 to train on") != std::string::npos);
        GestureTakes wordless = shortTakes();
        wordless.words = {};
        CHECK_FALSE(trainGestures(wordless, toySettings(1), {}, "/tmp/never", {}).has_value());
    }
}
