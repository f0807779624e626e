// Other names for participants and sessions, in an order that tells nothing of theirs.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <map>
#include <string>
#include <vector>

namespace deixis::results {

/// Participants in the order of an export, with the names that stand for them.
class AnonymousNames {
  public:
    /// As they are, in the order of their ids; or anonymised: A001, A002, ... (another letter where ids begin
    /// so) in an order drawn from what an anonymised export leaves out (the moments of registration and the
    /// participants' tokens), so that it cannot be drawn again from it.
    AnonymousNames(SQLite::Database& database, bool anonymise);

    [[nodiscard]] const std::vector<std::string>& participants() const { return participants_; }
    [[nodiscard]] const std::string& nameOf(const std::string& participant) const {
        return names_.at(participant);
    }
    /// Other names for something else that names people, drawn likewise: "WORD 1", "WORD 2", ...
    [[nodiscard]] std::map<std::string, std::string> namesFor(const std::vector<std::string>& all,
                                                              const std::string& word) const;
    [[nodiscard]] long long nameOfSession(long long session) const { return sessions_.at(session).name; }
    /// On the station's clock; what is given is counted from here.
    [[nodiscard]] double startOfSession(long long session) const { return sessions_.at(session).start_s; }

  private:
    struct Session {
        long long name = 0;
        double start_s = 0.0;
    };
    std::vector<std::string> shuffled(std::vector<std::string> names) const;

    std::string secret_;
    std::vector<std::string> participants_;
    std::map<std::string, std::string> names_;
    std::map<long long, Session> sessions_;
};

}  // namespace deixis::results
