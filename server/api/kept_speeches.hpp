// Speeches that can be asked for again by their id.
#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <string>

#include "speech/prosody/utterance.hpp"

namespace deixis::server {

struct KeptSpeech {
    std::string id;              ///< of its content: the same sound with the same words has the same id
    std::string asked;           ///< what it was made from, in any form; empty: a recording
    std::string language{"en"};  ///< BCP 47
    speech::SpokenText spoken;
    std::string wav;  ///< the sound as a file

    [[nodiscard]] std::size_t bytes() const;
};

/// `asked` and `language` as in KeptSpeech.
[[nodiscard]] std::shared_ptr<const KeptSpeech> keptSpeech(speech::SpokenText spoken, std::string asked,
                                                           std::string language = "en");

/// Of several threads. Above `most_bytes` the ones that were used least recently are forgotten, but never the
/// newest.
class KeptSpeeches {
  public:
    explicit KeptSpeeches(std::size_t most_bytes) : most_bytes_(most_bytes) {}

    void keep(std::shared_ptr<const KeptSpeech> speech);
    /// Null where there is none, or none any more.
    [[nodiscard]] std::shared_ptr<const KeptSpeech> find(const std::string& id);
    [[nodiscard]] std::shared_ptr<const KeptSpeech> findAsked(const std::string& asked);
    [[nodiscard]] std::size_t mostBytes() const { return most_bytes_; }

  private:
    template <class Is>
    std::shared_ptr<const KeptSpeech> findWhere(Is is);

    std::size_t most_bytes_;
    std::mutex mutex_;
    std::list<std::shared_ptr<const KeptSpeech>> newest_first_;
};

}  // namespace deixis::server
