// A session without a study: it shows one board with all that a board can have, and takes whatever pages ask.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "server/api/studio_api.hpp"
#include "server/session/session_routes.hpp"

namespace deixis::tests {

class PlayedSession {
  public:
    PlayedSession() : desk_(std::make_shared<server::SessionDesk>()) {
        desk_->lay({board(), std::make_shared<const std::string>("{\"version\": 2}"), 245.5});
        thread_ = std::thread([this] {
            while (!stops_)
                if (desk_->next(std::chrono::steady_clock::now() + std::chrono::milliseconds(20)))
                    desk_->done();
        });
    }
    ~PlayedSession() {
        stops_ = true;
        thread_.join();
        desk_->close(std::chrono::steady_clock::now());
    }
    PlayedSession(const PlayedSession&) = delete;
    PlayedSession& operator=(const PlayedSession&) = delete;

    [[nodiscard]] server::StudioParts in(server::StudioParts parts) const {
        parts.session = server::StudySession{"P01", "a-study", "en", server::sessionRoutes(desk_)};
        return parts;
    }

  private:
    static nlohmann::ordered_json board() {
        using nlohmann::ordered_json;
        const ordered_json box{0.1, 0.2, 0.3, 0.4};
        const ordered_json text{{"box", box},       {"text", "Hello"}, {"size_m", 0.04}, {"bold", true},
                                {"centred", false}, {"faint", false},  {"level", false}};
        const ordered_json button{{"box", box},      {"label", "Go on"}, {"caption", ""},  {"id", 1},
                                  {"enabled", true}, {"chosen", false},  {"role", "go_on"}};
        const ordered_json slider{{"box", box},
                                  {"track", box},
                                  {"id", 2},
                                  {"low", 0},
                                  {"high", 100},
                                  {"value", nullptr},
                                  {"labels", {"low", "high"}},
                                  {"label_size_m", 0.03},
                                  {"enabled", true}};
        const ordered_json field{{"box", box},  {"id", 3},         {"text", ""},
                                 {"hint", "?"}, {"active", false}, {"enabled", true}};
        const ordered_json panel{{"width_m", 1.0},
                                 {"height_m", 0.8},
                                 {"progress", 0.5},
                                 {"texts", ordered_json::array({text})},
                                 {"buttons", ordered_json::array({button})},
                                 {"sliders", ordered_json::array({slider})},
                                 {"fields", ordered_json::array({field})}};
        const ordered_json task{{"trial", 3},
                                {"of", 8},
                                {"practice", true},
                                {"system", "MANUAL"},
                                {"keyframes_only", true},
                                {"question", "Make gestures."},
                                {"limit_s", 300.0},
                                {"may_end_early", false}};
        return {{"state", "paused"}, {"stage", "authoring"}, {"notice", ""},
                {"over", false},     {"panel", panel},       {"authoring", task}};
    }

    std::shared_ptr<server::SessionDesk> desk_;
    std::atomic<bool> stops_ = false;
    std::thread thread_;
};

}  // namespace deixis::tests
