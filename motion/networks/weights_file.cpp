#include "motion/networks/weights_file.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <bit>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "core/files.hpp"
#include "core/hash.hpp"
#include "core/number.hpp"

namespace deixis::motion {

namespace {

using Json = nlohmann::json;

static_assert(std::endian::native == std::endian::little, "weights are written as they lie in memory");

constexpr std::string_view mark = "deixis-weights ";
constexpr std::uint64_t format_version = 1;
constexpr std::size_t checksum_bytes = 64;
constexpr std::size_t max_bytes = std::size_t{1} << 30U;
constexpr const char* again = "Copy the file again from where it came, or train again";

std::size_t sizeOf(WeightsPrecision precision) {
    return precision == WeightsPrecision::float32 ? sizeof(float) : sizeof(Eigen::half);
}

const char* nameOf(WeightsPrecision precision) {
    return precision == WeightsPrecision::float32 ? "float32" : "float16";
}

void append(std::string& out, float value, WeightsPrecision precision) {
    std::array<char, sizeof(float)> bytes{};
    if (precision == WeightsPrecision::float32) {
        std::memcpy(bytes.data(), &value, sizeof value);
    } else {
        const std::uint16_t half = Eigen::half(value).x;
        std::memcpy(bytes.data(), &half, sizeof half);
    }
    out.append(bytes.data(), sizeOf(precision));
}

float valueAt(const char* bytes, WeightsPrecision precision) {
    if (precision == WeightsPrecision::float32) {
        float value = 0.0F;
        std::memcpy(&value, bytes, sizeof value);
        return value;
    }
    std::uint16_t half = 0;
    std::memcpy(&half, bytes, sizeof half);
    return Eigen::half_impl::half_to_float(Eigen::half_impl::raw_uint16_to_half(half));
}

Json headerOf(const NetworkWeights& weights, WeightsPrecision precision) {
    Json settings = Json::object();
    for (const auto& setting : weights.settings)
        std::visit([&](const auto& held) { settings[setting.first] = held; }, setting.second);
    Json arrays = Json::array();
    for (const NamedArray& array : weights.arrays)
        arrays.push_back({{"name", array.name}, {"type", nameOf(precision)}, {"shape", array.shape}});
    return {{"architecture", weights.architecture},
            {"settings", settings},
            {"training_data_sha256", weights.training_data_sha256},
            {"seed", weights.seed},
            {"program_version", weights.program_version},
            {"commit", weights.commit},
            {"metrics", weights.metrics},
            {"synthetic", weights.synthetic},
            {"arrays", arrays}};
}

/// A number as it stands: one with a point or a minus is none. Throws where it is another.
std::uint64_t wholeNumber(const Json& value) {
    if (!value.is_number_unsigned())
        throw std::invalid_argument(fmt::format("found {}, expected a whole number", value.dump()));
    return value.get<std::uint64_t>();
}

/// One array as the header announces it.
struct Announced {
    NamedArray array;
    WeightsPrecision precision = WeightsPrecision::float32;
    std::size_t count = 1;
};

/// Throws what nlohmann::json does where a key is missing or of another type.
Announced announced(const Json& one) {
    Announced out;
    out.array.name = one.at("name").get<std::string>();
    for (const Json& size : one.at("shape")) out.array.shape.push_back(wholeNumber(size));
    const auto type = one.at("type").get<std::string>();
    if (type == nameOf(WeightsPrecision::float16))
        out.precision = WeightsPrecision::float16;
    else if (type != nameOf(WeightsPrecision::float32))
        throw std::invalid_argument(
            fmt::format("array '{}' is of type \"{}\", expected float32 or float16", out.array.name, type));
    for (const std::size_t size : out.array.shape) {
        if (size == 0 || size > max_bytes / out.count)
            throw std::invalid_argument(
                fmt::format("array '{}' has a size of {} that no file holds", out.array.name, size));
        out.count *= size;
    }
    return out;
}

NetworkWeights withoutArrays(const Json& header) {
    NetworkWeights out;
    out.architecture = header.at("architecture").get<std::string>();
    for (const auto& [key, value] : header.at("settings").items()) {
        if (value.is_string())
            out.settings[key] = value.get<std::string>();
        else
            out.settings[key] = value.get<double>();
    }
    out.training_data_sha256 = header.at("training_data_sha256").get<std::string>();
    out.seed = wholeNumber(header.at("seed"));
    out.program_version = header.at("program_version").get<std::string>();
    out.commit = header.at("commit").get<std::string>();
    out.metrics = header.at("metrics").get<std::map<std::string, double>>();
    out.synthetic = header.at("synthetic").get<bool>();
    return out;
}

/// Where the header lies in the file.
struct HeaderPlace {
    std::size_t begin = 0;
    std::size_t size = 0;
};

Result<HeaderPlace> findHeader(std::string_view bytes, const std::string& name) {
    constexpr std::size_t longest_line = 64;
    const auto foreign = [&] {
        return fail(name, "this is no file of weights",
                    "Expected a file that 'deixis learn' wrote; such a file begins with 'deixis-weights'");
    };
    if (!bytes.starts_with(mark)) return foreign();
    const std::size_t end = bytes.substr(0, longest_line).find('\n');
    if (end == std::string_view::npos) return foreign();
    const std::string_view line = bytes.substr(mark.size(), end - mark.size());
    const std::size_t blank = line.find(' ');
    const auto version = naturalNumber(line.substr(0, blank));
    if (!version || *version == 0) return foreign();
    if (*version > format_version)
        return fail(
            name,
            fmt::format("the weights are in format {}, this program reads {}", *version, format_version),
            "Use the version of Deixis that wrote them, or a later one");
    const auto size = blank == std::string_view::npos ? std::nullopt : naturalNumber(line.substr(blank + 1));
    if (!size) return foreign();
    if (*size > bytes.size() - end - 1)
        return fail(name,
                    fmt::format("the file is cut short: its header alone is of {} bytes, found {}", *size,
                                bytes.size() - end - 1),
                    again);
    return HeaderPlace{end + 1, static_cast<std::size_t>(*size)};
}

Result<void> readArrays(const Json& header, std::string_view bytes, std::size_t begin, NetworkWeights& out) {
    std::vector<Announced> all;
    std::size_t expected = begin + checksum_bytes;
    std::set<std::string> names;
    for (const Json& one : header.at("arrays")) {
        all.push_back(announced(one));
        if (!names.insert(all.back().array.name).second)
            throw std::invalid_argument(fmt::format("array '{}' stands twice", all.back().array.name));
        expected += all.back().count * sizeOf(all.back().precision);
        if (expected > max_bytes) break;
    }
    if (bytes.size() != expected)
        return fail(out.file,
                    fmt::format("{}: found {} bytes, expected {}",
                                bytes.size() < expected ? "the file is cut short" : "the file is too long",
                                bytes.size(), expected),
                    again);
    const std::size_t content = bytes.size() - checksum_bytes;
    if (sha256Hex(bytes.substr(0, content)) != bytes.substr(content))
        return fail(out.file, "the file is damaged: its checksum is not that of its bytes", again);
    const char* at = bytes.data() + begin;
    for (Announced& one : all) {
        one.array.values.resize(one.count);
        for (float& value : one.array.values) {
            value = valueAt(at, one.precision);
            at += sizeOf(one.precision);
            if (!std::isfinite(value))
                return fail(fmt::format("{}: {}", out.file, one.array.name),
                            "found a number that is not finite", "The training has diverged: train again");
        }
        out.arrays.push_back(std::move(one.array));
    }
    return {};
}

}  // namespace

std::string encodeWeights(const NetworkWeights& weights, WeightsPrecision precision) {
    std::set<std::string> names;
    std::string numbers;
    for (const NamedArray& array : weights.arrays) {
        std::size_t count = 1;
        for (const std::size_t size : array.shape) count *= size;
        if (count != array.values.size() || !names.insert(array.name).second)
            throw std::logic_error("array '" + array.name + "' has a wrong shape or stands twice");
        for (const float value : array.values) {
            append(numbers, value, precision);
            if (!std::isfinite(valueAt(numbers.data() + numbers.size() - sizeOf(precision), precision)))
                throw std::logic_error("array '" + array.name + "' has a number that is not finite");
        }
    }
    for (const auto& [key, value] : weights.metrics)
        if (!std::isfinite(value)) throw std::logic_error("the metric '" + key + "' is not finite");
    const std::string header = headerOf(weights, precision).dump(1);
    std::string out = fmt::format("{}{} {}\n", mark, format_version, header.size());
    out += header;
    out += numbers;
    out += sha256Hex(out);
    return out;
}

Result<NetworkWeights> decodeWeights(std::string_view bytes, const std::string& name) {
    const auto place = findHeader(bytes, name);
    if (!place) return tl::unexpected(place.error());
    try {
        const Json header = Json::parse(bytes.substr(place->begin, place->size));
        NetworkWeights out = withoutArrays(header);
        out.file = name;
        const auto read = readArrays(header, bytes, place->begin + place->size, out);
        if (!read) return tl::unexpected(read.error());
        return out;
    } catch (const Json::exception& error) {
        return fail(name, fmt::format("the header of the weights is damaged: {}", error.what()), again);
    } catch (const std::invalid_argument& error) {
        return fail(name, fmt::format("the header of the weights is damaged: {}", error.what()), again);
    }
}

Result<NetworkWeights> readWeights(const std::filesystem::path& path, const std::string& architecture) {
    const auto bytes = readFile(path, max_bytes);
    if (!bytes) return tl::unexpected(bytes.error());
    auto weights = decodeWeights(*bytes, path.string());
    if (weights && weights->architecture != architecture)
        return fail(path.string(), fmt::format("these are weights of '{}', expected '{}'",
                                               weights->architecture, architecture));
    return weights;
}

Result<void> writeWeights(const std::filesystem::path& path, const NetworkWeights& weights,
                          WeightsPrecision precision) {
    return writeFile(path, encodeWeights(weights, precision));
}

}  // namespace deixis::motion
