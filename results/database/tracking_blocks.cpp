#include "results/database/tracking_blocks.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace deixis::results {

namespace {

constexpr unsigned char format = 1;
constexpr int compression = 6;
constexpr double microseconds_per_s = 1e6;
constexpr double position_units_per_m = 65536.0;
constexpr double turn_units = 32768.0;
/// No person is farther away, and no unit quaternion comes near it.
constexpr double largest_number = 1e6;

// The columns, in the order in which they are written.
constexpr std::size_t frame_column = 0, display_column = 1, begun_column = 2, submitted_column = 3,
                      dropped_column = 4, rendered_column = 5, off_place_column = 6, first_pose_column = 7;
constexpr std::size_t columns_of_pose = 8;  ///< validity, x, y, z, qw, qx, qy, qz
constexpr std::size_t poses = 6;            ///< head, left and right aim, left and right grip, gaze
constexpr std::size_t columns = first_pose_column + poses * columns_of_pose;
constexpr std::size_t gaze = poses - 1;

constexpr std::int64_t position_valid = 1, orientation_valid = 2, tracked = 4, no_gaze = 8;

constexpr std::size_t longest_number = 10;  ///< bytes of a 64-bit number, seven bits in each
constexpr std::size_t header_bytes = 2;
constexpr std::size_t max_bytes = header_bytes + columns * max_frames_in_block * longest_number;

using Row = std::array<std::int64_t, columns>;

std::int64_t microseconds(double time_s) {
    constexpr double longest_s = 1e12;
    if (!(std::abs(time_s) < longest_s))
        throw std::invalid_argument(fmt::format("packTracking: {} s is no time", time_s));
    return std::llround(time_s * microseconds_per_s);
}

template <typename... Numbers>
bool canBeKept(Numbers... numbers) {
    return ((std::abs(numbers) <= largest_number) && ...);  // false for what is not a number
}

/// What is not valid stays as it was in the frame before: its differences are 0.
void putPose(Row& row, std::size_t first, const studies::TrackedPose& pose) {
    const Vec3& position = pose.stage_from_device.position;
    const Quat& turn = pose.stage_from_device.orientation;
    std::int64_t validity = pose.tracked ? tracked : 0;
    if (pose.position_valid && canBeKept(position.x, position.y, position.z)) {
        validity |= position_valid;
        row[first + 1] = std::llround(position.x * position_units_per_m);
        row[first + 2] = std::llround(position.y * position_units_per_m);
        row[first + 3] = std::llround(position.z * position_units_per_m);
    }
    if (pose.orientation_valid && canBeKept(turn.w, turn.x, turn.y, turn.z)) {
        validity |= orientation_valid;
        row[first + 4] = std::llround(turn.w * turn_units);
        row[first + 5] = std::llround(turn.x * turn_units);
        row[first + 6] = std::llround(turn.y * turn_units);
        row[first + 7] = std::llround(turn.z * turn_units);
    }
    row[first] = validity;
}

void putSample(Row& row, const studies::TrackingSample& sample) {
    const std::int64_t display = microseconds(sample.display_time_s);
    row[frame_column] = static_cast<std::int64_t>(sample.frame);
    row[display_column] = display;
    row[begun_column] = microseconds(sample.begun_s) - display;
    row[submitted_column] = microseconds(sample.submitted_s) - display;
    row[dropped_column] = sample.dropped_frames;
    row[rendered_column] = sample.rendered ? 1 : 0;
    if (!canBeKept(sample.off_place_m))
        throw std::invalid_argument(fmt::format("packTracking: {} m is no distance", sample.off_place_m));
    row[off_place_column] = std::llround(sample.off_place_m * position_units_per_m);
    std::size_t first = first_pose_column;
    for (const auto* pose :
         {&sample.head, &sample.aim[0], &sample.aim[1], &sample.grip[0], &sample.grip[1]}) {
        putPose(row, first, *pose);
        first += columns_of_pose;
    }
    if (sample.gaze)
        putPose(row, first, *sample.gaze);
    else
        row[first] = no_gaze;
}

/// Small numbers of either sign become small numbers, which take few bytes (zigzag, LEB128).
void append(std::string& bytes, std::int64_t number) {
    auto rest = (static_cast<std::uint64_t>(number) << 1U) ^ static_cast<std::uint64_t>(number >> 63);
    for (; rest >= 0x80U; rest >>= 7U) bytes += static_cast<char>(0x80U | (rest & 0x7FU));
    bytes += static_cast<char>(rest);
}

/// Reads what append() wrote; nothing where the bytes end too soon or the number is too long.
std::optional<std::int64_t> take(std::string_view& bytes) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < longest_number && i < bytes.size(); ++i) {
        const auto byte = static_cast<unsigned char>(bytes[i]);
        if (i + 1 == longest_number && byte > 1) return std::nullopt;  // 64 bits are full
        number |= static_cast<std::uint64_t>(byte & 0x7FU) << (7U * i);
        if (byte >= 0x80U) continue;
        bytes.remove_prefix(i + 1);
        return static_cast<std::int64_t>((number >> 1U) ^ (~(number & 1U) + 1U));
    }
    return std::nullopt;
}

std::string deflated(const std::string& raw) {
    uLongf size = compressBound(static_cast<uLong>(raw.size()));
    std::string out(size, '\0');
    if (compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(raw.data()),
                  static_cast<uLong>(raw.size()), compression) != Z_OK)
        throw std::runtime_error("packTracking: zlib does not compress");
    out.resize(size);
    return out;
}

tl::unexpected<Error> bad(std::string found, std::string expected) {
    return fail("tracking block", fmt::format("found {}, expected {}", found, expected));
}

Result<std::string> inflated(std::string_view data) {
    std::string out(max_bytes, '\0');
    uLongf size = max_bytes;
    auto used = static_cast<uLong>(data.size());
    const int outcome = uncompress2(reinterpret_cast<Bytef*>(out.data()), &size,
                                    reinterpret_cast<const Bytef*>(data.data()), &used);
    if (outcome != Z_OK || used != data.size())
        return bad(
            fmt::format("{} bytes that are no zlib stream of a block (zlib's code {})", data.size(), outcome),
            "one whole stream");
    out.resize(size);
    return out;
}

bool possible(const Row& row) {
    const bool dropped = row[dropped_column] >= 0 && row[dropped_column] <= std::numeric_limits<int>::max();
    bool valid = dropped && (row[rendered_column] == 0 || row[rendered_column] == 1);
    for (std::size_t pose = 0; pose < poses; ++pose) {
        const std::int64_t validity = row[first_pose_column + pose * columns_of_pose];
        valid = valid && validity >= 0 && (validity < no_gaze || (pose == gaze && validity == no_gaze));
    }
    return valid;
}

studies::TrackedPose poseOf(const Row& row, std::size_t pose) {
    const std::size_t first = first_pose_column + pose * columns_of_pose;
    const auto number = [&](std::size_t i, double units) {
        return static_cast<double>(row[first + i]) / units;
    };
    studies::TrackedPose out;
    out.tracked = (row[first] & tracked) != 0;
    out.position_valid = (row[first] & position_valid) != 0;
    out.orientation_valid = (row[first] & orientation_valid) != 0;
    if (out.position_valid)
        out.stage_from_device.position = {number(1, position_units_per_m), number(2, position_units_per_m),
                                          number(3, position_units_per_m)};
    if (out.orientation_valid)
        out.stage_from_device.orientation =
            Quat(number(4, turn_units), number(5, turn_units), number(6, turn_units), number(7, turn_units));
    return out;
}

studies::TrackingSample sampleOf(const Row& row) {
    const auto seconds = [](std::int64_t time) { return static_cast<double>(time) / microseconds_per_s; };
    // Added without sign: foreign bytes may hold any number.
    const auto after = [&](std::size_t column) {
        return seconds(static_cast<std::int64_t>(static_cast<std::uint64_t>(row[display_column]) +
                                                 static_cast<std::uint64_t>(row[column])));
    };
    studies::TrackingSample out;
    out.frame = static_cast<std::uint64_t>(row[frame_column]);
    out.display_time_s = seconds(row[display_column]);
    out.begun_s = after(begun_column);
    out.submitted_s = after(submitted_column);
    out.dropped_frames = static_cast<int>(row[dropped_column]);
    out.rendered = row[rendered_column] == 1;
    out.off_place_m = static_cast<double>(row[off_place_column]) / position_units_per_m;
    out.head = poseOf(row, 0);
    out.aim = {poseOf(row, 1), poseOf(row, 2)};
    out.grip = {poseOf(row, 3), poseOf(row, 4)};
    if (row[first_pose_column + gaze * columns_of_pose] != no_gaze) out.gaze = poseOf(row, gaze);
    return out;
}

}  // namespace

std::string packTracking(std::span<const studies::TrackingSample> samples) {
    if (samples.empty() || samples.size() > max_frames_in_block)
        throw std::invalid_argument(fmt::format("packTracking: found {} samples, expected 1 to {}",
                                                samples.size(), max_frames_in_block));
    std::vector<Row> rows(samples.size() + 1);  // the first one, all 0, is before the block
    for (std::size_t i = 0; i < samples.size(); ++i) {
        rows[i + 1] = rows[i];
        putSample(rows[i + 1], samples[i]);
    }
    std::string raw;
    raw += static_cast<char>(format);
    raw += static_cast<char>(samples.size());
    for (std::size_t column = 0; column < columns; ++column)
        for (std::size_t i = 1; i < rows.size(); ++i)
            append(raw, static_cast<std::int64_t>(static_cast<std::uint64_t>(rows[i][column]) -
                                                  static_cast<std::uint64_t>(rows[i - 1][column])));
    return deflated(raw);
}

Result<std::vector<studies::TrackingSample>> unpackTracking(std::string_view data) {
    const auto raw = inflated(data);
    if (!raw) return tl::unexpected(raw.error());
    if (raw->size() < header_bytes || static_cast<unsigned char>((*raw)[0]) != format)
        return bad(raw->empty() ? "nothing" : fmt::format("format {}", static_cast<unsigned char>((*raw)[0])),
                   fmt::format("format {}", format));
    const std::size_t count = static_cast<unsigned char>((*raw)[1]);
    if (count < 1 || count > max_frames_in_block)
        return bad(fmt::format("{} frames", count), fmt::format("1 to {}", max_frames_in_block));
    std::string_view rest(*raw);
    rest.remove_prefix(header_bytes);
    std::vector<Row> rows(count);
    for (std::size_t column = 0; column < columns; ++column) {
        std::uint64_t value = 0;
        for (Row& row : rows) {
            const auto difference = take(rest);
            if (!difference)
                return bad(fmt::format("no number in column {}", column), fmt::format("{} numbers", count));
            value += static_cast<std::uint64_t>(*difference);
            row[column] = static_cast<std::int64_t>(value);
        }
    }
    if (!rest.empty()) return bad(fmt::format("{} bytes after the last column", rest.size()), "none");
    std::vector<studies::TrackingSample> out;
    out.reserve(count);
    for (const Row& row : rows) {
        if (!possible(row)) return bad("numbers that no frame has", "flags of validity and counts");
        out.push_back(sampleOf(row));
    }
    return out;
}

}  // namespace deixis::results
