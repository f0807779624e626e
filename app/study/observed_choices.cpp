#include "app/study/observed_choices.hpp"

#include <map>
#include <optional>
#include <utility>

#include "app/study/recorded_avatar.hpp"
#include "app/study/recorded_clips.hpp"
#include "results/store/shown_choices.hpp"
#include "studies/simulation/observed_gesture.hpp"

namespace deixis::app {

namespace {

/// The target first.
results::ObservedChoice watched(const results::ShownChoice& choice, const studies::ObservedGesture& gesture) {
    results::ObservedChoice out;
    out.seen.system = choice.stimulus.system;
    out.seen.layout = choice.layout;
    out.seen.arm = {gesture.hold, choice.head_m};
    out.first = gesture.first;
    out.last = gesture.last;
    out.participant = choice.participant;
    const auto target = static_cast<std::size_t>(choice.target_place);
    const auto chosen = static_cast<std::size_t>(choice.chosen_place);
    out.seen.balls = {choice.balls.at(target)};
    for (std::size_t place = 0; place < choice.balls.size(); ++place) {
        if (place == target) continue;
        if (place == chosen) out.chosen = static_cast<int>(out.seen.balls.size());
        out.seen.balls.push_back(choice.balls[place]);
    }
    return out;
}

}  // namespace

Result<std::vector<results::ObservedChoice>> observedChoices(const std::filesystem::path& database,
                                                             const std::filesystem::path& stimuli) {
    const auto shown = results::loadShownChoices(database);
    if (!shown) return tl::unexpected(shown.error());
    std::vector<results::ObservedChoice> out;
    if (shown->choices.empty()) return out;
    ShownAvatar showed{shown->study_source, {}, "all participants"};
    results::ClipRecords records;
    for (const results::ShownChoice& choice : shown->choices) {
        showed.hashes.insert(choice.avatar_hash);
        if (auto added = addShownClip(records, choice.stimulus, choice.clip, database); !added)
            return tl::unexpected(added.error());
    }
    const auto avatar = recordedAvatar(showed, database);
    if (!avatar) return tl::unexpected(avatar.error());
    const auto clips = RecordedClips::load(records, *avatar, stimuli, database);
    if (!clips) return tl::unexpected(clips.error());
    std::map<studies::Stimulus, std::optional<studies::ObservedGesture>> gestures;
    for (const results::ShownChoice& choice : shown->choices) {
        const auto [gesture, fresh] = gestures.try_emplace(choice.stimulus);
        if (fresh) gesture->second = studies::observeGesture(clips->clip(choice.stimulus), {});
        if (gesture->second && choice.balls.size() > 1) out.push_back(watched(choice, *gesture->second));
    }
    return out;
}

}  // namespace deixis::app
