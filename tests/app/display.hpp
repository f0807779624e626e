// An X server of its own for a test of windows.
#pragma once

#include <unistd.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>

#include "program.hpp"

namespace deixis::tests {

/// 1280 x 800, without a window manager; one at a time.
class Display {
  public:
    // A server that begins again whenever its last client leaves would refuse the next one meanwhile.
    Display()
        : server_("Xvfb :" + std::to_string(nextNumber()) +
                  " -screen 0 1280x800x24 -nolisten tcp -noreset >/dev/null 2>&1") {
        REQUIRE(eventually(20.0, [] { return xdotool("getdisplaygeometry").status == 0; }));
    }
    [[nodiscard]] static std::string environment() { return "env DISPLAY=:" + std::to_string(number()); }
    static Finished xdotool(const std::string& arguments) {
        return shell(environment() + " xdotool " + arguments);
    }

  private:
    static int& number() {
        static int chosen = 100 + 10 * (static_cast<int>(getpid()) % 1000);
        return chosen;
    }
    /// Not that of a server that is just going.
    static int nextNumber() { return ++number(); }
    Background server_;
};

/// The number that a query of a session's database gives; -1 while it cannot be read.
inline int countIn(const std::string& database, const std::string& query) {
    try {
        SQLite::Database db(database, SQLite::OPEN_READONLY, 1000);
        return db.execAndGet(query).getInt();
    } catch (const SQLite::Exception&) {
        return -1;
    }
}

}  // namespace deixis::tests
