#include "app/study/enrolment.hpp"

#include <fmt/core.h>

#include <utility>

namespace deixis::app {

namespace {

Result<int> numberFor(const std::string& participant, std::optional<int> asked, const results::Store& store) {
    if (asked && store.numberTaken(*asked))
        return fail("--number", fmt::format("{} is the number of another participant", *asked),
                    "Give another one, or none: the next free one is then used");
    if (asked) return *asked;
    const auto wanted = studies::numberOfParticipant(participant);
    return wanted && !store.numberTaken(*wanted) ? *wanted : store.firstFreeNumber();
}

Result<results::Registration> registrationOf(const studies::Study& study, const results::Store& store,
                                             const std::string& participant, std::optional<int> number) {
    if (auto registered = store.registration(participant)) {
        if (number && *number != registered->number)
            return fail("--number",
                        fmt::format("found {}, but {} takes part with the number {}", *number, participant,
                                    registered->number),
                        "Leave it out");
        return std::move(*registered);
    }
    const auto drawn = numberFor(participant, number, store);
    if (!drawn) return tl::unexpected(drawn.error());
    return results::Registration{participant, *drawn, study.language,
                                 studies::assignGroups(study, store.groupsTaken(), *drawn)};
}

/// The next of those with the same groups who ever enrolled.
std::optional<int> numberInCell(const studies::Study& study, const results::Store& store,
                                const studies::Groups& groups) {
    if (study.between.empty()) return std::nullopt;
    const studies::GroupSizes registered = store.groupsRegistered();
    const auto cell = registered.find(groups);
    return 1 + (cell == registered.end() ? 0 : cell->second);
}

}  // namespace

Result<Enrolment> enrol(const StudySetup& setup, const results::Store& store, const std::string& participant,
                        std::optional<int> number, double now_utc_s) {
    const studies::Study& study = setup.study;
    Enrolment out;
    auto registration = registrationOf(study, store, participant, number);
    if (!registration) return tl::unexpected(registration.error());
    out.registration = std::move(*registration);
    if (auto stored = store.plan(participant)) {
        out.plan = std::move(*stored);
        out.planned_before = true;
    } else {
        auto plan =
            studies::buildPlan(study, setup.targets, participant, out.registration.number,
                               out.registration.groups, numberInCell(study, store, out.registration.groups));
        if (!plan) return tl::unexpected(plan.error());
        out.plan = std::move(*plan);
    }
    out.resume = store.resume(participant, now_utc_s);
    out.left = studies::trialsLeft(study, out.plan, out.resume.answered);
    return out;
}

Result<bool> storeEnrolment(const StudySetup& setup, const std::string& locked_hash, results::Store& store,
                            Enrolment& enrolment, std::optional<int> number, double now_utc_s) {
    if (enrolment.planned_before) return false;
    bool drawn_anew = false;
    const auto stored = store.exclusively([&]() -> Result<void> {
        const std::string participant = enrolment.registration.participant;
        if (!store.registration(participant)) {
            auto now = enrol(setup, store, participant, number, now_utc_s);
            if (!now) return tl::unexpected(now.error());
            drawn_anew = now->plan.number != enrolment.plan.number ||
                         now->plan.groups != enrolment.plan.groups ||
                         now->plan.number_in_cell != enrolment.plan.number_in_cell;
            if (drawn_anew) enrolment = std::move(*now);
        }
        return store.storePlan(setup.study, enrolment.registration, enrolment.plan, locked_hash);
    });
    if (!stored) return tl::unexpected(stored.error());
    return drawn_anew;
}

}  // namespace deixis::app
