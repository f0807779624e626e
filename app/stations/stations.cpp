#include "app/stations/stations.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "app/stations/simulated_setup.hpp"

#ifdef DEIXIS_STUDIO
#include "app/studio_station/studio_station.hpp"
#endif
#ifdef DEIXIS_IMMERSIVE
#include "app/desktop/desktop_station.hpp"
#include "app/desktop/drawn_simulation.hpp"
#include "app/headset/headset_station.hpp"
#include "app/sound/heard_station.hpp"
#endif

namespace deixis::app {

namespace {

#ifdef DEIXIS_IMMERSIVE

Result<std::unique_ptr<studies::Station>> openDesktop(const StationRequest& request,
                                                      const studies::Study& study,
                                                      const studies::StudyPlan& plan,
                                                      const assets::Avatar& avatar) {
    if (!request.screenshots->wanted.empty())
        return fail("--screenshot", "pictures of a session are taken with --station simulated");
    DesktopOptions options;
    options.title = study.title + " - " + plan.participant;
    options.fullscreen = request.fullscreen;
    options.eye_height_m = study.eye_height_m;
    options.controls = study.words("station_desktop_controls");
    options.operator_window = request.operator_window;
    options.operator_feed = request.operator_feed;
    if (!request.size.empty()) {
        const auto size = parseWindowSize(request.size);
        if (!size) return tl::unexpected(size.error());
        options.size = *size;
    }
    auto station = DesktopStation::open(avatar, options);
    if (!station) return tl::unexpected(station.error());
    return std::move(*station);
}

Result<std::unique_ptr<studies::Station>> openHeadset(const StationRequest& request,
                                                      const studies::Study& study,
                                                      const studies::StudyPlan& plan,
                                                      const assets::Avatar& avatar) {
    if (!request.screenshots->wanted.empty())
        return fail("--screenshot", "pictures of a session are taken with --station simulated");
    HeadsetStationOptions options;
    options.participant = plan.participant;
    options.title = study.title + " - " + plan.participant;
    options.resolution_scale = request.resolution_scale;
    options.study = study.headset;
    options.hint = study.words("station_headset_hint");
    options.tracking_lost = study.words("station_tracking_lost");
    options.operator_feed = request.operator_feed;
    if (!request.size.empty()) {
        const auto size = parseWindowSize(request.size);
        if (!size) return tl::unexpected(size.error());
        options.window_size = *size;
    }
    auto station = HeadsetStation::open(avatar, options);
    if (!station) return tl::unexpected(station.error());
    return std::move(*station);
}

// Where a person sits. Sound is asked for first: whoever sits down before a window expects the session to
// begin.
Result<std::unique_ptr<studies::Station>> openForPerson(const StationRequest& request,
                                                        const studies::Study& study,
                                                        const studies::StudyPlan& plan,
                                                        const assets::Avatar& avatar) {
    std::optional<SoundOutput> output;
    if (!request.sounds.empty()) {
        auto opened = SoundOutput::open(request.sounds);
        if (!opened) return tl::unexpected(opened.error());
        output = std::move(*opened);
    }
    auto station = request.kind == studies::StationKind::desktop ? openDesktop(request, study, plan, avatar)
                                                                 : openHeadset(request, study, plan, avatar);
    if (!station || !output) return station;
    return std::move(*output).withSound(std::move(*station));
}

#else

Result<std::unique_ptr<studies::Station>> openForPerson(const StationRequest& request, const studies::Study&,
                                                        const studies::StudyPlan&, const assets::Avatar&) {
    const bool headset = request.kind == studies::StationKind::headset;
    return fail("--station",
                fmt::format("this program was built without {} (DEIXIS_IMMERSIVE=OFF)",
                            headset ? "a headset" : "windows"),
                "Use --station simulated, or build with DEIXIS_IMMERSIVE=ON");
}

Result<void> drawSimulation(studies::SimulatedStation&, const assets::Avatar&, const std::string&,
                            const std::shared_ptr<Screenshots>& screenshots) {
    if (screenshots->wanted.empty()) return {};
    return fail("--screenshot", "this program was built without drawing (DEIXIS_IMMERSIVE=OFF)");
}

#endif

#ifdef DEIXIS_STUDIO

Result<std::unique_ptr<studies::Station>> openStudio(const StationRequest& request,
                                                     const studies::Study& study,
                                                     const studies::StudyPlan& plan,
                                                     const assets::Avatar& avatar) {
    if (!request.screenshots->wanted.empty())
        return fail("--screenshot", "pictures of a session are taken with --station simulated");
    if (request.operator_window)
        return fail("--operator", "a session in the browser has no window for the experimenter");
    auto station = StudioStation::open({request.port, !request.no_browser, plan.participant}, study, avatar);
    if (!station) return tl::unexpected(station.error());
    return std::move(*station);
}

#else

Result<std::unique_ptr<studies::Station>> openStudio(const StationRequest&, const studies::Study&,
                                                     const studies::StudyPlan&, const assets::Avatar&) {
    return fail("--station", "this program was built without the studio (DEIXIS_STUDIO=OFF)");
}

#endif

// A participant who pauses once, in the midst of the first clip: for a picture of that state.
class PausingStation : public studies::Station {
  public:
    explicit PausingStation(std::unique_ptr<studies::Station> station) : station_(std::move(station)) {}
    [[nodiscard]] studies::StationInfo info() const override { return station_->info(); }
    [[nodiscard]] studies::InputFrame beginFrame() override {
        studies::InputFrame input = station_->beginFrame();
        if (pointing_ && !paused_) {
            paused_ = true;
            input.pause = true;
            input.pause_reason = studies::PauseReason::picture;
        }
        return input;
    }
    studies::FrameReport present(const studies::PresentedFrame& frame) override {
        pointing_ = frame.state == studies::PresentedState::pointing;
        return station_->present(frame);
    }

  private:
    std::unique_ptr<studies::Station> station_;
    bool pointing_ = false;
    bool paused_ = false;
};

}  // namespace

Result<std::unique_ptr<studies::Station>> openStation(const StationRequest& request,
                                                      const studies::Study& study,
                                                      const studies::StudyPlan& plan,
                                                      const assets::Avatar& avatar) {
    if (request.kind == studies::StationKind::studio) return openStudio(request, study, plan, avatar);
    if (request.kind != studies::StationKind::simulated) return openForPerson(request, study, plan, avatar);
    if (request.operator_window)
        return fail("--operator", "a simulated participant has no window for the experimenter",
                    "Use --station desktop; a headset's window is always there");
    const auto parameters = studies::loadSimulatedParameters(request.simulated_parameters);
    if (!parameters) return tl::unexpected(parameters.error());
    auto station =
        std::make_unique<studies::SimulatedStation>(*parameters, avatar.skeleton, simulatedSeed(plan));
    if (auto drawn = drawSimulation(*station, avatar, request.size, request.screenshots); !drawn)
        return tl::unexpected(drawn.error());
    if (request.screenshots->wanted.contains("paused"))
        return std::make_unique<PausingStation>(std::move(station));
    return station;
}

}  // namespace deixis::app
