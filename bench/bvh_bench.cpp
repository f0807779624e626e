// Reading a BVH clip: the numbers alone, all of it, and from a file; against readers that only take the
// numbers.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <charconv>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "assets/joints/bvh.hpp"
#include "assets/joints/clip_import.hpp"
#include "assets/joints/decimal.hpp"
#include "core/files.hpp"
#include "inputs.hpp"

namespace {

using namespace deixis;

/// A session's gesture over and over, about 90 s: more than a processor keeps in its caches.
const std::string& clipText() {
    static const std::string text = [] {
        motion::Clip clip = bench::pointingClip();
        const auto gesture = clip.frames;
        for (int i = 1; i < 30; ++i) clip.frames.insert(clip.frames.end(), gesture.begin(), gesture.end());
        return assets::writeBvh(clip);
    }();
    return text;
}

/// The lines after "Frame Time": one number per channel and frame.
std::string motionNumbers() {
    const std::string& text = clipText();
    return text.substr(text.find('\n', text.find("Frame Time:")) + 1);
}

void setBytes(benchmark::State& state, std::size_t bytes) {
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(bytes));
}

/// Every number by `next(begin, end, value)`, which returns where it ends.
template <typename Next>
void readNumbers(benchmark::State& state, const Next& next) {
    const std::string numbers = motionNumbers();
    for (auto _ : state) {
        double sum = 0.0;
        const char* end = numbers.data() + numbers.size();
        for (const char* at = numbers.data(); at < end; ++at) {
            double value = 0.0;
            at = next(at, end, value);
            if (at == nullptr) return state.SkipWithError("found no number");
            sum += value;
        }
        benchmark::DoNotOptimize(sum);
    }
    setBytes(state, numbers.size());
}

void numbers(benchmark::State& state) {
    readNumbers(state, assets::readDecimal);
}
BENCHMARK(numbers)->Name("bvh/numbers")->Unit(benchmark::kMillisecond);

void numbersByFromChars(benchmark::State& state) {
    readNumbers(state, [](const char* begin, const char* end, double& value) {
        return std::from_chars(begin, end, value).ptr;
    });
}
BENCHMARK(numbersByFromChars)->Name("bvh/peer_from_chars")->Unit(benchmark::kMillisecond);

void parse(benchmark::State& state) {
    const std::string& text = clipText();
    for (auto _ : state) {
        auto file = assets::parseBvh(text, "generated");
        if (!file) return state.SkipWithError(file.error().text().c_str());
        benchmark::DoNotOptimize(file->clip.frames.data());
    }
    setBytes(state, text.size());
}
BENCHMARK(parse)->Name("bvh/read")->Unit(benchmark::kMillisecond);

void importFile(benchmark::State& state) {
    const auto path =
        std::filesystem::temp_directory_path() / ("deixis_bench_" + std::to_string(::getpid()) + ".bvh");
    if (!writeFile(path, clipText())) return state.SkipWithError("the file could not be written");
    for (auto _ : state) {
        auto file = assets::importClip(path);
        if (!file) {
            state.SkipWithError(file.error().text().c_str());
            break;
        }
        benchmark::DoNotOptimize(file->clip.frames.data());
    }
    setBytes(state, clipText().size());
    std::filesystem::remove(path);
}
BENCHMARK(importFile)->Name("bvh/import_file")->Unit(benchmark::kMillisecond);

void stream(benchmark::State& state) {
    const std::string numbers = motionNumbers();
    std::size_t count = 0;
    for (auto _ : state) {
        std::istringstream in(numbers);
        count = 0;
        for (double number = 0.0; in >> number;) {
            benchmark::DoNotOptimize(number);
            ++count;
        }
    }
    if (count == 0) return state.SkipWithError("the peer read no numbers");
    setBytes(state, numbers.size());
}
BENCHMARK(stream)->Name("bvh/peer_istringstream")->Unit(benchmark::kMillisecond);

}  // namespace
