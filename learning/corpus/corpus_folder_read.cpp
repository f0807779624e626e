#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include "assets/joints/clip_import.hpp"
#include "assets/tables/humanoid_file.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/text.hpp"
#include "learning/corpus/corpus_folder.hpp"
#include "learning/corpus/transcript.hpp"
#include "motion/upper_body/upper_body_clip.hpp"
#include "speech/prosody/accents.hpp"
#include "speech/prosody/pitch.hpp"
#include "speech/prosody/utterance.hpp"
#include "speech/sound/wav.hpp"

namespace deixis::learning {

namespace {

namespace fs = std::filesystem;

/// The files of one name.
struct TakeFiles {
    std::string name;
    std::optional<speech::CorpusPart> part{};
    fs::path wav{}, motion{}, table{}, grid{}, text{};
};

/// By its ending, whatever the case; null for a file of another kind.
fs::path* placeOf(TakeFiles& take, std::string_view ending) {
    if (ending == ".wav") return &take.wav;
    if (ending == ".bvh" || ending == ".bvh.gz") return &take.motion;
    if (ending == ".csv") return &take.table;
    if (ending == ".textgrid") return &take.grid;
    if (ending == ".txt") return &take.text;
    return nullptr;
}

void listFiles(const fs::path& folder, std::optional<speech::CorpusPart> part,
               std::map<std::string, TakeFiles>& takes, std::vector<Error>& problems) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        if (!entry.is_regular_file(none)) continue;
        std::string name = entry.path().filename().string(), ending;
        for (const std::string_view one : {".wav", ".bvh", ".bvh.gz", ".csv", ".textgrid", ".txt"})
            if (lowerCase(name).ends_with(one)) ending = one;
        if (ending.empty()) continue;
        name.resize(name.size() - ending.size());
        TakeFiles& take = takes[name];
        if (!take.name.empty() && take.part != part) {
            problems.push_back({entry.path().string(), "found a take of this name in another part, too"});
            continue;
        }
        take.name = name;
        take.part = part;
        *placeOf(take, ending) = entry.path();
    }
}

/// What lacks of a take, in words; none of files that stand alone with other things, such as a list.
std::optional<Error> lackOf(const TakeFiles& take) {
    if (take.wav.empty())
        return Error{take.motion.string(), fmt::format("found no sound {}.wav beside it", take.name)};
    if (take.motion.empty())
        return Error{take.wav.string(), fmt::format("found no motion {}.bvh beside it", take.name)};
    if (take.table.empty() && take.grid.empty() && take.text.empty())
        return Error{take.wav.string(),
                     fmt::format("found no transcript beside it, expected {0}.csv, {0}.TextGrid or {0}.txt",
                                 take.name)};
    if (!take.table.empty() && !take.grid.empty())
        return Error{take.table.string(),
                     fmt::format("found {}.TextGrid beside it, too: expected one of them", take.name)};
    return {};
}

/// Finds words in sounds; loaded when the first text needs it.
class LazyAligner {
  public:
    Result<speech::SpokenText> align(speech::Sound sound, std::string_view text, const std::string& where) {
        {
            const std::lock_guard lock(mutex_);
            if (!loaded_) loaded_ = std::make_unique<Result<speech::Aligner>>(speech::Aligner::load());
        }
        if (!*loaded_) return tl::unexpected(loaded_->error());
        return speech::recordedText(**loaded_, std::move(sound), text, where);
    }

  private:
    std::mutex mutex_;
    std::unique_ptr<Result<speech::Aligner>> loaded_;
};

Result<std::vector<SpokenWord>> timedWords(const TakeFiles& files) {
    const fs::path& path = files.table.empty() ? files.grid : files.table;
    auto bytes = readFile(path);
    if (!bytes) return tl::unexpected(bytes.error());
    return files.table.empty() ? parseTextGrid(std::move(*bytes), path.string())
                               : parseWordTable(std::move(*bytes), path.string());
}

/// With words and times alone each word counts as one syllable.
Result<speech::SpokenText> spokenByTimes(const TakeFiles& files, speech::Sound sound) {
    auto words = timedWords(files);
    if (!words) return tl::unexpected(words.error());
    const fs::path& path = files.table.empty() ? files.grid : files.table;
    if (words->empty()) return fail(path.string(), "found no word");
    speech::SpokenText spoken = speech::recordedSound(std::move(sound));
    const double duration_s = spoken.utterance.duration_s;
    constexpr double rounding_s = 0.02;
    if (words->back().end_s > duration_s + rounding_s)
        return fail(path.string(),
                    fmt::format("found words up to {:.2f} s, but the sound is over at {:.2f} s",
                                words->back().end_s, duration_s));
    words->back().end_s = std::min(words->back().end_s, duration_s);
    std::vector<speech::Syllable> syllables;
    for (std::size_t w = 0; w < words->size(); ++w)
        syllables.push_back({(*words)[w].start_s, (*words)[w].end_s, static_cast<int>(w), true});
    spoken.utterance.accents = speech::accentsOf(syllables, spoken.pitch, spoken.loudness);
    spoken.utterance.words = std::move(*words);
    return spoken;
}

Result<motion::UpperBodyMotion> readMotion(const fs::path& path, double duration_s,
                                           const CorpusReadOptions& options) {
    assets::ImportOptions how;
    how.fps = options.fps;
    const auto imported = assets::importClip(path, how);
    if (!imported) return tl::unexpected(imported.error());
    const double found_s = imported->clip.duration_s();
    const double with_last_s = found_s + imported->clip.frame_time_s;
    if (found_s > duration_s + options.most_difference_s ||
        with_last_s < duration_s - options.most_difference_s)
        return fail(
            path.string(),
            fmt::format("found {:.2f} s of motion for {:.2f} s of sound, expected at most {} s between "
                        "them",
                        with_last_s, duration_s, options.most_difference_s),
            "Cut both to the same beginning and end; --fps says how fast frames follow");
    const auto mapping =
        assets::mapClip(path, imported->clip.skeleton, imported->humanoid ? &*imported->humanoid : nullptr);
    if (!mapping) return tl::unexpected(mapping.error());
    auto motion = motion::upperBodyOf(imported->clip, mapping->map);
    if (!motion) {
        Error error = motion.error();
        if (error.where.empty()) error.where = path.string();
        return tl::unexpected(error);
    }
    const motion::UpperBodyPose last = motion->frames.back();
    motion->frames.resize(motion::frameCountOf(duration_s), last);
    return motion;
}

Result<CorpusTake> readTake(const TakeFiles& files, LazyAligner& aligner, const CorpusReadOptions& options) {
    auto sound = speech::readWav(files.wav);
    if (!sound) return tl::unexpected(sound.error());
    if (sound->rate_hz != corpus_rate_hz) *sound = speech::resampled(*sound, corpus_rate_hz);
    CorpusTake take;
    take.name = files.name;
    take.part = files.part.value_or(speech::CorpusPart::training);
    auto motion = readMotion(files.motion, speech::durationOf(*sound), options);
    if (!motion) return tl::unexpected(motion.error());
    take.motion = std::move(*motion);
    Result<speech::SpokenText> spoken;
    if (files.table.empty() && files.grid.empty()) {
        const auto text = readFile(files.text, speech::max_text_bytes);
        if (!text) return tl::unexpected(text.error());
        take.text = trimmed(withoutByteOrderMark(*text));
        spoken = aligner.align(std::move(*sound), take.text, files.text.string());
    } else {
        spoken = spokenByTimes(files, std::move(*sound));
    }
    if (!spoken) return tl::unexpected(spoken.error());
    take.samples = std::move(spoken->sound.samples);
    take.utterance = std::move(spoken->utterance);
    if (take.text.empty())
        for (const SpokenWord& word : take.utterance.words)
            take.text += (take.text.empty() ? "" : " ") + word.text;
    return take;
}

/// Parts for takes whose folder does not say.
void partByNames(std::vector<CorpusTake>& takes) {
    using speech::CorpusPart;
    for (std::size_t i = 0; i < takes.size(); ++i) {
        if (i % 10 == 4) takes[i].part = CorpusPart::validation;
        if (i % 10 == 9) takes[i].part = CorpusPart::test;
    }
    if (takes.size() > 1 && takes.size() < 10) {
        for (CorpusTake& take : takes) take.part = CorpusPart::training;
        takes.back().part = CorpusPart::validation;
    }
}

}  // namespace

Result<CorpusFolder> readCorpusFolder(const fs::path& folder, const CorpusReadOptions& options,
                                      const std::function<void(std::size_t, std::size_t)>& progress) {
    std::error_code none;
    if (!fs::is_directory(folder, none)) return fail(folder.string(), "found no such folder");
    std::map<std::string, TakeFiles> found;
    CorpusFolder out;
    bool parted = false;
    for (const auto part :
         {speech::CorpusPart::training, speech::CorpusPart::validation, speech::CorpusPart::test}) {
        const fs::path inner = folder / speech::corpusPartName(part);
        if (!fs::is_directory(inner, none)) continue;
        parted = true;
        listFiles(inner, part, found, out.left_out);
    }
    if (!parted) listFiles(folder, {}, found, out.left_out);
    std::vector<TakeFiles> files;
    for (const auto& [name, take] : found) {
        if (take.wav.empty() && take.motion.empty()) continue;  // a list or a note
        if (auto lack = lackOf(take))
            out.left_out.push_back(std::move(*lack));
        else
            files.push_back(take);
    }

    LazyAligner aligner;
    std::vector<std::optional<Result<CorpusTake>>> takes(files.size());
    takeInTurn(
        files.size(), options.threads,
        [&](unsigned) { return [&](std::size_t i) { takes[i] = readTake(files[i], aligner, options); }; },
        [&](std::size_t done, std::size_t count) {
            if (progress) progress(done, count);
        });
    for (auto& take : takes)
        if (*take)
            out.corpus.takes.push_back(std::move(**take));
        else
            out.left_out.push_back(take->error());
    if (out.corpus.takes.empty()) {
        if (!out.left_out.empty()) return tl::unexpected(out.left_out.front());
        return fail(folder.string(),
                    "found no take, expected NAME.wav, NAME.bvh and a transcript of the same name");
    }
    if (!parted) partByNames(out.corpus.takes);
    return out;
}

}  // namespace deixis::learning
