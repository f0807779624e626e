// Running the real program from a test.
#pragma once

#include <doctest/doctest.h>
#include <sys/wait.h>

#include <unistd.h>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "paths.hpp"
#include "skipping.hpp"

namespace deixis::tests {

namespace fs = std::filesystem;

struct Finished {
    int status = -1;  ///< exit status; 128 + signal where a signal ended it
    std::string out;
    std::string err;
};

inline std::string slurp(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void spill(const fs::path& path, const std::string& text) {
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

inline int exitStatus(int wait_status) {
    return WIFEXITED(wait_status) ? WEXITSTATUS(wait_status) : 128 + WTERMSIG(wait_status);
}

/// The folder in which all tests share the clips that the program makes for shipped studies; sanitizers make
/// them slow.
inline std::string sharedStimuli() {
    return (buildDir() / "test-stimuli").string();
}

struct WithSharedStimuli {};

/// A folder of its own for one test case, removed at its end.
class Scratch {
  public:
    Scratch() {
        std::string name = (fs::temp_directory_path() / "deixis_test_XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    /// Where a database in this folder looks for its clips lie the shared ones.
    explicit Scratch(WithSharedStimuli) : Scratch() {
        fs::create_directories(sharedStimuli());
        fs::create_directory_symlink(sharedStimuli(), path_ / "stimuli");
    }
    ~Scratch() {
        std::error_code code;
        fs::remove_all(path_, code);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    [[nodiscard]] std::string operator/(const std::string& name) const { return (path_ / name).string(); }
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// The shell command, its output and its status.
inline Finished shell(const std::string& command) {
    const Scratch scratch;
    const std::string whole = "( " + command + " ) >" + (scratch / "out") + " 2>" + (scratch / "err");
    Finished finished;
    finished.status = exitStatus(std::system(whole.c_str()));
    finished.out = slurp(scratch / "out");
    finished.err = slurp(scratch / "err");
    return finished;
}

/// `deixis ARGUMENTS`; `before` stands in front of the program, such as "env -u DISPLAY".
inline Finished program(const std::string& arguments, const std::string& before = "") {
    return shell(before + " " + programFile() + " " + arguments);
}

/// A program in the background, killed at the end of the scope if it still runs.
class Background {
  public:
    explicit Background(const std::string& command) : pid_(fork()) {
        if (pid_ == 0) {
            setpgid(0, 0);
            execl("/bin/sh", "sh", "-c", ("exec " + command).c_str(), nullptr);
            _exit(127);
        }
        REQUIRE(pid_ > 0);
    }
    ~Background() { kill(SIGKILL); }
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    void kill(int signal) {
        if (pid_ <= 0) return;
        ::kill(pid_, signal);
        wait();
    }
    /// Exit status, as in Finished.
    int wait() {
        if (pid_ <= 0) return status_;
        int wait_status = 0;
        waitpid(pid_, &wait_status, 0);
        pid_ = -1;
        status_ = exitStatus(wait_status);
        return status_;
    }
    [[nodiscard]] bool running() {
        int wait_status = 0;
        if (pid_ <= 0 || waitpid(pid_, &wait_status, WNOHANG) == 0) return pid_ > 0;
        pid_ = -1;
        status_ = exitStatus(wait_status);
        return false;
    }

  private:
    pid_t pid_;
    int status_ = -1;
};

/// The one set in a locked study's folder.
inline fs::path onlySetIn(const fs::path& locked) {
    std::vector<fs::path> sets;
    for (const auto& entry : fs::directory_iterator(locked))
        if (entry.is_directory()) sets.push_back(entry.path());
    REQUIRE(sets.size() == 1);
    return sets.front();
}

/// Waits up to `seconds` for something to come true.
template <typename Condition>
bool eventually(double seconds, Condition condition) {
    for (int i = 0; i < static_cast<int>(seconds * 20); ++i) {
        if (condition()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return condition();
}

/// The text with the first `from` replaced; the test fails where it is not there.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE_MESSAGE(at != std::string::npos, from);
    return text.replace(at, from.size(), to);
}

inline std::string shippedStudy() {
    return slurp(sourceDir() / "assets/data/studies/pointing2023-stand-ins.toml");
}

}  // namespace deixis::tests

/// The program must fail with status 1 and say each of the words, in one line that starts "deixis: error:".
#define CHECK_FAILS_SAYING(finished, ...)                                        \
    do {                                                                         \
        const auto& f_ = (finished);                                             \
        INFO("stderr: " << f_.err);                                              \
        CHECK(f_.status == 1);                                                   \
        CHECK(f_.err.rfind("deixis: error: ", 0) == 0);                          \
        for (const std::string& word_ : std::vector<std::string>{__VA_ARGS__}) { \
            INFO("expected word: " << word_);                                    \
            CHECK(f_.err.find(word_) != std::string::npos);                      \
        }                                                                        \
    } while (false)
