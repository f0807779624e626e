// Somebody who takes part, leaves all that a person can leave, and withdraws.
#pragma once

#include <doctest/doctest.h>

#include "core/files.hpp"
#include "fixtures.hpp"

namespace fixtures::withdrawal {

inline const std::string typed = "my left shoulder aches since Thursday";
inline const std::string consent_text = "Jag deltar av egen fri vilja och har blivit informerad.";
inline const std::string note = "wore thick green glasses";
inline const std::string id = "WITHDRAWER-17";

/// Every file beside and including the database that holds one of the texts, or carries one in its name.
inline std::vector<std::string> traces(const std::filesystem::path& database,
                                       const std::vector<std::string>& texts) {
    std::vector<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(database.parent_path())) {
        const std::string bytes = readFile(entry.path()).value();
        const std::string name = entry.path().filename().string();
        for (const auto& text : texts)
            if (bytes.find(text) != std::string::npos || name.find(text) != std::string::npos)
                out.push_back(name + ": " + text);
    }
    return out;
}

inline void takePart(results::Store& store, const studies::Study& study, const std::string& who,
                     const std::string& says, std::uint64_t tracked_frames = 500) {
    const auto plan = fixtures::widePlan(study, who);
    if (!store.plan(who)) REQUIRE(store.storePlan(study, fixtures::registration(plan, "sv"), plan));
    auto info = fixtures::session(who, false);
    info.station.properties = {{"operator", "of " + who}};
    store.beginSession(info);
    const auto record = [&](const studies::SessionEvent& event) {
        store.record(event, study, plan, fixtures::clips(plan));
    };
    auto consent = fixtures::response(plan.trials[0]);
    consent.answers = {{"consent", -1, 1.0}};
    record(consent);
    auto remark = fixtures::response(plan.trials[2]);
    remark.answers = {{"remark", -1, {}, says}};
    record(remark);
    record(studies::Note{studies::NoteKind::operator_note, 5, {50.0, 1.7e9 + 50.0}, note + " (" + who + ")"});
    for (const std::size_t trial : {5U, 6U}) record(fixtures::answer(plan.trials[trial], 1));
    record(studies::Superseded{6, says, {60.0, 1.7e9 + 60.0}});
    std::vector<results::TrackedFrame> frames;
    for (std::uint64_t i = 1; i <= tracked_frames; ++i) {
        frames.push_back({fixtures::frame(i), i < 300 ? 5 : -1});
        frames.back().sample.joints[0].resize(26);
    }
    store.recordTracking(frames, std::vector<results::TrialTracking>{{5, 300}});
}

}  // namespace fixtures::withdrawal
