// A PostgreSQL server of the tests' own: in a temporary folder, on a free port, gone at the end.
#pragma once

#include <arpa/inet.h>
#include <sys/socket.h>

#include <algorithm>
#include <optional>

#include "program.hpp"

namespace deixis::tests {

class PostgresServer {
  public:
    static constexpr const char* password = "Aachen-73xyzzy";

    /// The one server of this process; null where PostgreSQL's server is not installed or not built for.
    static PostgresServer* get() {
#ifndef DEIXIS_SERVER
        MESSAGE("skipped: this program was built without PostgreSQL");
        return nullptr;
#endif
        static const std::string programs = newestPrograms();
        if (programs.empty()) {
            tellSkipped("PostgreSQL's server is not installed (scripts/install.sh tests)");
            return nullptr;
        }
        static PostgresServer server(programs);
        return &server;
    }

    ~PostgresServer() {
        // Past the last test: nothing of doctest's may be used.
        const std::string stop =
            as_user_ + programs_ + "/pg_ctl -D " + data() + " -m immediate stop >/dev/null 2>&1";
        if (std::system(stop.c_str()) != 0)
            std::fputs("the tests' PostgreSQL server could not be stopped\n", stderr);
    }
    PostgresServer(const PostgresServer&) = delete;
    PostgresServer& operator=(const PostgresServer&) = delete;

    /// A new database; its name.
    std::string database() {
        const std::string name = "lab" + std::to_string(++databases_);
        sql("postgres", "CREATE DATABASE " + name);
        return name;
    }
    /// Who comes through the socket needs no password.
    [[nodiscard]] std::string url(const std::string& database) const {
        return "postgresql://lab@/" + database + "?host=" + folder_.path().string() + "&port=" + port_;
    }
    /// Who comes through the network does; `user` may hold one.
    [[nodiscard]] std::string networkUrl(const std::string& user, const std::string& database) const {
        return "postgresql://" + user + "@127.0.0.1:" + port_ + "/" + database;
    }
    /// What psql prints: columns parted by |, NULL as \N.
    std::string sql(const std::string& database, const std::string& statement) const {
        const auto done = shell(psql(database) + " -c \"" + statement + "\"");
        REQUIRE_MESSAGE(done.status == 0, done.err);
        return done.out;
    }
    [[nodiscard]] std::string psql(const std::string& database) const {
        return "env PGOPTIONS='-c client_min_messages=error' " + programs_ +
               "/psql -X -q -At -P null='\\N' -v ON_ERROR_STOP=1 -h " + folder_.path().string() + " -p " +
               port_ + " -U lab -d " + database;
    }

  private:
    explicit PostgresServer(const std::string& programs) : programs_(programs) {
        // PostgreSQL does not run as root.
        if (geteuid() == 0) {
            as_user_ = "runuser -u " + std::string(shell("id postgres").status == 0 ? "postgres" : "nobody") +
                       " -- ";
            fs::permissions(folder_.path(), fs::perms::all);
        }
        spill(folder_ / "password", password);
        const auto made =
            shell("cd / && " + as_user_ + programs_ + "/initdb -D " + data() +
                  " -U lab -E UTF8 --locale=C.UTF-8 --auth-local=trust --auth-host=scram-sha-256 --pwfile=" +
                  (folder_ / "password") + " --no-sync");
        REQUIRE_MESSAGE(made.status == 0, made.err);
        port_ = freePort();
        const auto started = shell("cd / && " + as_user_ + programs_ + "/pg_ctl -D " + data() + " -l " +
                                   data() + "/log -w -t 120 -o '-h 127.0.0.1 -p " + port_ + " -k " +
                                   folder_.path().string() + " -c fsync=off' start");
        REQUIRE_MESSAGE(started.status == 0, (started.out + started.err));
    }

    static std::string newestPrograms() {
        std::vector<std::string> found;
        std::error_code none;
        for (const auto& version : fs::directory_iterator("/usr/lib/postgresql", none))
            if (fs::exists(version.path() / "bin/initdb")) found.push_back((version.path() / "bin").string());
        return found.empty() ? "" : *std::max_element(found.begin(), found.end());
    }

    static std::string freePort() {
        const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof(place);
        REQUIRE(bind(socket, reinterpret_cast<sockaddr*>(&place), size) == 0);
        REQUIRE(getsockname(socket, reinterpret_cast<sockaddr*>(&place), &size) == 0);
        close(socket);
        return std::to_string(ntohs(place.sin_port));
    }

    [[nodiscard]] std::string data() const {
        return folder_ / "data";
    }

    std::string programs_;
    std::string as_user_;
    std::string port_;
    Scratch folder_;
    int databases_ = 0;
};

}  // namespace deixis::tests
