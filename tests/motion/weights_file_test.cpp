#include "motion/networks/weights_file.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include "core/files.hpp"
#include "core/hash.hpp"

using namespace deixis;
using namespace deixis::motion;

namespace {

NetworkWeights someWeights() {
    NetworkWeights out;
    out.architecture = "moglow";
    out.settings = {{"steps", 2.0}, {"rate", 0.001}, {"joints", std::string("spine head")}};
    out.training_data_sha256 = sha256Hex("clips");
    out.seed = 18446744073709551615U;
    out.program_version = "0.1.0";
    out.commit = "0123abc";
    out.metrics = {{"validation_reward", 0.46}, {"end_hand_height_m", 0.96}};
    out.synthetic = true;
    out.arrays = {{"a.weight", {2, 3}, {1.0F, -2.5F, 0.1F, 65504.0F, -1e-3F, 0.0F}}, {"a.bias", {1}, {0.3F}}};
    return out;
}

std::string errorOf(std::string_view bytes) {
    const auto read = decodeWeights(bytes, "w.bin");
    REQUIRE_FALSE(read.has_value());
    return read.error().text();
}

bool contains(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

/// The bytes with another header of the same or another length, and a checksum that is right.
std::string withHeader(const std::string& header) {
    std::string out = "deixis-weights 1 " + std::to_string(header.size()) + "\n" + header;
    return out + sha256Hex(out);
}

}  // namespace

TEST_SUITE("motion/weights_file") {
    TEST_CASE("what is written is read again, number by number in float32") {
        const NetworkWeights written = someWeights();
        const auto read = decodeWeights(encodeWeights(written, WeightsPrecision::float32), "w.bin");
        REQUIRE(read.has_value());
        CHECK(read->architecture == written.architecture);
        CHECK(read->settings == written.settings);
        CHECK(read->training_data_sha256 == written.training_data_sha256);
        CHECK(read->seed == written.seed);
        CHECK(read->program_version == written.program_version);
        CHECK(read->commit == written.commit);
        CHECK(read->metrics == written.metrics);
        CHECK(read->synthetic);
        REQUIRE(read->arrays.size() == 2);
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK(read->arrays[i].name == written.arrays[i].name);
            CHECK(read->arrays[i].shape == written.arrays[i].shape);
            CHECK(read->arrays[i].values == written.arrays[i].values);
        }
    }

    TEST_CASE("in float16 numbers keep eleven binary digits, in half of the bytes") {
        const NetworkWeights written = someWeights();
        const std::string wide = encodeWeights(written, WeightsPrecision::float32);
        const std::string narrow = encodeWeights(written, WeightsPrecision::float16);
        CHECK(wide.size() - narrow.size() == 7 * 2);
        const auto read = decodeWeights(narrow, "w.bin");
        REQUIRE(read.has_value());
        for (std::size_t i = 0; i < 6; ++i) {
            const float was = written.arrays[0].values[i];
            CHECK(std::abs(read->arrays[0].values[i] - was) <= std::abs(was) * std::ldexp(1.0F, -11));
        }
        // IEEE 754 binary16: 0.1 is 0x2E66, that is 1.1001100110 (binary) / 16.
        CHECK(read->arrays[0].values[2] == 0.0999755859375F);
    }

    TEST_CASE("a file is read by its architecture alone") {
        const auto path =
            std::filesystem::temp_directory_path() / ("deixis-weights-" + std::to_string(getpid()));
        REQUIRE(writeWeights(path, someWeights(), WeightsPrecision::float32).has_value());
        CHECK(readWeights(path, "moglow").has_value());
        const auto other = readWeights(path, "amp-base");
        REQUIRE_FALSE(other.has_value());
        CHECK(other.error().where == path.string());
        CHECK(contains(other.error().message, "'moglow'"));
        CHECK(contains(other.error().message, "'amp-base'"));
        std::filesystem::remove(path);
        CHECK(readWeights(path, "moglow").error().where == path.string());
    }

    TEST_CASE("a foreign file is rejected as one") {
        for (const std::string bytes : {"", "HIERARCHY\nROOT Hips\n", "deixis-weights", "deixis-weights \n",
                                        "deixis-weights one 20\n{}", "deixis-weights 0 2\n{}"}) {
            CAPTURE(bytes);
            CHECK(contains(errorOf(bytes), "no file of weights"));
        }
        CHECK(contains(errorOf("deixis-weights 1\n{}"), "no file of weights"));
    }

    TEST_CASE("a file of a newer format is rejected with both formats") {
        std::string bytes = encodeWeights(someWeights(), WeightsPrecision::float32);
        bytes.replace(0, 16, "deixis-weights 2");
        CHECK(contains(errorOf(bytes), "in format 2, this program reads 1"));
    }

    TEST_CASE("a file that is cut short is rejected wherever it is cut, and one with more bytes too") {
        const std::string bytes = encodeWeights(someWeights(), WeightsPrecision::float32);
        for (std::size_t size = 64; size < bytes.size(); ++size)
            CHECK(contains(errorOf(std::string_view(bytes).substr(0, size)), "cut short"));
        CHECK(contains(errorOf(bytes + "x"), "too long"));
    }

    TEST_CASE("a bit that has changed anywhere behind the first line is found") {
        const std::string bytes = encodeWeights(someWeights(), WeightsPrecision::float32);
        for (std::size_t at = bytes.find('\n') + 1; at < bytes.size(); ++at) {
            std::string damaged = bytes;
            damaged[at] = static_cast<char>(damaged[at] ^ 4);
            CHECK_FALSE(decodeWeights(damaged, "w.bin").has_value());
        }
        std::string damaged = bytes;
        damaged[bytes.size() - 70] ^= 1;
        CHECK(contains(errorOf(damaged), "checksum"));
    }

    TEST_CASE("a header without a key, or with a wrong one, is rejected by the key") {
        CHECK(contains(errorOf(withHeader("{}")), "architecture"));
        CHECK(contains(errorOf(withHeader("[1")), "header of the weights is damaged"));
        const std::string start =
            R"({"architecture":"a","settings":{},"training_data_sha256":"","seed":1,"program_version":"",)"
            R"("commit":"","metrics":{},"synthetic":true,"arrays":)";
        CHECK(decodeWeights(withHeader(start + "[]}"), "w.bin").has_value());
        CHECK(contains(errorOf(withHeader(start + R"([{"name":"w","type":"int8","shape":[1]}]})")), "int8"));
        CHECK(
            contains(errorOf(withHeader(start + R"([{"name":"w","type":"float32","shape":[0]}]})")), "'w'"));
        CHECK(contains(
            errorOf(withHeader(
                start + R"([{"name":"w","type":"float32","shape":[4294967296,4294967296,4294967296]}]})")),
            "'w'"));
        CHECK(
            contains(errorOf(withHeader(start + R"([{"name":"w","type":"float32","shape":[1073741824]}]})")),
                     "cut short"));
    }

    TEST_CASE("a number that is not finite is rejected by its array, and never written") {
        NetworkWeights weights = someWeights();
        weights.arrays[1].values[0] = std::numeric_limits<float>::quiet_NaN();
        CHECK_THROWS(static_cast<void>(encodeWeights(weights, WeightsPrecision::float32)));
        weights.arrays[1].values[0] = 1e6F;  // beyond 65504, the largest of float16
        CHECK_THROWS(static_cast<void>(encodeWeights(weights, WeightsPrecision::float16)));
        weights.arrays[1].values[0] = 1.0F;
        weights.metrics["loss"] = std::numeric_limits<double>::infinity();
        CHECK_THROWS((void)encodeWeights(weights, WeightsPrecision::float32));
        weights.metrics.clear();
        std::string bytes = encodeWeights(weights, WeightsPrecision::float32);
        bytes.resize(bytes.size() - 64);
        bytes.replace(bytes.size() - 4, 4, std::string("\0\0\x80\x7f", 4));  // infinity
        CHECK(contains(errorOf(bytes + sha256Hex(bytes)), "a.bias"));
    }

    TEST_CASE("settings and arrays that are missing or of another kind are named with the file") {
        NetworkWeights weights = someWeights();
        weights.file = "w.bin";
        CHECK(weights.number("rate").value() == 0.001);
        CHECK(weights.text("joints").value() == "spine head");
        CHECK(weights.count("steps", 1, 16).value() == 2);
        CHECK(weights.number("hidden").error().text().starts_with("w.bin: settings.hidden: found none"));
        CHECK(contains(weights.number("joints").error().text(), "spine head"));
        CHECK(contains(weights.text("rate").error().text(), "expected a text"));
        CHECK(contains(weights.count("steps", 3, 16).error().text(),
                       "found 2, expected a whole number from 3"));
        CHECK(contains(weights.count("rate", 0, 16).error().text(), "found 0.001"));
        CHECK(weights.array("a.weight", {2, 3}).has_value());
        CHECK(contains(weights.array("a.weight", {3, 2}).error().text(), "found an array of shape [2, 3]"));
        CHECK(contains(weights.array("b", {1}).error().text(), "w.bin: b: the array is missing"));
    }
}
