// Who withdrew, combined from several copies of a study's databases.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <optional>
#include <string>
#include <vector>

namespace deixis::results {

struct Withdrawal {
    double utc_s = 0.0;
    std::optional<std::string> token{};  ///< the participant's; none: withdrawn before version 5
};

class Withdrawals {
  public:
    /// False where it is known already: the token says so, or, without one, the moment.
    bool add(const Withdrawal& one);
    /// Adds those of a database. Returns what was not known.
    std::vector<Withdrawal> addFrom(SQLite::Database& database);
    /// Whether a participant's rows are to be erased, or left out. Who begins again has another token.
    [[nodiscard]] bool include(const std::optional<std::string>& participant_token) const;
    [[nodiscard]] const std::vector<Withdrawal>& all() const { return all_; }

  private:
    std::vector<Withdrawal> all_;
};

}  // namespace deixis::results
