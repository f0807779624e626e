// The modules of the speech gestures' training against what plays them, against the plain style measures, and
// against numbers of SciPy.
#include "gesture_windows.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "learning/gesture_scores/motion_encoder.hpp"
#include "learning/gesture_scores/scores.hpp"
#include "learning/networks/optimising.hpp"
#include "learning/networks/tensors.hpp"
#include "motion/speech_gestures/gesture_inputs.hpp"
#include "motion/upper_body/upper_body_style.hpp"
#include "motion_autoencoder.hpp"
#include "network_module.hpp"

using namespace deixis;
using namespace deixis::learning;
using motion::MatrixXf;
using torch::Tensor;

namespace {

/// A sequence's channels x moments as Eigen has it: moment by moment.
MatrixXf matrixOf(const Tensor& channels_by_moments) {
    const Tensor plain = channels_by_moments.transpose(0, 1).contiguous();
    return Eigen::Map<const MatrixXf>(plain.data_ptr<float>(), plain.size(1), plain.size(0));
}

float largestDifference(const MatrixXf& a, const MatrixXf& b) {
    REQUIRE(a.rows() == b.rows());
    REQUIRE(a.cols() == b.cols());
    return (a - b).cwiseAbs().maxCoeff();
}

/// With normalisations as after a training.
GestureModule anyModule(const motion::GestureShape& shape) {
    setUpTorch(1);
    torch::manual_seed(11);
    GestureModule module(shape, 0.1);
    torch::NoGradGuard no_gradient;
    for (auto& parameter : module.parameters()) parameter += 0.03 * torch::randn_like(parameter);
    for (auto& buffer : module.named_buffers())
        if (buffer.key().find("running") != std::string::npos)
            buffer.value().copy_(torch::rand_like(buffer.value()) + 0.3);
    module.eval();
    return module;
}

motion::UpperBodyMotion anyMotion(int frames, std::uint64_t seed) {
    Random random(seed);
    motion::UpperBodyMotion out;
    motion::UpperBodyPose pose = motion::relaxedUpperBody();
    for (int f = 0; f < frames; ++f) {
        for (Vec3& direction : pose.directions)
            direction =
                glm::normalize(direction + 0.1 * Vec3(random.normal(), random.normal(), random.normal()));
        out.frames.push_back(pose);
    }
    return out;
}

Tensor directionsOf(const motion::UpperBodyMotion& motion) {
    std::vector<float> out;
    for (const auto& pose : motion.frames)
        for (const double number : motion::numbersOf(pose)) out.push_back(static_cast<float>(number));
    return torch::tensor(out).reshape({1, -1, 27});
}

}  // namespace

TEST_SUITE("learning/gesture_modules") {
    TEST_CASE("convolutions in Eigen are LibTorch's to 1e-5, with strides, padding and dilation") {
        setUpTorch(1);
        torch::manual_seed(1);
        torch::NoGradGuard no_gradient;
        const motion::ConvolutionPlaces all_places[] = {
            {.kernel = 15, .stride = 5},
            {.kernel = 3, .padding = 1},
            {.kernel = 3, .dilation = 4, .padding = 4},
            {.kernel = 4, .stride = 3, .dilation = 2, .padding = 5}};
        for (const auto& places : all_places) {
            CAPTURE(places.kernel);
            torch::nn::Conv1d layer(torch::nn::Conv1dOptions(6, 7, places.kernel)
                                        .stride(places.stride)
                                        .dilation(places.dilation)
                                        .padding(places.padding));
            motion::NetworkWeights weights;
            weights.arrays = {arrayOf("c.weight", layer->weight), arrayOf("c.bias", layer->bias)};
            const auto eigen = motion::Convolution::read(weights, "c", 6, 7, places);
            REQUIRE(eigen.has_value());
            const Tensor x = torch::randn({6, 40});
            CHECK(largestDifference(eigen->forward(matrixOf(x)),
                                    matrixOf(layer->forward(x.unsqueeze(0))[0])) < 1e-5F);
        }
    }

    TEST_CASE("layers of bidirectional GRUs in Eigen are LibTorch's to 1e-5, their directions summed") {
        setUpTorch(1);
        torch::manual_seed(2);
        torch::NoGradGuard no_gradient;
        for (const int layers : {1, 3}) {
            torch::nn::GRU gru(torch::nn::GRUOptions(5, 9).num_layers(layers).bidirectional(true));
            motion::NetworkWeights weights;
            appendGru(gru, "gru", weights.arrays);
            const auto eigen = motion::BidirectionalGru::read(weights, "gru", 5, 9, layers);
            REQUIRE(eigen.has_value());
            const Tensor x = torch::randn({50, 1, 5});
            const Tensor both = std::get<0>(gru->forward(x)).squeeze(1);
            const Tensor expected = both.narrow(1, 0, 9) + both.narrow(1, 9, 9);
            CHECK(largestDifference(eigen->forward(matrixOf(x.squeeze(1).t())), matrixOf(expected.t())) <
                  1e-5F);
        }
    }

    TEST_CASE(
        "the whole network in Eigen is the module to 1e-5, with its normalisations folded, and without "
        "controls") {
        for (const bool controls : {true, false}) {
            const motion::GestureShape shape{.sound_channels = 4,
                                             .sound_size = 8,
                                             .word_size = 10,
                                             .word_channels = 12,
                                             .word_levels = 3,
                                             .text_size = 8,
                                             .hidden = 24,
                                             .layers = 2,
                                             .controls = controls};
            GestureModule module = anyModule(shape);
            motion::NetworkWeights weights;
            module.append(weights.arrays);
            motion::appendShape(shape, weights);
            CHECK(motion::readShape(weights).value() == shape);
            const auto eigen = motion::GestureNetwork::read(weights, shape);
            REQUIRE(eigen.has_value());
            torch::NoGradGuard no_gradient;
            Random random(3);
            std::vector<float> samples(70000);
            for (float& sample : samples) sample = static_cast<float>(random.normal());
            const auto heard = motion::heardAround(motion::heardSound(samples), 4, 60);
            const Tensor sound = torch::tensor(heard).unsqueeze(0);
            const Tensor words = torch::randn({1, 60, 10}),
                         wishes = torch::randn({1, 60, motion::control_numbers});
            const MatrixXf encoded = eigen->encodeSound(heard);
            CHECK(largestDifference(encoded, matrixOf(module.encodeSound(sound)[0])) < 1e-5F);
            const MatrixXf found = eigen->forward(encoded, matrixOf(words[0].t()),
                                                  controls ? matrixOf(wishes[0].t()) : MatrixXf(0, 60));
            CHECK(largestDifference(found, matrixOf(module.forward(sound, words, wishes)[0].t())) < 1e-5F);
        }
    }

    TEST_CASE("style as tensors is styleOf() of the same motion, at the ends and in the middle") {
        const auto motion = anyMotion(60, 4);
        const auto expected = motion::styleOf(motion).value();
        const Tensor found = StyleMeasure(60).of(3.0 * directionsOf(motion));  // lengths do not matter
        for (std::int64_t f = 0; f < 60; ++f) {
            const auto& at = expected[static_cast<std::size_t>(f)];
            CHECK(found[0][f][0].item<double>() == doctest::Approx(at.speed).epsilon(1e-4));
            CHECK(found[0][f][1].item<double>() == doctest::Approx(at.space).epsilon(1e-4));
            CHECK(std::abs(found[0][f][2].item<double>() - at.handedness) < 1e-4);
        }
        // Who stands still has no speed, both hands alike, and slopes that are finite.
        const Tensor still = directionsOf(anyMotion(1, 5)).repeat({1, 60, 1}).set_requires_grad(true);
        const Tensor of_still = StyleMeasure(60).of(still);
        CHECK(of_still.select(-1, 0).abs().max().item<double>() < 1e-4);
        CHECK(of_still.select(-1, 2).abs().max().item<double>() < 1e-6);
        of_still.sum().backward();
        CHECK(still.grad().isfinite().all().item<bool>());
    }

    TEST_CASE("normalised styles are normalisedStyle()'s, and their mean and deviation styleNorm()'s") {
        const auto styles = motion::styleOf(anyMotion(60, 6)).value();
        std::vector<float> numbers;
        for (const auto& one : styles)
            for (const double number : {one.speed, one.space, one.handedness})
                numbers.push_back(static_cast<float>(number));
        const Tensor rows = torch::tensor(numbers).reshape({1, 60, 3});
        const auto norm = motion::styleNorm({styles});
        const auto found = normOf(rows);
        CHECK(found.mean.speed == doctest::Approx(norm.mean.speed).epsilon(1e-5));
        CHECK(found.sd.space == doctest::Approx(norm.sd.space).epsilon(1e-4));
        motion::StyleNorm narrow = norm;
        narrow.sd.handedness *= 0.2;  // so that some are clamped
        const Tensor normalised = normalisedStyles(rows, narrow);
        for (std::int64_t f = 0; f < 60; ++f) {
            const auto expected = motion::normalisedStyle(styles[static_cast<std::size_t>(f)], narrow);
            CHECK(std::abs(normalised[0][f][0].item<double>() - expected.speed) < 1e-3);
            CHECK(std::abs(normalised[0][f][2].item<double>() - expected.handedness) < 1e-3);
        }
        CHECK(normalised.abs().max().item<double>() == doctest::Approx(3.0));
    }

    TEST_CASE("the Frechet distance is SciPy's") {
        // Python 3.11, NumPy 1.24, SciPy 1.10: with i = 0..11, j = 0..3
        //   a = sin(0.7 i (j + 1)) + 0.1 j;  b = cos(0.4 i (j + 2)) * (1 + 0.3 j) - 0.2
        //   A, B = numpy.cov(a, rowvar=False), numpy.cov(b, rowvar=False); m = a.mean(0) - b.mean(0)
        //   m @ m + trace(A + B - 2 * scipy.linalg.sqrtm(A @ B).real)
        Eigen::MatrixXd a(12, 4), b(12, 4);
        for (int i = 0; i < 12; ++i)
            for (int j = 0; j < 4; ++j) {
                a(i, j) = std::sin(0.7 * i * (j + 1)) + 0.1 * j;
                b(i, j) = std::cos(0.4 * i * (j + 2)) * (1.0 + 0.3 * j) - 0.2;
            }
        CHECK(frechetDistance(a, b) == doctest::Approx(1.52508056099).epsilon(1e-9));
        CHECK(frechetDistance(b, a) == doctest::Approx(1.52508056099).epsilon(1e-9));
        CHECK(frechetDistance(a, a) < 1e-9);
        // Fewer rows than columns: covariances that have no inverse.
        CHECK(frechetDistance(a.topRows(3), b.topRows(3)) == doctest::Approx(3.67617481).epsilon(1e-6));
    }

    TEST_CASE("weights are chosen by all three scores, and a baseline by its distance alone") {
        const GestureScores scores{0.4, 0.2, 0.3, 0.01, 0.2, true};
        CHECK(scores.score() == doctest::Approx(std::cbrt(0.3 * 0.01 * 0.2)));
        const GestureScores baseline{.fgd_no_controls = 0.4, .controls = false};
        CHECK(baseline.score() == 0.4);
    }
}

TEST_SUITE("learning/gesture_windows") {
    TEST_CASE("controls are on as often as said, of all lengths and places, and are the reference's own") {
        torch::manual_seed(3);
        const std::int64_t windows = 2000;
        const Tensor poses = torch::randn({windows, 60, 27}), styles = torch::randn({windows, 60, 3});
        Random random(1);
        const Tensor controls = simulatedControls(poses, styles, 0.5, random);
        const Tensor posed = controls.select(2, motion::control_pose_mask);
        const Tensor there = posed.unsqueeze(-1) > 0.5;
        CHECK(controls.narrow(2, 0, 27).equal(torch::where(there, poses, torch::zeros_like(poses))));
        const Tensor count = posed.sum(1);
        CHECK(std::abs((count > 0).to(torch::kFloat32).mean().item<double>() - 0.5) < 0.04);
        CHECK((count == 1).sum().item<int>() > 0);
        CHECK((count == 60).sum().item<int>() > 0);
        // A quarter begins with the seed of 30 frames, and some have poses after it, too.
        const Tensor seeded = posed.narrow(1, 0, 30).sum(1) == 30;
        CHECK(seeded.to(torch::kFloat32).mean().item<double>() > 0.22);
        CHECK((seeded & (posed.select(1, 30) < 0.5) & (count > 30)).sum().item<int>() > 10);
        const Tensor masks = controls.narrow(2, motion::control_style_mask, 3).select(1, 0);
        CHECK(controls.narrow(2, motion::control_style, 3)
                  .equal(styles * controls.narrow(2, motion::control_style_mask, 3)));
        const Tensor elements = masks.sum(1);
        CHECK(std::abs((elements > 0).to(torch::kFloat32).mean().item<double>() - 0.5) < 0.04);
        CHECK(std::abs((elements == 2).to(torch::kFloat32).mean().item<double>() - 0.25) < 0.04);
        CHECK((elements == 1).sum().item<int>() == 0);
        for (int element = 0; element < 3; ++element)
            CHECK(std::abs(masks.select(1, element).mean().item<double>() - (0.25 + 0.25 * 2.0 / 3.0)) <
                  0.04);
    }

    TEST_CASE("windows pass through foreign poses, smoothly, and have them as their only pose controls") {
        const Tensor poses = torch::randn({400, 1, 27}).expand({400, 60, 27}).contiguous();
        Random random(2);
        CHECK(withForeignPoses(poses, 0.0, random).poses.equal(poses));
        const ForeignPoses foreign = withForeignPoses(poses, 0.25, random);
        CHECK(foreign.runs.size() > 70);
        CHECK(foreign.runs.size() < 130);
        Tensor controls = simulatedControls(foreign.poses, torch::zeros({400, 60, 3}), 1.0, random);
        setForeignControls(controls, foreign);
        for (const auto& run : foreign.runs) {
            const Tensor window = foreign.poses[run.window];
            const std::int64_t last = run.first + run.length - 1;
            CHECK(run.length <= 10);
            // All windows stand still: one of them is where the run is.
            const Tensor there = window[run.first];
            CHECK((poses.select(1, 0) - there).abs().amax(1).min().item<double>() < 1e-5);
            CHECK((window[last] - there).abs().max().item<double>() < 1e-5);
            if (run.first >= 12) CHECK(window[run.first - 12].equal(poses[run.window][0]));
            if (last < 48) CHECK(window[last + 12].equal(poses[run.window][0]));
            if (last < 48) {
                const double way = (there - poses[run.window][0]).norm().item<double>();
                const Tensor steps = window.narrow(0, last, 13).diff(1, 0).norm(2, 1);
                CHECK(steps.max().item<double>() < 1.875 / 12.0 * way + 1e-6);  // minimum jerk's peak
                CHECK(steps.max().item<double>() > 1.7 / 12.0 * way);
                CHECK(steps[0].item<double>() < 0.02 * way);
            }
            const Tensor mask = controls[run.window].select(1, motion::control_pose_mask);
            CHECK(mask.sum().item<std::int64_t>() == run.length);
            CHECK(controls[run.window]
                      .narrow(1, 0, 27)
                      .narrow(0, run.first, run.length)
                      .equal(window.narrow(0, run.first, run.length)));
        }
    }

    TEST_CASE(
        "controls of the scores: five poses in the middle of the new frames, or styles everywhere, or none") {
        const Tensor poses = torch::randn({2, 60, 27}), styles = torch::randn({2, 60, 3});
        CHECK(heldOutControls(poses, styles, GivenControls::none).abs().sum().item<double>() == 0.0);
        const Tensor posed = heldOutControls(poses, styles, GivenControls::poses);
        CHECK(posed.select(2, motion::control_pose_mask).sum().item<double>() == 10.0);
        CHECK(posed.narrow(1, 40, 5).narrow(2, 0, 27).equal(poses.narrow(1, 40, 5)));
        const Tensor styled = heldOutControls(poses, styles, GivenControls::styles);
        CHECK(styled.narrow(2, motion::control_style, 3).equal(styles));
        CHECK(styled.narrow(2, motion::control_style_mask, 3).sum().item<double>() == 2.0 * 60 * 3);
        CHECK(styled.narrow(2, 0, 28).abs().sum().item<double>() == 0.0);
    }

    TEST_CASE(
        "windows begin every stride and end with the take; short takes stand still in silence at their end") {
        GestureTake take;
        take.motion = anyMotion(100, 7);
        take.samples.assign(16000 * 100 / 15, 0.25F);
        take.utterance.words = {{"Yes", 2.0, 2.3}};
        motion::MatrixXf vectors(2, 1);
        vectors << 1.0F, 2.0F;
        const motion::WordVectors words({"yes"}, vectors);
        const Tensor mean = meanPoseOf({take});
        CHECK(mean.reshape({9, 3}).norm(2, 1).allclose(torch::ones({9})));
        const GestureWindows windows({take}, words, mean, 15);
        REQUIRE(windows.count() == 4);  // from 0, 15, 30 and 40
        const auto all = windows.range(0, 10);
        CHECK(all.poses.allclose(torch::stack({directionsOf(take.motion)[0].narrow(0, 0, 60),
                                               directionsOf(take.motion)[0].narrow(0, 15, 60),
                                               directionsOf(take.motion)[0].narrow(0, 30, 60),
                                               directionsOf(take.motion)[0].narrow(0, 40, 60)}) -
                                     mean,
                                 0.0, 1e-6));
        const Tensor word = torch::tensor({1.0F, 2.0F});
        CHECK(all.words[1][15].equal(word));
        CHECK(all.words[1].sum().item<double>() == 3.0);
        // Moved by less than a stride, never beyond the end.
        Random random(1);
        const std::vector<std::size_t> last(20, 3), first(20, 0);
        CHECK(windows.batch(last, random).poses.equal(all.poses.narrow(0, 3, 1).expand({20, 60, 27})));
        const Tensor moved = windows.batch(first, random).poses;
        CHECK_FALSE(moved.equal(all.poses.narrow(0, 0, 1).expand({20, 60, 27})));

        take.motion.frames.resize(20);
        take.samples.resize(16000 * 20 / 15);
        const GestureWindows few({take}, words, mean, 15);
        REQUIRE(few.count() == 1);
        const auto one = few.range(0, 1);
        CHECK(one.poses[0][59].equal(one.poses[0][19]));
        // 1.4 frames are heard before the first one.
        CHECK(one.sound[0][21 * 1080].item<double>() > 0.9);
        CHECK(one.sound[0].narrow(0, 22 * 1080, 1080).abs().max().item<double>() == 0.0);
    }

    TEST_CASE("the encoder of motions gives what LibTorch gives") {
        setUpTorch(1);
        torch::manual_seed(3);
        MotionAutoencoder autoencoder;
        motion::NetworkWeights weights;
        autoencoder.append(weights.arrays);
        const auto encoder = MotionEncoder::read(weights).value();
        const Tensor poses = 0.3 * torch::randn({2, 30, 27});
        const Eigen::MatrixXd wanted = autoencoder.features(poses);
        for (int window = 0; window < 2; ++window) {
            const Eigen::VectorXd found = encoder.encode(matrixOf(poses[window].transpose(0, 1)));
            CHECK((found - wanted.row(window).transpose()).cwiseAbs().maxCoeff() < 1e-5);
        }
        weights.file = "w";
        weights.arrays.pop_back();
        const auto refused = MotionEncoder::read(weights);
        REQUIRE_FALSE(refused.has_value());
        CHECK(refused.error().text().find("motion.latent.bias") != std::string::npos);
    }
}
