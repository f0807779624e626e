// What the store knows of the locked study.
#include <fmt/core.h>

#include <algorithm>

#include "results/database/database_open.hpp"
#include "results/store/locked_sets.hpp"
#include "store_differences.hpp"
#include "store_impl.hpp"

namespace deixis::results {

std::optional<std::string> Store::lockedHash() const {
    auto row = impl_->query("SELECT coalesce(locked_hash, '') FROM study");
    if (!row.next()) return std::nullopt;
    return row.text(0);
}

std::optional<std::string> Store::lockedHashOf(const std::string& participant) const {
    auto row = impl_->query("SELECT coalesce(locked_hash, '') FROM plans WHERE participant = ?");
    row << participant;
    if (!row.next()) return std::nullopt;
    return row.text(0);
}

std::string Store::studySource() const {
    auto row = impl_->query("SELECT coalesce(source, '') FROM study");
    return row.next() ? row.text(0) : "";
}

std::optional<Error> Store::Impl::studyObjection(const studies::Study& study) {
    auto known = query("SELECT name, hash FROM study");
    if (!known.next() || known.text(1) == study.hash) return std::nullopt;
    return Error{
        path.string(),
        fmt::format("the database has the study '{}' (hash {:.12}), but this is '{}' (hash {:.12}){}",
                    known.text(0), known.text(1), study.name, study.hash,
                    listed(studyDifferences(database, study))),
        "Use the study file that it was begun with, or another database"};
}

Result<void> Store::checkStudy(const studies::Study& study) const {
    if (auto objection = impl_->studyObjection(study)) return tl::unexpected(std::move(*objection));
    return {};
}

void Store::lockOlder(const std::string& hash) {
    impl_->transaction([&] {
        auto study = impl_->query("UPDATE study SET locked_hash = ? WHERE locked_hash IS NULL");
        study << hash;
        study.run();
        auto plans = impl_->query(
            "UPDATE plans SET locked_hash = (SELECT locked_hash FROM study) WHERE locked_hash IS NULL");
        plans.run();
    });
}

Result<void> Store::changeLocked(const std::string& from, const std::string& to, const std::string& what,
                                 const std::string& reason, double utc_s) {
    Result<void> outcome{};
    impl_->transaction([&] {
        auto row = impl_->query("SELECT 1 FROM study WHERE locked_hash = ?");
        row << from;
        if (!row.next()) {
            outcome = fail(impl_->path.string(), "another station has changed the study meanwhile",
                           "Look at what it has changed, and run this again");
            return;
        }
        auto study = impl_->query("UPDATE study SET locked_hash = ?");
        study << to;
        study.run();
        auto change = impl_->query("INSERT INTO locked_changes (utc_s, what, reason) VALUES (?, ?, ?)");
        change << utc_s << what << reason;
        change.run();
    });
    return outcome;
}

std::vector<studies::TargetItem> Store::plannedTargets() const {
    std::vector<studies::TargetItem> out;
    for (const std::string& participant : participants()) {
        const auto plan = impl_->plan(participant);
        if (!plan) continue;
        for (const auto& trial : plan->trials)
            for (const auto& stimulus : trial.stimuli) {
                const bool known = std::any_of(out.begin(), out.end(), [&](const auto& item) {
                    return item.id == stimulus.item && item.target == trial.target;
                });
                if (!known) out.push_back({stimulus.item, trial.target, trial.target != Vec3(0.0), {}});
            }
    }
    return out;
}

std::map<std::string, std::string> Store::shownClips() const {
    auto row = impl_->query(
        "SELECT s.system, min(x.clip_file) FROM response_stimuli AS x JOIN responses AS r ON r.id = "
        "x.response "
        "JOIN trial_stimuli AS s ON s.participant = r.participant AND s.trial_index = r.trial_index AND "
        "s.position = x.position GROUP BY s.system");
    std::map<std::string, std::string> out;
    while (row.next()) out[row.text(0)] = row.text(1);
    return out;
}

Result<std::vector<std::string>> lockedSets(const std::filesystem::path& database) {
    return readDatabase(database, [](SQLite::Database& opened) -> Result<std::vector<std::string>> {
        SQLite::Statement rows(opened,
                               "SELECT locked_hash FROM study WHERE locked_hash IS NOT NULL UNION SELECT "
                               "locked_hash FROM plans WHERE locked_hash IS NOT NULL ORDER BY 1");
        std::vector<std::string> out;
        while (rows.executeStep()) out.push_back(rows.getColumn(0).getString());
        return out;
    });
}

}  // namespace deixis::results
