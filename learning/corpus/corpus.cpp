#include "learning/corpus/corpus.hpp"

#include <array>
#include <bit>
#include <cstdint>

#include "core/hash.hpp"

namespace deixis::learning {

namespace {

class Bytes {
  public:
    void add(std::string_view text) {
        add(static_cast<std::uint64_t>(text.size()));
        bytes_ += text;
    }
    void add(std::uint64_t number) { addLittleEndian(number, 8); }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(float number) { addLittleEndian(std::bit_cast<std::uint32_t>(number), 4); }
    [[nodiscard]] const std::string& all() const { return bytes_; }

  private:
    void addLittleEndian(std::uint64_t number, int count) {
        for (int i = 0; i < count; ++i) bytes_ += static_cast<char>((number >> (8 * i)) & 0xFFU);
    }
    std::string bytes_;
};

/// Of one take: they are hashed one by one, since a whole corpus is large.
std::string hashOf(const CorpusTake& take) {
    Bytes bytes;
    bytes.add(static_cast<std::uint64_t>(take.part));
    bytes.add(static_cast<std::uint64_t>(take.samples.size()));
    for (const float sample : take.samples) bytes.add(sample);
    bytes.add(static_cast<std::uint64_t>(take.utterance.words.size()));
    for (const SpokenWord& word : take.utterance.words) {
        bytes.add(std::string_view(word.text));
        bytes.add(word.start_s);
        bytes.add(word.end_s);
    }
    for (const motion::UpperBodyPose& pose : take.motion.frames)
        for (const double number : motion::numbersOf(pose)) bytes.add(number);
    return sha256Hex(bytes.all());
}

}  // namespace

std::string_view gesturerName(Gesturer gesturer) {
    constexpr std::array<std::string_view, 3> names{"rules A", "rules B", "person"};
    return names[static_cast<std::size_t>(gesturer)];
}

std::string corpusHash(const Corpus& corpus) {
    std::string all;
    for (const CorpusTake& take : corpus.takes) all += hashOf(take);
    return sha256Hex(all);
}

}  // namespace deixis::learning
