// The study of a session: locked at the first run, unchanged from then on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/study/locked_study.hpp"
#include "core/error.hpp"
#include "results/store/store.hpp"

namespace deixis::app {

struct StudyRequest {
    std::string study;  ///< as for loadStudySetup(); empty: the one that the database holds
    std::filesystem::path database;
    std::filesystem::path made;  ///< as in LockRequest
    std::string participant;     ///< empty: nobody in particular
    std::string language;        ///< asked for; empty: the study's first, or the participant's
    std::string accept_changes;  ///< why a lab's files were changed; empty: they must not be
};

/// The locked study of a participant: that of the stored plan, else the one in force. Where the database
/// holds none yet, it is locked now. A lab's files that are not those that were locked are rejected with what
/// has changed, or, where that is accepted, locked as the study in force from now on, which the database
/// keeps.
[[nodiscard]] Result<LockedStudy> studyUnderWay(const StudyRequest& request, results::Store& store);

/// The locked study that a new participant of this database would be planned from; nothing is locked or
/// stored. Fails if nothing is locked yet, or where this program would plan in another way.
[[nodiscard]] Result<LockedStudy> studyHeld(const std::filesystem::path& database,
                                            const results::Store& store);

}  // namespace deixis::app
