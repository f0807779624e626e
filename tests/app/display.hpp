// An X server of its own for a test of windows.
#pragma once

#include <unistd.h>

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>

#include "program.hpp"

namespace deixis::tests {

/// 1280 x 800, without a window manager.
class Display {
  public:
    Display()
        : server_("Xvfb :" + std::to_string(number()) +
                  " -screen 0 1280x800x24 -nolisten tcp >/dev/null 2>&1") {
        REQUIRE(eventually(20.0, [] { return xdotool("getdisplaygeometry").status == 0; }));
    }
    [[nodiscard]] static std::string environment() { return "env DISPLAY=:" + std::to_string(number()); }
    static Finished xdotool(const std::string& arguments) {
        return shell(environment() + " xdotool " + arguments);
    }

  private:
    static int number() {
        static const int chosen = 100 + static_cast<int>(getpid()) % 800;
        return chosen;
    }
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
