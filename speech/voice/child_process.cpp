#include "child_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <thread>
#include <utility>

extern char** environ;

namespace deixis::speech {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kept_of_errors = 4096;

class Descriptor {
  public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        close();
        fd_ = std::exchange(other.fd_, -1);
        return *this;
    }
    ~Descriptor() { close(); }

    [[nodiscard]] int get() const { return fd_; }
    [[nodiscard]] bool open() const { return fd_ >= 0; }
    void close() {
        if (fd_ >= 0) ::close(std::exchange(fd_, -1));
    }

  private:
    int fd_;
};

struct Pipe {
    Descriptor read, write;

    /// Neither end goes to programs that are started meanwhile, nor takes the place of a standard stream that
    /// this program was started without.
    [[nodiscard]] static Result<Pipe> make(const std::string& where) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0)
            return fail(where, fmt::format("no pipe can be made: {}", std::strerror(errno)));
        const Descriptor first(ends[0]), second(ends[1]);
        return Pipe{Descriptor(::fcntl(ends[0], F_DUPFD_CLOEXEC, 3)),
                    Descriptor(::fcntl(ends[1], F_DUPFD_CLOEXEC, 3))};
    }
};

/// Writing to a program that reads no more must not end this one: the signal stays pending in this thread,
/// and is taken away at the end.
class NoPipeSignal {
  public:
    NoPipeSignal() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
    }
    ~NoPipeSignal() {
        const timespec at_once{};
        while (sigtimedwait(&pipe_, nullptr, &at_once) > 0) {
        }
        pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    }
    NoPipeSignal(const NoPipeSignal&) = delete;
    NoPipeSignal& operator=(const NoPipeSignal&) = delete;

    [[nodiscard]] const sigset_t& before() const { return before_; }

  private:
    sigset_t pipe_{};
    sigset_t before_{};
};

/// A program that was started; killed with its group and waited for unless it has ended.
class Child {
  public:
    explicit Child(pid_t pid) : pid_(pid) {}
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    ~Child() {
        if (ended_) return;
        ::kill(-pid_, SIGKILL);
        while (::waitpid(pid_, &status_, 0) < 0 && errno == EINTR) {
        }
    }

    [[nodiscard]] bool endsBefore(Clock::time_point end) {
        while (!ended_) {
            const pid_t found = ::waitpid(pid_, &status_, WNOHANG);
            ended_ = found == pid_ || (found < 0 && errno != EINTR);
            if (!ended_ && Clock::now() >= end) return false;
            if (!ended_) std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
        return true;
    }
    [[nodiscard]] int status() const { return status_; }

  private:
    pid_t pid_;
    int status_ = 0;
    bool ended_ = false;
};

/// 0, or what stands in errno: of a program with these three standard streams, no other descriptor, a process
/// group of its own, and no signal blocked or ignored.
int spawn(const std::vector<std::string>& command, int in, int out, int err, const sigset_t& mask,
          pid_t& pid) {
    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&actions);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_adddup2(&actions, in, 0);
    posix_spawn_file_actions_adddup2(&actions, out, 1);
    posix_spawn_file_actions_adddup2(&actions, err, 2);
    posix_spawn_file_actions_addclosefrom_np(&actions, 3);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setsigmask(&attributes, &mask);
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    std::vector<char*> arguments;
    for (const std::string& part : command) arguments.push_back(const_cast<char*>(part.c_str()));
    arguments.push_back(nullptr);
    const int code =
        ::posix_spawnp(&pid, arguments.front(), &actions, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    return code;
}

/// Adds what there is to read; closes at the end.
void readSome(Descriptor& from, std::string& to) {
    std::array<char, 65536> buffer{};
    const ssize_t count = ::read(from.get(), buffer.data(), buffer.size());
    if (count > 0)
        to.append(buffer.data(), static_cast<std::size_t>(count));
    else if (count == 0 || (errno != EINTR && errno != EAGAIN))
        from.close();
}

/// Takes from `input` what the other end takes; closes at its end, and where nobody reads.
void writeSome(Descriptor& to, std::string_view& input) {
    const ssize_t count = input.empty() ? 0 : ::write(to.get(), input.data(), input.size());
    if (count > 0) input.remove_prefix(static_cast<std::size_t>(count));
    if (input.empty() || (count < 0 && errno != EINTR && errno != EAGAIN)) to.close();
}

}  // namespace

Result<ProgramOutput> runProgram(const std::vector<std::string>& command, std::string_view input,
                                 std::chrono::milliseconds timeout, std::size_t max_bytes,
                                 const std::string& where) {
    if (command.empty() || command.front().empty())
        return fail(where, "found an empty command, expected a program and its arguments");
    auto in = Pipe::make(where), out = Pipe::make(where), err = Pipe::make(where);
    for (const auto* pipe : {&in, &out, &err})
        if (!*pipe) return tl::unexpected(pipe->error());

    const NoPipeSignal no_signal;
    const Clock::time_point end = Clock::now() + timeout;
    pid_t pid = 0;
    const int code =
        spawn(command, in->read.get(), out->write.get(), err->write.get(), no_signal.before(), pid);
    if (code != 0)
        return fail(where, fmt::format("the program \"{}\" cannot be started: {}", command.front(),
                                       std::strerror(code)));
    Child child(pid);
    in->read.close();
    out->write.close();
    err->write.close();
    ::fcntl(in->write.get(), F_SETFL, O_NONBLOCK);

    const auto late = [&] {
        return fail(where, fmt::format("the program \"{}\" has not ended after {:.1f} s", command.front(),
                                       static_cast<double>(timeout.count()) / 1000.0));
    };
    ProgramOutput result;
    while (out->read.open() || err->read.open()) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
        if (left <= 0) return late();
        std::array<pollfd, 3> ends{
            {{in->write.get(), POLLOUT, 0}, {out->read.get(), POLLIN, 0}, {err->read.get(), POLLIN, 0}}};
        if (::poll(ends.data(), ends.size(), static_cast<int>(std::min<std::int64_t>(left, 1000))) <= 0)
            continue;
        if (ends[0].revents != 0) writeSome(in->write, input);
        if (ends[1].revents != 0) readSome(out->read, result.out);
        if (ends[2].revents != 0) readSome(err->read, result.err);
        if (result.out.size() > max_bytes)
            return fail(where, fmt::format("the program \"{}\" wrote more than {} bytes", command.front(),
                                           max_bytes));
        if (result.err.size() > 2 * kept_of_errors) result.err.erase(0, result.err.size() - kept_of_errors);
    }
    in->write.close();
    if (!child.endsBefore(end)) return late();
    result.status = child.status();
    return result;
}

}  // namespace deixis::speech
