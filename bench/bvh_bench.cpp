// Reading a BVH clip, against a reader that only takes the same numbers from a string stream.
#include <benchmark/benchmark.h>

#include <sstream>
#include <string>
#include <vector>

#include "assets/bvh.hpp"
#include "inputs.hpp"

namespace {

using namespace deixis;

const std::string& clipText() {
    static const std::string text = assets::writeBvh(bench::pointingClip());
    return text;
}

/// The lines after "Frame Time": one number per channel and frame.
std::string motionNumbers(const std::string& text) {
    return text.substr(text.find('\n', text.find("Frame Time:")) + 1);
}

std::vector<double> streamedNumbers(const std::string& text) {
    std::istringstream in(text);
    std::vector<double> numbers;
    for (double number = 0.0; in >> number;) numbers.push_back(number);
    return numbers;
}

void parse(benchmark::State& state) {
    const std::string& text = clipText();
    for (auto _ : state) {
        auto file = assets::parseBvh(text, "generated");
        if (!file) return state.SkipWithError(file.error().text().c_str());
        benchmark::DoNotOptimize(file->clip.frames.data());
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(text.size()));
}
BENCHMARK(parse)->Name("bvh/read")->Unit(benchmark::kMillisecond);

void stream(benchmark::State& state) {
    const std::string numbers = motionNumbers(clipText());
    const std::size_t frames = bench::pointingClip().frames.size();
    const std::size_t read = streamedNumbers(numbers).size();
    if (read == 0 || read % frames != 0) return state.SkipWithError("the peer did not read whole frames");
    for (auto _ : state) benchmark::DoNotOptimize(streamedNumbers(numbers).data());
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(numbers.size()));
}
BENCHMARK(stream)->Name("bvh/peer_istringstream")->Unit(benchmark::kMillisecond);

}  // namespace
