#include "server/session/session_desk.hpp"

#include <algorithm>
#include <utility>

namespace deixis::server {

namespace {

Refusal overNow() {
    return {409, "the session is over"};
}

}  // namespace

std::uint64_t SessionDesk::lay(SessionShown shown) {
    const std::lock_guard lock(mutex_);
    const bool other = page_.revision == 0 || page_.shown.board != shown.board;
    page_.shown = std::move(shown);
    if (other) {
        ++page_.revision;
        laid_.notify_all();
    }
    return page_.revision;
}

std::optional<SessionRequest> SessionDesk::next(Time until) {
    std::unique_lock lock(mutex_);
    asked_.wait_until(lock, until, [this] { return !waiting_.empty(); });
    while (!waiting_.empty()) {
        taken_ = std::move(waiting_.front());
        waiting_.pop_front();
        if (!taken_->given_up) return taken_->request;
    }
    taken_.reset();
    return std::nullopt;
}

void SessionDesk::answer(Outcome outcome) {
    if (!taken_) return;
    taken_->outcome = std::move(outcome);
    taken_.reset();
    answered_.notify_all();
}

void SessionDesk::done() {
    const std::lock_guard lock(mutex_);
    answer(page_);
}

void SessionDesk::refuse(Refusal why) {
    const std::lock_guard lock(mutex_);
    answer(tl::unexpected(std::move(why)));
}

bool SessionDesk::seen() const {
    const std::lock_guard lock(mutex_);
    return page_.revision > 0 && seen_ == page_.revision;
}

void SessionDesk::close(Time until) {
    std::unique_lock lock(mutex_);
    closed_ = true;
    for (const auto& one : waiting_) one->outcome = tl::unexpected(overNow());
    waiting_.clear();
    answer(tl::unexpected(overNow()));
    answered_.notify_all();
    laid_.notify_all();
    laid_.wait_until(lock, until, [this] { return seen_ == page_.revision; });
}

SessionPage SessionDesk::wait(std::uint64_t after, Time until) {
    std::unique_lock lock(mutex_);
    laid_.wait_until(lock, until, [&] { return (page_.revision > 0 && page_.revision != after) || closed_; });
    seen_ = page_.revision;
    if (closed_) laid_.notify_all();
    return page_;
}

SessionDesk::Outcome SessionDesk::ask(SessionRequest request, Time until) {
    const auto asked = std::make_shared<Asked>();
    asked->request = std::move(request);
    std::unique_lock lock(mutex_);
    if (closed_) return tl::unexpected(overNow());
    waiting_.push_back(asked);
    asked_.notify_all();
    if (!answered_.wait_until(lock, until, [&] { return asked->outcome.has_value(); })) {
        asked->given_up = true;
        return tl::unexpected(Refusal{503, "the session did not answer in time: ask again"});
    }
    if (asked->outcome->has_value()) seen_ = std::max(seen_, (*asked->outcome)->revision);
    return std::move(*asked->outcome);
}

std::string sessionJson(const SessionPage& page) {
    nlohmann::ordered_json all{{"revision", page.revision}};
    all.update(page.shown.board);
    if (!all.contains("authoring") || all["authoring"].is_null()) return all.dump();
    // The project is there as JSON already.
    nlohmann::ordered_json authoring = std::move(all["authoring"]);
    all.erase("authoring");
    authoring["left_s"] = page.shown.left_s;
    std::string text = all.dump();
    text.pop_back();
    std::string task = authoring.dump();
    task.pop_back();
    return text + ",\"authoring\":" + task +
           ",\"project\":" + (page.shown.project ? *page.shown.project : "{}") + "}}";
}

}  // namespace deixis::server
