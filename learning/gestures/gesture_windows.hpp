// Takes as the windows that a model learns from, and controls simulated from them.
#pragma once

#include <torch/torch.h>

#include <span>
#include <vector>

#include "core/random.hpp"
#include "learning/gestures/training.hpp"

namespace deixis::learning {

/// Windows side by side, each of motion::gesture_window frames.
struct WindowBatch {
    torch::Tensor sound;  ///< windows x samples
    torch::Tensor words;  ///< windows x frames x numbers
    torch::Tensor poses;  ///< windows x frames x 27, relative to the mean pose
};

class GestureWindows {
  public:
    /// A window begins every `stride` frames, and one ends at the last frame.
    GestureWindows(const std::vector<GestureTake>& takes, const motion::WordVectors& words,
                   const torch::Tensor& mean_pose, int stride);

    [[nodiscard]] std::size_t count() const { return windows_.size(); }
    /// The windows of those numbers; each begins at random up to a stride later where it can.
    [[nodiscard]] WindowBatch batch(std::span<const std::size_t> numbers, Random& random) const;
    /// As they are: windows `first` to `first + count - 1`.
    [[nodiscard]] WindowBatch range(std::size_t first, std::size_t count) const;

  private:
    struct Take {
        std::vector<std::int16_t> heard;  ///< a float for each sample would be twice as much for hours
        torch::Tensor words;              ///< frames x numbers
        torch::Tensor poses;              ///< frames x 27
    };
    struct Window {
        std::size_t take = 0;
        int begin = 0;
    };
    [[nodiscard]] WindowBatch join(const std::vector<Window>& windows) const;

    int stride_;
    std::vector<Take> takes_;
    std::vector<Window> windows_;
};

/// The normalised mean of all directions, 27 numbers.
[[nodiscard]] torch::Tensor meanPoseOf(const std::vector<GestureTake>& takes);
/// Mean and standard deviation over all frames of some styles: windows x frames x 3.
[[nodiscard]] motion::StyleNorm normOf(const torch::Tensor& styles);

/// Which of the held-out controls a window is given.
enum class GivenControls : unsigned char { none, poses, styles };
/// Windows x frames x motion::control_numbers, of reference poses (relative) and their normalised styles.
[[nodiscard]] torch::Tensor heldOutControls(const torch::Tensor& poses, const torch::Tensor& styles,
                                            GivenControls given);
/// As a user might set them (section 5), each window for itself. With probability `share` there are poses: a
/// part of the reference, 1 to all frames long, at a random place; or, as often, the first 30 frames, as a
/// window of a long speech has them (appendix A.1), with or without such a part. With probability `share`
/// there are styles; of them, as often as not, one element is left out.
[[nodiscard]] torch::Tensor simulatedControls(const torch::Tensor& poses, const torch::Tensor& styles,
                                              double share, Random& random);

/// Windows of which some pass through poses of others.
struct ForeignPoses {
    struct Run {
        std::int64_t window = 0;
        std::int64_t first = 0;
        std::int64_t length = 0;
    };
    torch::Tensor poses;  ///< not of unit length where they were changed
    std::vector<Run> runs;
};
/// With probability `share` a window passes through some poses of another one, 1 to 10 frames at a random
/// place. It leaves what it was 12 frames before and is it again 12 frames after, the difference spread along
/// a minimum-jerk course: users' poses, too, are not what the speech suggests.
[[nodiscard]] ForeignPoses withForeignPoses(const torch::Tensor& poses, double share, Random& random);
/// Those windows' only poses are the foreign ones.
void setForeignControls(torch::Tensor& controls, const ForeignPoses& foreign);

/// Where the frames that a window adds begin: the scores look at them.
constexpr int scored_first = motion::gesture_window - motion::gesture_overlap;
static_assert(scored_first + scored_frames == motion::gesture_window);

}  // namespace deixis::learning
