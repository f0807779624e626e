#include "waiting_room.hpp"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <thread>
#include <utility>

#include "answer_headers.hpp"
#include "request_head.hpp"

namespace deixis::server {

namespace {

constexpr auto farewell_time = std::chrono::seconds(2);
constexpr auto out_of_resources_pause = std::chrono::milliseconds(20);
constexpr std::size_t farewell_bytes = std::size_t{64} << 20U;

}  // namespace

WaitingRoom::WaitingRoom(Descriptor listener, TlsContext tls, const ServerLimits& limits)
    : listener_(std::move(listener)),
      tls_(std::move(tls)),
      limits_(limits),
      wake_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (!wake_.valid()) throw std::system_error(errno, std::generic_category(), "eventfd");
}

void WaitingRoom::wake() const {
    const std::uint64_t one = 1;
    // Fails only where it is full, and then it wakes.
    [[maybe_unused]] const ssize_t written = ::write(wake_.number(), &one, sizeof one);
}

void WaitingRoom::stop() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    came_.notify_all();
    wake();
}

bool WaitingRoom::stopping() const {
    const std::lock_guard lock(mutex_);
    return stopping_;
}

std::unique_ptr<Connection> WaitingRoom::take() {
    std::unique_lock lock(mutex_);
    came_.wait(lock, [this] { return stopping_ || !ready_.empty(); });
    if (ready_.empty()) return nullptr;
    auto connection = std::move(ready_.front());
    ready_.pop_front();
    return connection;
}

void WaitingRoom::giveBack(std::unique_ptr<Connection> connection, After after) {
    {
        const std::lock_guard lock(mutex_);
        if (stopping_) return;
        returned_.emplace_back(std::move(connection), after);
    }
    wake();
}

void WaitingRoom::queue(std::unique_ptr<Connection> connection) {
    {
        const std::lock_guard lock(mutex_);
        ready_.push_back(std::move(connection));
    }
    came_.notify_one();
}

void WaitingRoom::admit(std::unique_ptr<Connection> connection, After after) {
    if (guests_.size() >= limits_.connections) closeLongestWaiting();
    const auto now = Clock::now();
    Guest guest{std::move(connection), now, now + limits_.head_time};
    if (after == After::farewell) {
        guest.leaving = true;
        guest.deadline = now + farewell_time;
        guest.connection->endWriting();
    }
    guests_.push_back(std::move(guest));
}

void WaitingRoom::closeLongestWaiting() {
    const auto longest = std::min_element(guests_.begin(), guests_.end(),
                                          [](const Guest& a, const Guest& b) { return a.since < b.since; });
    if (longest != guests_.end()) guests_.erase(longest);
}

void WaitingRoom::acceptAll() {
    for (;;) {
        Descriptor socket(::accept4(listener_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
        if (socket.valid()) {
            admit(std::make_unique<Connection>(std::move(socket), tls_.get()), After::next_request);
            continue;
        }
        if (errno == EMFILE || errno == ENFILE) {
            // Too many files are open: the next one is taken when one is closed.
            closeLongestWaiting();
            std::this_thread::sleep_for(out_of_resources_pause);
            return;
        }
        if (errno != EINTR && errno != ECONNABORTED) return;
    }
}

void WaitingRoom::takeReturned() {
    decltype(returned_) returned;
    {
        const std::lock_guard lock(mutex_);
        returned.swap(returned_);
    }
    for (auto& [connection, after] : returned) {
        admit(std::move(connection), after);
        if (after == After::next_request) guests_.back().deadline = Clock::now() + limits_.idle_time;
    }
}

void WaitingRoom::refuse(Guest& guest, const Refusal& refusal) const {
    guest.connection->writeAtOnce(wholeAnswer(refusal));
    guest.connection->endWriting();
    guest.connection->forgetReceived();
    guest.leaving = true;
    guest.deadline = Clock::now() + farewell_time;
}

bool WaitingRoom::attendLeaving(Guest& guest) const {
    constexpr std::size_t at_a_time = std::size_t{256} << 10U;
    guest.next = guest.connection->receive(at_a_time);
    guest.thrown_away += guest.connection->received().size();
    guest.connection->forgetReceived();
    return guest.next != Connection::Next::closed && guest.thrown_away < farewell_bytes;
}

bool WaitingRoom::attend(Guest& guest) {
    guest.looked_at = true;
    if (guest.leaving) return attendLeaving(guest);
    const bool had_begun = !guest.connection->received().empty();
    guest.next = guest.connection->receive(limits_.head_bytes);
    const auto received = guest.connection->received();
    if (const auto end = headEnd(received)) {
        if (const auto problem = headProblem(received.substr(0, *end), limits_)) {
            refuse(guest, *problem);
            return true;
        }
        queue(std::move(guest.connection));
        return false;
    }
    if (guest.next == Connection::Next::closed) return false;
    if (guest.next == Connection::Next::enough) {
        refuse(guest,
               {431, "the request's head is longer than " + std::to_string(limits_.head_bytes) + " bytes"});
        return true;
    }
    if (!had_begun && !received.empty()) {
        guest.since = Clock::now();
        guest.deadline = guest.since + limits_.head_time;
    }
    return true;
}

void WaitingRoom::run() {
    std::vector<pollfd> watched;
    while (!stopping()) {
        watched.assign({{wake_.number(), POLLIN, 0}, {listener_.number(), POLLIN, 0}});
        auto next_deadline = Clock::now() + std::chrono::seconds(60);
        for (const Guest& guest : guests_) {
            const bool writes = guest.next == Connection::Next::write;
            watched.push_back({guest.connection->socket(), static_cast<short>(writes ? POLLOUT : POLLIN), 0});
            next_deadline = std::min(next_deadline, guest.deadline);
        }
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(next_deadline - Clock::now()).count();
        if (::poll(watched.data(), watched.size(), static_cast<int>(std::max<long>(0, left))) < 0)
            std::this_thread::sleep_for(out_of_resources_pause);

        const auto now = Clock::now();
        std::vector<Guest> staying;
        for (std::size_t i = 0; i < guests_.size(); ++i) {
            const bool stays = watched[i + 2].revents != 0 ? attend(guests_[i]) : now < guests_[i].deadline;
            if (stays) staying.push_back(std::move(guests_[i]));
        }
        guests_.swap(staying);

        std::uint64_t count = 0;
        [[maybe_unused]] const ssize_t read = ::read(wake_.number(), &count, sizeof count);
        takeReturned();
        if (watched[1].revents != 0) acceptAll();
        // The next request may have come already, behind the one before it.
        std::erase_if(guests_, [this](Guest& guest) { return !guest.looked_at && !attend(guest); });
    }
    guests_.clear();
    listener_ = Descriptor();
}

}  // namespace deixis::server
