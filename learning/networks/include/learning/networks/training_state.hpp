// What a training goes on from after an interruption: a file FILE.training beside its weights, FILE.
#pragma once

#include <torch/torch.h>

#include <filesystem>
#include <functional>
#include <string>

#include "core/error.hpp"

namespace deixis::learning {

class TrainingState {
  public:
    /// `data` names in errors what was trained on, such as "demonstrations".
    TrainingState(const std::filesystem::path& weights, std::string data);

    /// Whether there was one; `read` is then given it, and may throw where something is missing in it.
    /// Errors: one of another identity, and one that is damaged.
    [[nodiscard]] Result<bool> load(const std::string& identity,
                                    const std::function<void(torch::serialize::InputArchive&)>& read) const;
    /// A reader sees the old state or the new one, never a half.
    [[nodiscard]] Result<void> save(const std::string& identity,
                                    const std::function<void(torch::serialize::OutputArchive&)>& write) const;
    /// Where there is one.
    void remove() const;

  private:
    std::filesystem::path file_;
    std::string data_;
};

/// A training whose loss is no number any more. `kept` are the weights that the file has, such as "update
/// 30"; empty: there are none yet.
[[nodiscard]] Error hasDiverged(const std::filesystem::path& weights, int update, const std::string& loss,
                                const std::string& kept);

}  // namespace deixis::learning
