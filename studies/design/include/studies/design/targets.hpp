// Targets and their distractors (Deichler et al. 2023, section 2.4.3).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/pose.hpp"
#include "studies/design/visibility.hpp"
#include "studies/study_file/study.hpp"

namespace deixis::studies {

/// One target with its distractors; positions in the avatar's frame, metres, rounded to 0.1 mm so that they
/// are the same on every machine and survive printing.
struct TargetItem {
    std::string id;  ///< "T001", "T002", ...
    Vec3 target{0.0};
    bool placed = true;  ///< false: an item of a manifest that has no target; it cannot be played
    /// By distance band, in the order of the bands given; empty if there are none.
    std::vector<std::vector<Vec3>> distractors{};
    /// How many clips a system has for the item, where it has several: a plan draws one of them.
    std::map<std::string, int> clips{};
};

/// Draws space.count targets uniformly in height, arc and radius, and for each target and distance band its
/// distractors from the same ranges, redrawn until they lie within the band's distance of the target (ends
/// included) and no nearer to each other or to the target than a ball's diameter. Fails with a clear error
/// after a bounded search where the ranges cannot be met.
///
/// Seen `from` somewhere, balls must be clear to see from there (ClearView): a target that is not is drawn
/// again from numbers of its own, and so is a distractor that is hidden or hides another ball. Without
/// viewpoints this is the bare rule of the paper. A target that is seen is the same by both.
///
/// A band that says so keeps its distractors within angles, too: the participant's are those of `places`,
/// from the middle height of each.
///
/// Depends on space, bands, seed and viewpoints alone; a band's distractors do not depend on the other bands.
/// A position is rounded to 0.1 mm before any distance is looked at, and distances are compared in whole
/// tenths of a millimetre: two mathematics libraries whose sines differ in the last bit give the same
/// targets. The targets do not depend on the distractors' settings, nor the first n of them on the count.
[[nodiscard]] Result<std::vector<TargetItem>> sampleTargets(const TargetSpace& space,
                                                            const std::vector<DistanceBand>& bands,
                                                            std::uint64_t seed,
                                                            const std::vector<Viewpoint>& from = {},
                                                            const std::vector<Viewpoint>& places = {});

/// The same around given targets (the items of TargetSpace::from_manifest), whose distractors are replaced.
/// Items that are not placed stay without; one whose target is hidden itself gets them by the bare rule.
[[nodiscard]] Result<std::vector<TargetItem>> drawDistractors(
    std::vector<TargetItem> items, const TargetSpace& space, const std::vector<DistanceBand>& bands,
    std::uint64_t seed, const std::vector<Viewpoint>& from = {}, const std::vector<Viewpoint>& places = {});

/// From where the balls of a study must be seen: viewpoints(), or none if it asks for the bare rule.
[[nodiscard]] std::vector<Viewpoint> askedViewpoints(const Study& study);

/// Those of a study whose ranges stand in its file.
[[nodiscard]] Result<std::vector<TargetItem>> sampleTargets(const Study& study);
/// Those around the items of a study's manifest.
[[nodiscard]] Result<std::vector<TargetItem>> drawDistractors(std::vector<TargetItem> items,
                                                              const Study& study);

/// What visibility has drawn again in an item, by which it departs from the bare rule.
enum class Redrawn : unsigned char { nothing, distractors, target };
/// By item, of targets as they are drawn for a study; a target that was drawn again has other distractors,
/// too.
[[nodiscard]] Result<std::vector<Redrawn>> redrawn(const Study& study,
                                                   const std::vector<TargetItem>& targets);

/// `space` with its three ranges replaced by those of `positions` (the targets of a manifest's clips): least
/// and largest height, azimuth and radius. Fails if there are none, or where one
/// lies on the avatar's axis, farther than 20 m, or so low that a ball there would stick in the floor.
[[nodiscard]] Result<TargetSpace> fitTargetSpace(TargetSpace space, const std::vector<Vec3>& positions);

/// "target_id,x,y,z" and for each band and distractor ",BAND_d1_x,BAND_d1_y,BAND_d1_z" (of a single band
/// ",d1_x,d1_y,d1_z"), then a row each.
[[nodiscard]] std::string targetsCsv(const std::vector<TargetItem>& targets,
                                     const std::vector<DistanceBand>& bands);
/// The same for a study with a game, with, for each band and viewpoint, the smallest share of a ball's disc
/// that is seen from there, "seen_LAYOUT_headset" and "seen_LAYOUT_desktop", and the smallest angle from the
/// target to a distractor in degrees, "angle_avatar", "angle_LAYOUT_headset" and "angle_LAYOUT_desktop" (of
/// several bands with the band before); last "drawn_anew": "target", "distractors" or empty, see redrawn();
/// all empty if that fails.
[[nodiscard]] std::string targetsCsv(const Study& study, const std::vector<TargetItem>& targets);

/// What is seen of an item's balls in one band, past an avatar: by viewpoint; of each the target first.
[[nodiscard]] std::vector<SeenBalls> seenOf(const Study& study, const TargetItem& item, std::size_t band,
                                            const std::vector<Viewpoint>& from, const StandingAvatar& avatar);

/// All of the items, to be kept and read again: the positions come back bit by bit.
[[nodiscard]] std::string targetsJson(const std::vector<TargetItem>& targets);
/// What targetsJson() wrote; an error names what does not fit.
[[nodiscard]] Result<std::vector<TargetItem>> targetsFromJson(std::string_view json);

/// A picture like the paper's Figure 1: the targets (and, where given, the positions that a manifest's clips
/// were made for) in a perspective view and from above and the side. A whole SVG document.
[[nodiscard]] std::string targetsSvg(const TargetSpace& space, const std::vector<TargetItem>& targets,
                                     const std::vector<Vec3>& demonstrations);

}  // namespace deixis::studies
