// A small study made by hand, its plans, and answers to them: what the tests of the results share.
#pragma once

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "results/store.hpp"

namespace fixtures {

using namespace deixis;

/// A new folder, removed with all it holds.
class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "deixis-results-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a temporary folder");
        path_ = name;
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

  private:
    std::filesystem::path path_;
};

/// Two layouts, a scale of five, and the systems named.
inline studies::Study study(const std::vector<std::string>& systems) {
    studies::Study out;
    out.name = "small";
    out.title = "A small <study> & its \"title\"";
    out.hash = std::string(64, 'a');
    out.layouts = {{"across", 0.0, 2.0, 180.0}, {"side-by-side", 0.5, 0.0, 0.0}};
    for (const auto& name : systems) out.systems.push_back({name, name, ""});
    out.rating.labels = {"1", "2", "3", "4", "5"};
    out.game.layouts = {"across", "side-by-side"};
    return out;
}

/// One practice trial, then `items` ratings a system, then 2 x `items` choices a system, layouts alternating.
inline studies::StudyPlan plan(const studies::Study& of, const std::string& participant, int items) {
    studies::StudyPlan out;
    out.participant = participant;
    out.study_name = of.name;
    out.study_hash = of.hash;
    out.seed = 18446744073709551615ULL;
    const auto add = [&](studies::StageKind stage, bool practice, const std::string& system, int item) {
        studies::Trial trial;
        trial.index = static_cast<int>(out.trials.size());
        trial.stage = stage;
        trial.practice = practice;
        trial.system = system;
        trial.target_id = "T00" + std::to_string(item % 10);
        trial.layout = stage == studies::StageKind::game && item % 2 == 1 ? "side-by-side" : "across";
        trial.target = {0.1 * item, 1.25, 0.75};
        if (stage == studies::StageKind::game) {
            trial.distractors = {{0.3, 1.5, 0.5}, {-0.3, 1.0, 0.5}};
            trial.ball_order = {2, 0, 1};
        }
        out.trials.push_back(trial);
    };
    add(studies::StageKind::naturalness, true, of.systems.front().name, 0);
    for (int item = 0; item < items; ++item)
        for (const auto& system : of.systems) add(studies::StageKind::naturalness, false, system.name, item);
    for (int item = 0; item < 2 * items; ++item)
        for (const auto& system : of.systems) add(studies::StageKind::game, false, system.name, item);
    return out;
}

inline std::vector<results::ClipRecord> clips(const studies::StudyPlan& of) {
    std::vector<results::ClipRecord> out;
    for (const auto& trial : of.trials)
        out.push_back({trial.system + "-" + trial.target_id + ".bvh", std::string(64, 'c')});
    return out;
}

/// A rating (1..5) or, in the game, whether the answer was right (0 or 1).
inline studies::Response answer(const studies::Trial& trial, int value) {
    studies::Response out;
    out.trial_index = trial.index;
    const double begin_s = 10.0 * trial.index;
    const double utc_s = 1.7e9;
    out.onset = {begin_s, utc_s + begin_s};
    out.motion_end = {begin_s + 3.0, utc_s + begin_s + 3.0};
    out.answered = {begin_s + 4.25, utc_s + begin_s + 4.25};
    out.response_time_s = 1.25;
    out.input = "ray";
    out.stage_from_head.position = {0.125, 1.65, 2.0};
    if (trial.stage == studies::StageKind::game) {
        out.correct = value != 0;
        out.chosen_place = out.correct ? trial.targetPlace() : (trial.targetPlace() + 1) % 3;
        out.pointer = Ray{{0.2, 1.3, 1.9}, {0.0, 0.0, -1.0}};
    } else {
        out.rating = value;
    }
    return out;
}

inline results::SessionInfo session(const std::string& participant, bool synthetic) {
    return {participant,
            {synthetic ? "simulated" : "desktop", "made by a test", synthetic},
            "0.1.0",
            std::string(64, 'd'),
            1.7e9};
}

/// A frame in which only the head is tracked.
inline studies::TrackingSample frame(std::uint64_t number) {
    studies::TrackingSample out;
    out.frame = number;
    out.display_time_s = static_cast<double>(number) / 90.0;
    out.begun_s = out.display_time_s - 0.030;
    out.submitted_s = out.display_time_s - 0.020;
    out.head = {{{0.0, 1.65, 2.0}, no_rotation}, true, true, true};
    return out;
}

/// Opens or throws.
inline results::Store open(const std::filesystem::path& path,
                           results::Durability how = results::Durability::each_answer) {
    auto store = results::Store::open(path, how);
    if (!store) throw std::runtime_error(store.error().text());
    return std::move(*store);
}

/// A database of `participants` made-up participants. System k (of the names given) is right in a share
/// right[k] of choices and rated about rating[k]. `keep` tells which trials are answered.
template <typename Keep>
void fill(const std::filesystem::path& path, const studies::Study& of, int participants, int items,
          bool synthetic, const std::vector<double>& right, const std::vector<double>& rating,
          const Keep& keep) {
    results::Store store = open(path, results::Durability::whole_run);
    for (int number = 1; number <= participants; ++number) {
        const std::string id = fmt::format("P{:02}", number);
        const auto trials = plan(of, id, items);
        if (!store.storePlan(of, trials)) throw std::runtime_error("the plan is refused");
        store.beginSession(session(id, synthetic));
        Random random(2023, id);
        const double bias = random.normal(0.0, 0.4);
        for (const auto& trial : trials.trials) {
            std::size_t system = 0;
            while (of.systems[system].name != trial.system) ++system;
            const bool correct = random.uniform() < right[system];
            const double rated = std::clamp(std::round(random.normal(rating[system] + bias, 0.8)), 1.0, 5.0);
            const bool game = trial.stage == studies::StageKind::game;
            if (!trial.practice && keep(number, trial))
                store.record(answer(trial, game ? static_cast<int>(correct) : static_cast<int>(rated)),
                             trials, clips(trials));
        }
        store.endSession("finished", 1.7e9 + 900.0);
    }
    store.commit();
}

inline bool everything(int, const studies::Trial&) {
    return true;
}

}  // namespace fixtures
