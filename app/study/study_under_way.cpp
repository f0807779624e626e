#include "app/study/study_under_way.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>
#include <vector>

#include "app/study/locked_set.hpp"
#include "assets/data/data_paths.hpp"
#include "core/files.hpp"
#include "core/unique_name.hpp"
#include "core/utc.hpp"
#include "lab_files.hpp"
#include "studies/design/plan.hpp"
#include "studies/design/targets.hpp"
#include "studies/study_file/study_source.hpp"
#include "study_structure.hpp"

namespace deixis::app {

namespace {

namespace fs = std::filesystem;

Result<std::string> languageFor(const StudyRequest& request, const results::Store& store) {
    const auto registered = store.registration(request.participant);
    if (!registered) return request.language;
    if (!request.language.empty() && registered->language != request.language)
        return fail(request.database.string(),
                    fmt::format("{} takes part in the language '{}'; found --language {}",
                                request.participant, registered->language, request.language),
                    "Leave --language out");
    return registered->language;
}

Result<std::string> lockNow(const StudySetup& setup, const StudyRequest& request, const results::Store& store,
                            bool plans_are_older) {
    LockRequest lock{request.database, request.made};
    if (plans_are_older) {
        // Stored plans show these, wherever today's program would put the targets.
        for (const auto& item : store.plannedTargets()) {
            const auto same = std::find_if(setup.targets.begin(), setup.targets.end(),
                                           [&](const auto& one) { return one.id == item.id; });
            if (same == setup.targets.end() || same->target != item.target) lock.earlier.push_back(item);
        }
        for (const auto& [system, clip] : store.shownClips()) {
            const fs::path folder = fs::path(clip).parent_path();
            std::error_code code;
            for (const fs::path& place : {folder, request.made / folder.filename()})
                if (fs::is_regular_file(place / "manifest.csv", code))
                    lock.shown.emplace(system, place / "manifest.csv");
        }
    }
    auto hash = lockStudy(setup, lock);
    if (!hash) return tl::unexpected(firstOf(hash.error(), request.study));
    return *hash;
}

/// A study that ships, as its text was when the database was begun: the program may ship another by now.
Result<StudySetup> setupAsBegun(const StudyRequest& request, const results::Store& store) {
    auto setup = loadStudySetup(request.study, request.language);
    const std::string source = store.studySource();
    const fs::path file = assets::fileOrShipped(request.study, "studies");
    if (!isShipped(file) || (setup && setup->study.source == source)) return setup;
    const fs::path kept = request.database.string() + ".begun-" + uniqueName() + ".toml";
    if (auto written = writeFileUnsynced(kept, source); !written) return tl::unexpected(written.error());
    setup = loadStudySetup(kept.string(), request.language);
    std::error_code code;
    fs::remove(kept, code);
    if (setup) setup->study.file = file;
    return setup;
}

/// Targets and distractors by the rule of the older program, which did not ask whether they are seen: later
/// participants meet the same ones as earlier.
Result<std::vector<studies::TargetItem>> targetsAsBegun(const StudySetup& setup) {
    const studies::Study& study = setup.study;
    if (study.targets.from_manifest.empty() && study.targets.from_projects.empty())
        return studies::sampleTargets(study.targets, study.distances, study.seed);
    if (study.distances.empty()) return setup.targets;
    return studies::drawDistractors(setup.targets, study.targets, study.distances, study.seed);
}

Error holdsNone(const fs::path& database) {
    return {database.string(), "has no study yet",
            fmt::format("deixis run STUDY --db {}", database.string())};
}

Error lockedNothing(const fs::path& database) {
    return {database.string(),
            "was begun by a program that did not lock the study, so the study must be named again",
            fmt::format("deixis run STUDY --db {}", database.string())};
}

/// Empty: this program plans as the one that locked the study.
std::string plannerDifference(const LockedStudy& locked) {
    if (locked.planner == studies::planner_version) return "";
    return fmt::format("this program plans trials differently (version {}, not {})", studies::planner_version,
                       locked.planner);
}

std::string otherPlanner(const std::string& difference) {
    return difference + " than the one that began the study";
}

/// Of a database that an older program began: what is there now is locked.
Result<std::string> lockOlder(const StudyRequest& request, results::Store& store) {
    const std::string database = request.database.string();
    if (request.study.empty()) return tl::unexpected(lockedNothing(request.database));
    auto setup = setupAsBegun(request, store);
    if (!setup) return tl::unexpected(setup.error());
    // Of one that ships, questionnaires are the program's and may be others by now.
    if (!isShipped(setup->study.file) || setup->study.source != store.studySource())
        if (auto same = store.checkStudy(setup->study); !same) return tl::unexpected(same.error());
    auto targets = targetsAsBegun(*setup);
    if (!targets) return tl::unexpected(targets.error());
    setup->targets = std::move(*targets);
    const auto hash = lockNow(*setup, request, store, true);
    if (!hash) return hash;
    store.lockOlder(*hash);
    fmt::print(stderr,
               "note: {} was begun by an earlier version; the study as it is now has been locked beside it\n",
               database);
    return store.lockedHash().value_or(*hash);
}

/// Whether the request is for the study that the database holds, going by its name.
Result<void> checkName(const StudyRequest& request, const results::Store& store) {
    const fs::path file = assets::fileOrShipped(request.study, "studies");
    const auto text = readFile(file);
    if (!text) return tl::unexpected(text.error());
    const std::string kept = studies::studyNamedIn(store.studySource());
    const std::string asked = studies::studyNamedIn(*text);
    if (asked.empty() || kept.empty() || asked == kept) return {};
    return fail(request.database.string(),
                fmt::format("has the study '{}', but {} is '{}'", kept, file.string(), asked),
                "Use the study file that it was begun with, or another database");
}

/// New files of the lab's in force from now on.
Result<std::string> acceptChanges(const StudyRequest& request, results::Store& store,
                                  const LockedStudy& before, const std::vector<std::string>& changes,
                                  bool only_planner) {
    Result<std::string> hash = before.hash;
    if (only_planner) {
        hash = lockForPlanner(request.database, before);
    } else {
        const auto setup = loadStudySetup(request.study, request.language);
        if (!setup) return tl::unexpected(setup.error());
        if (const auto other = structureDifference(before.setup.study, setup->study); !other.empty())
            return fail(request.study,
                        fmt::format("is another study than the one in {}, and does not fit its answers: {}",
                                    request.database.string(), other),
                        "Use another database for it, or undo the change");
        hash = lockNow(*setup, request, store, false);
    }
    if (!hash) return hash;
    nlohmann::ordered_json what{{"from", before.hash}, {"to", *hash}, {"changes", changes}};
    if (auto kept = store.changeLocked(before.hash, *hash, what.dump(), request.accept_changes, utcNow_s());
        !kept)
        return tl::unexpected(kept.error());
    fmt::print("changes accepted, and recorded with the reason: {}\n", fmt::join(changes, "; "));
    return hash;
}

std::string listed(const std::vector<std::string>& changes) {
    constexpr std::size_t max = 20;
    const std::size_t told = std::min(max, changes.size());
    std::string out = fmt::format(
        "{}", fmt::join(changes.begin(), changes.begin() + static_cast<std::ptrdiff_t>(told), "; "));
    if (told < changes.size()) out += fmt::format("; and {} more", changes.size() - told);
    return out;
}

}  // namespace

Result<LockedStudy> studyHeld(const fs::path& database, const results::Store& store) {
    const auto in_force = store.lockedHash();
    if (!in_force) return tl::unexpected(holdsNone(database));
    if (in_force->empty()) return tl::unexpected(lockedNothing(database));
    auto locked = openLocked(database, *in_force);
    if (!locked) return locked;
    if (const auto other = plannerDifference(*locked); !other.empty())
        return fail(database.string(), otherPlanner(other), "Use the program that it was begun with");
    return locked;
}

Result<LockedStudy> studyUnderWay(const StudyRequest& asked, results::Store& store) {
    StudyRequest request = asked;
    auto language = languageFor(request, store);
    if (!language) return tl::unexpected(language.error());
    request.language = std::move(*language);

    auto in_force = store.lockedHash();
    if (in_force && !request.study.empty())
        if (auto named = checkName(request, store); !named) return tl::unexpected(named.error());
    if (!in_force) {
        if (request.study.empty()) return tl::unexpected(holdsNone(request.database));
        const auto setup = loadStudySetup(request.study, request.language);
        if (!setup) return tl::unexpected(setup.error());
        const auto hash = lockNow(*setup, request, store, false);
        if (!hash) return tl::unexpected(hash.error());
        return openLocked(request.database, *hash, request.language);
    }
    if (in_force->empty()) {
        const auto hash = lockOlder(request, store);
        if (!hash) return tl::unexpected(hash.error());
        in_force = *hash;
    }

    auto current = openLocked(request.database, *in_force, request.language);
    if (!current) return current;
    const auto planned = store.lockedHashOf(request.participant);  // empty: joined from an older database
    std::vector<std::string> changes;
    if (!request.study.empty()) {
        auto found = labDifferences(*current, request.study, seenFiles(request.database));
        if (!found) return tl::unexpected(found.error());
        changes = std::move(*found);
    }
    const std::string where = request.database.string();
    if (!changes.empty() && request.accept_changes.empty())
        return fail(
            where,
            fmt::format("has the study '{}' as it was locked when it began, and its files have changed: {}",
                        current->setup.study.name, listed(changes)),
            fmt::format("Restore the old files; or leave the study file out ('deixis run --db {}' continues "
                        "with what was locked); or give the reason with --accept-changes \"REASON\", which "
                        "is recorded: new participants then get the new files; or use another database",
                        where));
    const bool only_planner = changes.empty();
    // A stored plan is never made again, so another planner matters to new participants alone.
    if (const auto other = plannerDifference(*current); !other.empty() && !planned) {
        changes.push_back(other);
        if (request.accept_changes.empty())
            return fail(where, otherPlanner(other),
                        "Use the program that it was begun with for new participants; or give the reason "
                        "with --accept-changes \"REASON\", which is recorded");
    }
    if (!request.accept_changes.empty()) {
        if (changes.empty())
            return fail("--accept-changes", "was given, but nothing has changed since the study was locked",
                        "Leave it out");
        const auto hash = acceptChanges(request, store, *current, changes, only_planner);
        if (!hash) return tl::unexpected(hash.error());
        in_force = *hash;
    }
    const std::string& wanted = planned && !planned->empty() ? *planned : *in_force;
    if (wanted == current->hash) return current;
    return openLocked(request.database, wanted, request.language);
}

}  // namespace deixis::app
