// Pictures that a session takes of itself on request.
#pragma once

#include <map>
#include <set>
#include <string>

namespace deixis::app {

/// Pictures of states of a session, by name (presentedStateName).
struct Screenshots {
    std::map<std::string, std::string> wanted;  ///< state -> PNG file; taken ones are removed
    std::set<std::string> met;                  ///< the states that came
};

}  // namespace deixis::app
