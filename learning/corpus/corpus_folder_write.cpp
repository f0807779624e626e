#include <fmt/format.h>

#include "assets/joints/bvh.hpp"
#include "core/csv.hpp"
#include "core/files.hpp"
#include "learning/corpus/corpus_folder.hpp"
#include "learning/corpus/transcript.hpp"
#include "motion/upper_body/upper_body_clip.hpp"
#include "speech/sound/wav.hpp"

namespace deixis::learning {

namespace {

/// The last frame is at the sound's end or behind it.
std::string bvhOf(const CorpusTake& take) {
    motion::UpperBodyMotion motion = take.motion;
    const double last_s = static_cast<double>(motion.frames.size() - 1) * motion::upper_body_frame_time_s;
    if (last_s < take.utterance.duration_s) motion.frames.push_back(motion.frames.back());
    return assets::writeBvh(motion::avatarClip(motion));
}

Result<void> writeTake(const CorpusTake& take, const std::filesystem::path& stem) {
    const auto file = [&](const char* ending) {
        std::filesystem::path path = stem;
        path += ending;
        return path;
    };
    const std::string wav = speech::wavBytes({corpus_rate_hz, take.samples});
    for (const auto& [path, bytes] : {std::pair{file(".wav"), wav},
                                      {file(".bvh"), bvhOf(take)},
                                      {file(".csv"), wordTable(take.utterance.words)},
                                      {file(".spoken"), take.text + '\n'}})
        if (auto written = writeFileUnsynced(path, bytes); !written) return written;
    return {};
}

}  // namespace

Result<void> writeCorpusFolder(const Corpus& corpus, const std::filesystem::path& folder) {
    std::string list = "name,part,gestures,voice,duration_s,synthetic,text\n";
    for (const CorpusTake& take : corpus.takes) {
        const std::string part(speech::corpusPartName(take.part));
        if (auto written = writeTake(take, folder / part / take.name); !written) return written;
        list += fmt::format("{},{},{},{},{:.4f},{},{}\n", csvField(take.name), part,
                            gesturerName(take.gesturer), csvField(take.voice), take.utterance.duration_s,
                            corpus.synthetic ? "yes" : "no", csvField(take.text));
    }
    return writeFile(folder / "corpus.csv", list);
}

}  // namespace deixis::learning
