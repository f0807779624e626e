// Bodies that try out a policy: what they remember of their states, and what power their actuators have.
#include <doctest/doctest.h>

#include <algorithm>

#include "environments.hpp"
#include "small_trainings.hpp"

using namespace deixis;
using namespace deixis::learning;

namespace {

struct Tried {
    explicit Tried(AmpSettings with) : settings(std::move(with)) {
        const auto& data = tests::fewDemonstrations();
        const motion::Skeleton& avatar = data.training.front().gesture.clip.skeleton;
        const auto features = motion::PoseFeatures::of(avatar).value();
        body = std::make_unique<physics::Body>(
            physics::Body::make(physics::makeFigure(avatar, physics::Stance::pinned).value()).value());
        references = makeReferences(*body, physics::BaseMotion::meanOf(features, data.training),
                                    data.training, settings)
                         .value();
        environments = std::make_unique<Environments>(*body, references, settings, 1);
    }

    AmpSettings settings;
    std::unique_ptr<physics::Body> body;
    std::vector<ReferenceMotion> references;
    std::unique_ptr<Environments> environments;
};

AmpSettings few() {
    AmpSettings out;
    out.environments = 6;
    out.demonstration_repeats = 1;
    out.discriminator_window = 4;
    out.power_penalty = 0.001;
    return out;
}

}  // namespace

TEST_SUITE("learning/amp_environments") {
    TEST_CASE(
        "a body remembers its last states, the present one last; before its begin they are the "
        "demonstration's") {
        Tried tried(few());
        Environments& all = *tried.environments;
        const std::size_t size = all.stateSize();
        std::vector<float> seen(all.count() * all.seenSize()), after(all.seenSize());
        for (int step = 0; step < 60; ++step) {
            all.see(seen);
            for (std::size_t i = 0; i < all.count(); ++i) {
                const std::span past = all.past(i);
                REQUIRE(past.size() == 3 * size);
                const std::span present = std::span(seen).subspan(i * all.seenSize(), size);
                CHECK(std::ranges::equal(past.last(size), present));
                const std::vector<float> before(past.begin(), past.end());
                const auto made = all.step(i, tried.references.front().targets_rad.front(), after);
                if (made.ended) continue;
                CHECK(std::ranges::equal(all.past(i).first(2 * size), std::span(before).last(2 * size)));
                CHECK(std::ranges::equal(all.past(i).last(size), std::span(after).first(size)));
            }
        }
    }

    TEST_CASE(
        "power is torque times speed: none at rest where the actuators are told to stay, some in a fast "
        "raise") {
        Tried tried(few());
        Environments& all = *tried.environments;
        std::vector<float> after(all.seenSize());
        std::vector<double> angles(tried.body->figure().hinges.size(), 0.0);
        double least = 1e9, most = 0.0;
        for (int step = 0; step < 200; ++step) {
            const auto made = all.step(0, angles, after);
            least = std::min(least, made.power_w);
            most = std::max(most, made.power_w);
        }
        CHECK(least < 0.5);
        CHECK(most > 5.0);

        AmpSettings without = few();
        without.power_penalty = 0.0;
        Tried other(without);
        CHECK(other.environments->step(0, angles, after).power_w == 0.0);
    }
}
