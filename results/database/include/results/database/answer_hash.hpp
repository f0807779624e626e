// A hash of each answer, stored with it, so that changes by file damage or another program are noticed.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace deixis::results {

struct HashedAnswer {
    std::int64_t id = 0;  ///< responses.id
    std::string participant;
    int trial_index = 0;
    std::optional<std::string> stored;  ///< responses.hash; none: of a version that kept none
    std::string computed;
};

/// SHA-256 of all that is stored of a response: its own columns, kept values, answers and clips, its trial as
/// planned, its session's station, the participant's groups, and what the study's tables say but for texts.
/// Numbers that each database counts for itself are left out, so that a copied answer keeps its hash; so is
/// what changes later, but for `superseded`. Each value is told with its type and length.
class AnswerHasher {
  public:
    enum class Scope : unsigned char { one, all };
    /// `database`, in the newest schema, must outlive it.
    AnswerHasher(SQLite::Database& database, Scope scope);

    /// Of one response; scope `one`.
    [[nodiscard]] std::string of(std::int64_t response);
    /// All responses in the order of their ids, each once; none: that was the last. Scope `all`.
    [[nodiscard]] std::optional<HashedAnswer> next();

  private:
    /// Rows of a response in another table, in the order of responses.
    struct Part {
        SQLite::Statement rows;
        bool there = false;
        /// Calls `take` with each row of the response.
        template <typename Take>
        void of(std::int64_t response, const Take& take);
    };

    [[nodiscard]] HashedAnswer hashed();
    [[nodiscard]] const std::string& groupsOf(const std::string& participant);
    /// Kept values by name, each as it is hashed.
    using Kept = std::map<std::string, std::string>;
    /// Returns the trial's that have not been told.
    Kept appendTrial(std::string& content, const std::string& participant, int trial_index);

    SQLite::Statement responses_;
    Part answers_;
    Part clips_;
    Part kept_;
    SQLite::Statement trial_;
    SQLite::Statement trial_kept_;
    SQLite::Statement stimuli_;
    SQLite::Statement groups_;
    std::string study_;
    std::string known_participant_{};
    std::string known_groups_{};
};

}  // namespace deixis::results
