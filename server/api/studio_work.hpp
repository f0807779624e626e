// What the routes share: the parts of the studio, and the speeches that are kept.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kept_speeches.hpp"
#include "motion/skeleton/clip.hpp"
#include "own_motions.hpp"
#include "own_rules.hpp"
#include "server/api/studio_api.hpp"
#include "speech/alignment/aligner.hpp"

namespace deixis::server {

class StudioWork {
  public:
    explicit StudioWork(StudioParts parts);

    [[nodiscard]] const StudioParts& parts() const { return parts_; }

    /// Null where nothing is kept on the disk.
    [[nodiscard]] const KeptFolder* folder() const { return parts_.folder ? &*parts_.folder : nullptr; }
    /// What people added, as the disk has it now; none without a folder.
    [[nodiscard]] OwnMotions ownMotions() const;
    [[nodiscard]] OwnRules ownRules() const;
    /// Of all motions: those that ship, and those that were added.
    [[nodiscard]] std::vector<std::string> motionIds() const;

    /// A clip on referenceHumanoid() as the avatar that is drawn plays it.
    [[nodiscard]] motion::Clip onAvatar(motion::Clip clip) const;

    using Speech = tl::expected<std::shared_ptr<const KeptSpeech>, Refusal>;
    /// Spoken by that voice, or the one that is kept.
    Speech speak(const std::string& text, const std::string& voice);
    /// A recording (WAV) of that text.
    Speech record(std::string_view wav, const std::string& text);
    /// `field` names the id in the refusal.
    Speech find(const std::string& id, const std::optional<std::string>& field);

  private:
    /// Loaded when it is first needed; the refusal says why it cannot be.
    tl::expected<speech::Aligner*, Refusal> aligner();

    StudioParts parts_;
    KeptSpeeches speeches_;
    std::mutex aligner_mutex_;
    std::optional<speech::Aligner> aligner_;
};

[[nodiscard]] Route healthRoute(const std::shared_ptr<StudioWork>& work);
[[nodiscard]] std::vector<Route> speechRoutes(const std::shared_ptr<StudioWork>& work);
[[nodiscard]] Route generateRoute(const std::shared_ptr<StudioWork>& work);
[[nodiscard]] std::vector<Route> libraryRoutes(const std::shared_ptr<StudioWork>& work);
[[nodiscard]] std::vector<Route> ruleRoutes(const std::shared_ptr<StudioWork>& work);
[[nodiscard]] std::vector<Route> projectRoutes(const std::shared_ptr<StudioWork>& work);
[[nodiscard]] Route readRoute();
[[nodiscard]] Route pointRoute(const std::shared_ptr<StudioWork>& work);
[[nodiscard]] std::vector<Route> clipRoutes(const std::shared_ptr<StudioWork>& work);

/// Parts that several routes take or answer.
[[nodiscard]] ShapeField textField(bool required);
[[nodiscard]] ShapeField voiceField(const StudioWork& work);
[[nodiscard]] std::vector<ShapeField> speechFields();
[[nodiscard]] nlohmann::json speechJson(const KeptSpeech& speech);

}  // namespace deixis::server
