// Who takes part: number, groups and plan of a participant, new or returning.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/clips/study_setup.hpp"
#include "core/error.hpp"
#include "results/store/store.hpp"
#include "studies/design/plan.hpp"
#include "studies/session/session.hpp"

namespace deixis::app {

struct Enrolment {
    results::Registration registration;
    studies::StudyPlan plan;
    bool planned_before = false;  ///< the plan is a stored one
    studies::Resume resume;       ///< what earlier sessions left
    std::vector<int> left;        ///< trials still to be answered in the next visit

    [[nodiscard]] bool begun() const { return !resume.answered.empty() || resume.gap_s > 0.0; }
};

/// The stored registration and plan of somebody who has been here before, whatever a newer program would
/// draw; else new ones: the number asked for, or the one that the id ends in where it is free (else the next
/// free one), and the groups with the fewest participants. Stores nothing. Fails if the number asked for
/// is somebody else's, or the participant has another one.
[[nodiscard]] Result<Enrolment> enrol(const StudySetup& setup, const results::Store& store,
                                      const std::string& participant, std::optional<int> number,
                                      double now_utc_s);

/// Stores what enrol() gave, of the locked set of that hash; a plan that is stored already stays as it is.
/// Where somebody else enrolled in the meantime, number and groups are drawn again under the database's write
/// lock: true is returned then, and `enrolment` is what was stored.
[[nodiscard]] Result<bool> storeEnrolment(const StudySetup& setup, const std::string& locked_hash,
                                          results::Store& store, Enrolment& enrolment,
                                          std::optional<int> number, double now_utc_s);

}  // namespace deixis::app
