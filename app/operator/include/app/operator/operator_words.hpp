// What the operator's panel says, in words: plain logic.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "app/session/operator_feed.hpp"
#include "studies/station/station.hpp"

namespace deixis::app {

/// What the participant does in a frame, for somebody who knows the study but not the program: "Aims at a
/// ball (side-by-side)". Empty before the first.
[[nodiscard]] std::string stateInWords(const studies::PresentedFrame& frame);

/// What somebody does with the device.
struct DeviceWords {
    std::string words;
    bool in_use = false;  ///< the person sees the pictures and can answer
};

/// "12 cm", "1.40 m"; whole centimetres below a metre.
[[nodiscard]] std::string distanceInWords(double metres);

/// "4:07", "1:02:30".
[[nodiscard]] std::string elapsedInWords(double seconds);

/// "about 12 min", "about 1 h 05 min", "less than a minute", "not known yet".
[[nodiscard]] std::string timeLeftInWords(std::optional<double> seconds);

/// "640 MB", "2.4 GB", "118 GB", in powers of ten as disks are sold.
[[nodiscard]] std::string bytesInWords(std::uintmax_t bytes);

/// "Skipped: the clip did not move". Kinds that operators are not told are named as in the record.
[[nodiscard]] std::string eventInWords(const OperatorEvent& event);

}  // namespace deixis::app
