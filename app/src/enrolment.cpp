#include "enrolment.hpp"

#include <utility>

namespace deixis::app {

namespace {

int numberFor(const std::string& participant, const results::Store& store) {
    const auto wanted = studies::numberOfParticipant(participant);
    if (!wanted) return store.firstFreeNumber();
    return store.numberTaken(*wanted) ? store.firstFreeNumber() : *wanted;
}

}  // namespace

Result<Enrolment> enrol(const StudySetup& setup, const results::Store& store, const std::string& participant,
                        double now_utc_s) {
    const studies::Study& study = setup.study;
    Enrolment out;
    if (auto registered = store.registration(participant)) {
        out.registration = std::move(*registered);
    } else {
        const int number = numberFor(participant, store);
        out.registration = {participant, number, study.language,
                            studies::assignGroups(study, store.groupsTaken(), number)};
    }
    auto stored = store.plan(participant);
    if (stored && stored->study_hash == study.hash) {
        out.plan = std::move(*stored);
    } else {
        auto plan = studies::buildPlan(study, setup.targets, participant, out.registration.number,
                                       out.registration.groups);
        if (!plan) return tl::unexpected(plan.error());
        out.plan = std::move(*plan);
    }
    out.resume = store.resume(participant, now_utc_s);
    out.left = studies::trialsLeft(study, out.plan, out.resume.answered);
    return out;
}

}  // namespace deixis::app
