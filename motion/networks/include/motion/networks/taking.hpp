// Reading many values that may each be missing: they are taken one after another, and the first problem is
// kept.
#pragma once

#include <optional>
#include <utility>

#include "core/error.hpp"

namespace deixis::motion {

class Taking {
  public:
    /// `to` stays as it is where `read` is a problem.
    template <typename To, typename Read>
    void operator()(To& to, Result<Read> read) {
        if (read)
            to = std::move(*read);
        else if (!problem_)
            problem_ = std::move(read.error());
    }
    [[nodiscard]] const std::optional<Error>& problem() const { return problem_; }

  private:
    std::optional<Error> problem_;
};

}  // namespace deixis::motion
