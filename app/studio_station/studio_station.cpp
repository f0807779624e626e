#include "app/studio_station/studio_station.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <thread>
#include <utility>

#include "app/studio/browser.hpp"
#include "app/studio/interruption.hpp"
#include "app/studio/studio_parts.hpp"
#include "assets/avatar/avatar_glb.hpp"
#include "core/utc.hpp"
#include "page_acts.hpp"
#include "server/session/session_routes.hpp"
#include "session_board.hpp"

namespace deixis::app {

namespace {

using StationClock = std::chrono::steady_clock;

constexpr auto frame_time = std::chrono::milliseconds(50);
constexpr auto farewell_time = std::chrono::seconds(3);  // for pages to learn that it is over

double secondsOf(StationClock::time_point time) {
    return std::chrono::duration<double>(time.time_since_epoch()).count();
}

}  // namespace

struct StudioStation::State {
    std::shared_ptr<server::SessionDesk> desk = std::make_shared<server::SessionDesk>();
    Interruption interruption;
    std::string address;  ///< without the token
    std::unique_ptr<server::HttpServer> http;
    PageActs acts;
    std::shared_ptr<const std::string> project;
    StationClock::time_point tick = StationClock::now();
    double now_s = 0.0;
    bool answers = false;  ///< with the frame that is presented next a request is done
    bool closed = false;

    ~State() { close(); }

    void close() {
        if (std::exchange(closed, true)) return;
        desk->close(StationClock::now() + farewell_time);
        if (http) http->stop();
    }

    /// Until the next frame is due, or something is asked.
    void wait() {
        tick = std::max(tick + frame_time, StationClock::now());
        if (acts.busy()) {
            const double left_s = acts.notBefore_s() - secondsOf(StationClock::now());
            if (left_s <= 0.0)
                tick = StationClock::now();
            else
                std::this_thread::sleep_until(tick);
            return;
        }
        while (const auto request = desk->next(tick)) {
            auto refused = acts.begin(*request, secondsOf(StationClock::now()));
            if (!refused) {
                tick = StationClock::now();
                return;
            }
            desk->refuse(std::move(*refused));
        }
    }
};

StudioStation::StudioStation(std::unique_ptr<State> state) : state_(std::move(state)) {}
StudioStation::~StudioStation() = default;

Result<std::unique_ptr<StudioStation>> StudioStation::open(const StudioStationOptions& options,
                                                           const studies::Study& study,
                                                           const assets::Avatar& avatar) {
    auto state = std::make_unique<State>();
    server::ServerSettings settings;
    settings.port = options.port;
    settings.token = server::newToken();
    if (const auto page = addPage(settings); !page) return tl::unexpected(page.error());
    auto parts = studioParts({});
    if (!parts) return tl::unexpected(parts.error());
    if (!study.avatar.empty()) {
        settings.page_contents["/avatar.glb"] = assets::writeAvatarGlb(avatar);
        parts->avatar = server::DrawnAvatar{avatar.skeleton, avatar.humanoid};
    }
    parts->session = server::StudySession{options.participant, study.name, study.language,
                                          server::sessionRoutes(state->desk)};
    auto http = server::HttpServer::start(settings, server::studioRoutes(std::move(*parts)));
    if (!http) return tl::unexpected(http.error());
    state->http = std::move(*http);
    state->address = state->http->address();
    const std::string address = addressToOpen(*state->http, settings);
    fmt::print("{}\n", address);
    std::fflush(stdout);
    if (options.open_browser) openInBrowser(address);
    return std::unique_ptr<StudioStation>(new StudioStation(std::move(state)));
}

studies::StationInfo StudioStation::info() const {
    return {studies::StationKind::studio, "the studio's page at " + state_->address};
}

studies::InputFrame StudioStation::beginFrame() {
    State& s = *state_;
    s.wait();
    studies::InputFrame input;
    s.now_s = secondsOf(StationClock::now());
    input.time_s = s.now_s;
    input.utc_s = utcNow_s();
    s.answers = s.acts.act(input);
    if (s.interruption.came()) {
        input.quit = true;
        input.quit_reason = "interrupted";
    }
    return input;
}

studies::FrameReport StudioStation::present(const studies::PresentedFrame& frame) {
    State& s = *state_;
    const auto& task = frame.authoring;
    if (!task)
        s.project.reset();
    else if (!s.project || *s.project != task->so_far.project)
        s.project = std::make_shared<const std::string>(task->so_far.project);
    const std::uint64_t revision = s.desk->lay({sessionBoard(frame), s.project, task ? task->left_s : 0.0});
    s.acts.see(frame, revision, s.now_s);
    if (std::exchange(s.answers, false)) s.desk->done();
    return {frame.number, s.desk->seen(), s.now_s};
}

std::vector<studies::StationNote> StudioStation::close() {
    state_->close();
    return {};
}

}  // namespace deixis::app
