// What the conductor of a session and its units share: the frame under way, the avatars, the record.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "avatar_poser.hpp"
#include "session_view.hpp"
#include "studies/session/session.hpp"

namespace deixis::studies {

/// When an answer was given: keys are read with the frame, a press of select may be known more exactly.
[[nodiscard]] double keyTime(const InputFrame& input);
[[nodiscard]] double selectTime(const InputFrame& input);
/// The earliest that it can have been.
[[nodiscard]] double earliestKeyTime(const InputFrame& input);
[[nodiscard]] double earliestSelectTime(const InputFrame& input);

struct SessionCore {
    SessionCore(const Study& study_in, const ClipSource& clips_in, const motion::Skeleton& avatar_in,
                const motion::LocalPose& idle_in, bool keyboard_in, std::string hint_in);

    const Study& study;
    const ClipSource& clips;
    const motion::Skeleton& avatar;
    const motion::LocalPose& idle;
    bool keyboard;
    std::string hint;         ///< how to take part, at the foot of pages that begin or go on; may be empty
    AvatarPoser poser;        ///< the avatar; of a pair the left one
    AvatarPoser right_poser;  ///< of a pair
    bool pair = false;        ///< two avatars are shown
    SessionView view;
    std::vector<SessionEvent> events{};
    Moment now{};                                ///< of the input last stepped to
    std::optional<UnfinishedWork> unfinished{};  ///< of an earlier session
    double panel_since_s = 0.0;
    int trial_index = -1;     ///< of the trial under way, for notes; -1: none is
    double share_done = 0.0;  ///< of the visit, for the bar on pages

    [[nodiscard]] const LanguageTable& words() const { return study.words; }
    /// A page takes no input at once: a double click must not skip it.
    [[nodiscard]] bool settled() const;
    /// A time on the station's clock near the last input's, with its UTC.
    [[nodiscard]] Moment momentAt(double time_s) const;
    /// The clip, checked. Throws std::invalid_argument where it is empty or has not the avatar's joints.
    [[nodiscard]] const motion::Clip& clipOf(const Stimulus& stimulus) const;
    /// What an earlier session left of a trial; null: nothing.
    [[nodiscard]] const UnfinishedWork* unfinishedWork(int trial) const {
        return unfinished && unfinished->trial_index == trial ? &*unfinished : nullptr;
    }
    /// What is heard with it in a stage; null: nothing.
    [[nodiscard]] const ClipSound* soundOf(const Stimulus& stimulus, const Stage& stage) const {
        return stage.muted ? nullptr : clips.sound(stimulus);
    }
    /// Of the person, or where the head is somewhere else, of the study.
    [[nodiscard]] double eyeHeight(const InputFrame& input) const;
    [[nodiscard]] Vec3 eyes(const InputFrame& input) const;

    void note(NoteKind kind, std::string detail = {});
    void noteAt(const Moment& at, NoteKind kind, std::string detail);
    void openPanel(Panel panel, const InputFrame& input, PanelPlace place);
    /// Whether the session is to end, with what that means: one press must not end it. Its buttons are back
    /// and end_for_good.
    [[nodiscard]] Panel endConfirmation(const std::string& text) const;

    void standAlone();  ///< one avatar, at the origin
    /// Two avatars, to either side of the line of sight.
    void standAsPair();
    void advanceAvatars();
    void writeAvatars();
    /// In the stage's frame, as written last; where the skeleton has no head, its root.
    [[nodiscard]] const Pose& avatarHead(bool on_right) const;
    /// Puts the sound of the frame where the avatar that makes it has its mouth.
    void placeSound();

  private:
    std::size_t head_joint_;
};

/// An answer is open only when a frame that shows so has been shown.
class AnswerGate {
  public:
    void open(std::uint64_t frame);
    void close() { *this = {}; }
    void shown(std::uint64_t frame, double at_s);
    [[nodiscard]] bool isOpen() const { return frame_.has_value(); }
    [[nodiscard]] bool accepts() const { return shown_s_.has_value(); }
    /// Whether a key or select that went down is an answer: it was open already.
    [[nodiscard]] bool admitsKey(const InputFrame& input) const { return admits(earliestKeyTime(input)); }
    [[nodiscard]] bool admitsSelect(const InputFrame& input) const {
        return admits(earliestSelectTime(input));
    }
    [[nodiscard]] double since_s() const { return *shown_s_; }  ///< where it accepts

  private:
    [[nodiscard]] bool admits(double time_s) const { return shown_s_ && time_s >= *shown_s_; }
    std::optional<std::uint64_t> frame_{};
    std::optional<double> shown_s_{};
};

}  // namespace deixis::studies
