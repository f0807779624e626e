// What a trained network is at run time: the file that holds its weights, and the layers that they are of, in
// Eigen.
//
// A file of weights is, in this order: a line "deixis-weights 1 BYTES", where 1 is the format's version;
// BYTES bytes of JSON, the header; the arrays' numbers, little-endian, row by row, in the header's order
// without gaps; the SHA-256 of all that, 64 hexadecimal digits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/error.hpp"

namespace deixis::motion {

struct NamedArray {
    std::string name;
    std::vector<std::size_t> shape;
    std::vector<float> values;  ///< row by row; as many as the shape's sizes multiplied
};

using NetworkSetting = std::variant<double, std::string>;

struct NetworkWeights {
    std::string file;          ///< where it was read, for errors; is not written
    std::string architecture;  ///< such as "moglow"
    std::map<std::string, NetworkSetting> settings;
    std::string training_data_sha256;
    std::uint64_t seed = 0;
    std::string program_version;
    std::string commit;
    std::map<std::string, double> metrics;
    bool synthetic = true;  ///< the training data were
    std::vector<NamedArray> arrays;

    /// A setting that is a number, or a text. Fails, naming the file and the key, where there is none such.
    [[nodiscard]] Result<double> number(const std::string& key) const;
    [[nodiscard]] Result<std::string> text(const std::string& key) const;
    /// Fails where the setting "features" names others than those of an avatar's poses: the weights were
    /// trained for another avatar.
    [[nodiscard]] Result<void> checkFeatures(const std::string& of_avatar) const;
    /// A whole number in [low, high].
    [[nodiscard]] Result<int> count(const std::string& key, int low, int high) const;
    /// Fails, naming the file and the array, where there is none or its shape is another.
    [[nodiscard]] Result<const NamedArray*> array(const std::string& name,
                                                  const std::vector<std::size_t>& shape) const;
};

enum class WeightsPrecision : unsigned char { float32, float16 };

/// The file's bytes. All numbers, and the metrics, must be finite in that precision, names unique and shapes
/// right; else it throws, as that is an error of the program.
[[nodiscard]] std::string encodeWeights(const NetworkWeights& weights, WeightsPrecision precision);

/// Rejects, each with a message of its own: what is no file of weights, one of a newer format, one that is
/// cut short or has bytes behind its end, one whose checksum is wrong, a header that lacks a key, a number
/// that is not finite. `name` stands for the file.
[[nodiscard]] Result<NetworkWeights> decodeWeights(std::string_view bytes, const std::string& name);

/// Likewise from a file, and rejects one of another architecture.
[[nodiscard]] Result<NetworkWeights> readWeights(const std::filesystem::path& path,
                                                 const std::string& architecture);
/// A reader sees the old file or the new one, never a half.
[[nodiscard]] Result<void> writeWeights(const std::filesystem::path& path, const NetworkWeights& weights,
                                        WeightsPrecision precision);

}  // namespace deixis::motion
