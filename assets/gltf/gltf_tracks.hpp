// The channels of one glTF animation, and the frame rate at which their keys stand.
#pragma once

#include <string>
#include <vector>

#include "assets/gltf/gltf_document.hpp"
#include "assets/gltf/gltf_values.hpp"

namespace deixis::assets::gltf {

/// One channel with its keys. `times` and `values` belong to the Values that it was read from.
struct Track {
    int node = 0;
    Path path = Path::translation;
    Interpolation interpolation = Interpolation::linear;
    const std::vector<double>* times = nullptr;   ///< increasing
    const std::vector<double>* values = nullptr;  ///< for cubic splines: in-tangent, value, out-tangent

    [[nodiscard]] std::size_t width() const { return path == Path::rotation ? 4 : 3; }
    /// Translation or scale at `time_s`, held before the first key and after the last (section 3.11,
    /// appendix C). A key nearer than `snap_s` is taken as it is.
    [[nodiscard]] Vec3 vector(double time_s, double snap_s) const;
    [[nodiscard]] Quat rotation(double time_s, double snap_s) const;
};

/// The tracks of an animation, but for those of the nodes in `left_out`. Throws Rejection where keys are not
/// as the specification wants them; `remarks` tells what could be mended.
[[nodiscard]] std::vector<Track> readTracks(const Document& document, int animation,
                                            const std::vector<int>& left_out, Values& values,
                                            std::vector<std::string>& remarks);

/// Frames k = 0..frames-1 stand at start_s + k * frame_time_s.
struct FrameGrid {
    double start_s = 0.0, frame_time_s = 1.0 / 30.0;
    std::size_t frames = 1;
    double snap_s = 0.0;  ///< a key this near a frame belongs to it
    std::string words;    ///< the rate and how it was found
    bool uneven = false;  ///< the keys do not stand at a steady rate
};

/// The grid on which all keys stand, or one that resamples them. `fps` greater than 0 is taken as it is.
[[nodiscard]] FrameGrid frameGrid(const std::vector<Track>& tracks, double fps);

}  // namespace deixis::assets::gltf
