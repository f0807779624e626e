// A question on a scale while its answer is open: a rating, or the confidence in a choice.
#pragma once

#include <optional>
#include <string>

#include "session_core.hpp"

namespace deixis::studies {

struct ScaleGiven {
    int value = 0;
    double at_s = 0.0;
    const char* by = "";
};

/// Steps are answered by pressing one, or by a number key; a slider by setting and confirming it.
class ScaleAnswer {
  public:
    /// Both must outlive it.
    ScaleAnswer(SessionCore& core, const std::string& question, const Scale& scale);

    /// Also after a pause: a slider keeps its value, until it is forgotten.
    void open(const InputFrame& input, std::optional<ButtonSpec> replay, PanelPlace place);
    /// `select` and keys count from when `gate` accepts.
    [[nodiscard]] std::optional<ScaleGiven> step(const InputFrame& input, const Aim& met,
                                                 const AnswerGate& gate, bool select);
    void forget() { value_.reset(); }
    /// Shows a value as given.
    void confirm(int value);

  private:
    SessionCore& core_;
    const std::string& question_;
    const Scale& scale_;
    std::optional<int> value_{};  ///< a slider's
    std::optional<ButtonSpec> replay_{};

    [[nodiscard]] bool slider() const { return scale_.kind == ScaleKind::slider; }
    [[nodiscard]] Panel board() const;
};

}  // namespace deixis::studies
