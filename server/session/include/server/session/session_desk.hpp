// Where a session of a study and the pages that take part in it meet: the session's thread lays out what is
// shown and takes up what is asked, one after the other; the server's threads wait for either.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "server/http/route.hpp"

namespace deixis::server {

/// What is shown; a page of it is made by sessionJson().
struct SessionShown {
    nlohmann::ordered_json board;  ///< all but what follows: another one is another revision
    /// Of a trial of authoring: the project as it is now (JSON), and what is left of its time.
    std::shared_ptr<const std::string> project{};
    double left_s = 0.0;
};

struct SessionPage {
    std::uint64_t revision = 0;
    SessionShown shown{};
};

/// One edit of a project, as a page tells it.
struct ToldEdit {
    double at_s = 0.0;  ///< of the trial's time
    std::string json;   ///< all of it
};

/// What a page asks of the session.
struct SessionRequest {
    enum class Kind : unsigned char { press, slide, type, work, finish, pause };

    Kind kind = Kind::pause;
    std::uint64_t revision = 0;  ///< press, slide, type: of the page that it was done on
    int id = 0;                  ///< of the button, slider or field
    double value = 0.0;          ///< slide
    std::string text{};          ///< type: the field's whole text; work, finish: the project's JSON
    int trial = 0;               ///< work, finish
    std::vector<ToldEdit> edits{};
    int generated = 0;
};

class SessionDesk {
  public:
    using Time = std::chrono::steady_clock::time_point;
    /// The page after the request, or why it is not done.
    using Outcome = tl::expected<SessionPage, Refusal>;

    // The session's thread.
    /// Its revision.
    std::uint64_t lay(SessionShown shown);
    /// The next request, waited for until then; none: there was none. Each must be answered.
    [[nodiscard]] std::optional<SessionRequest> next(Time until);
    /// Of the request taken last: done, what lies there now is the answer; or refused.
    void done();
    void refuse(Refusal why);
    /// Whether what lies there was handed to a page.
    [[nodiscard]] bool seen() const;
    /// Waits until the last page was handed out to those who wait, but no longer; takes no more requests.
    void close(Time until);

    // The server's threads.
    /// The page when it is another than `after`, else as it is then.
    [[nodiscard]] SessionPage wait(std::uint64_t after, Time until);
    /// Waits until the session has answered. Where it does not in time, a refusal (503).
    [[nodiscard]] Outcome ask(SessionRequest request, Time until);

  private:
    struct Asked {
        SessionRequest request;
        std::optional<Outcome> outcome{};
        bool given_up = false;
    };

    mutable std::mutex mutex_;
    std::condition_variable laid_, asked_, answered_;
    SessionPage page_{};
    std::uint64_t seen_ = 0;  ///< revision that was handed out last
    bool closed_ = false;
    std::deque<std::shared_ptr<Asked>> waiting_;
    std::shared_ptr<Asked> taken_;

    void answer(Outcome outcome);
};

/// As the route answers it.
[[nodiscard]] std::string sessionJson(const SessionPage& page);

}  // namespace deixis::server
