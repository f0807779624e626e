// What a replication package says of itself.
#pragma once

#include <string>

#include "results/answers/response_table.hpp"
#include "results/copies/anonymous_copy.hpp"
#include "results/participants/participants.hpp"

namespace deixis::app {

struct PackageFacts {
    results::ResponseTable answers;  ///< of the package's database
    results::ParticipantList people;
    results::AnonymousCounts counts;
    bool free_text = false;
    bool tracking = true;  ///< as asked for
    bool tracked = false;  ///< there is some
    std::string program;   ///< that made it
};

/// README.md.
[[nodiscard]] std::string packageReadme(const PackageFacts& facts);

}  // namespace deixis::app
