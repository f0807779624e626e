// What a cell of a long table can say; private to its reader.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace deixis::results {

[[nodiscard]] std::string trimmed(std::string_view text);
[[nodiscard]] std::string lowered(std::string_view text);  ///< trimmed, too

// The cells of these are lowered.
[[nodiscard]] bool isMissing(const std::string& cell);
[[nodiscard]] std::optional<bool> truthOf(const std::string& cell);
[[nodiscard]] std::optional<double> numberOf(const std::string& cell);  ///< finite

enum class Attention : unsigned char { none, check, passed, failed };
[[nodiscard]] std::optional<Attention> attentionOf(const std::string& cell);

/// A flag with its reason, not lowered: empty where it is not set, `word` where it is set without a reason.
[[nodiscard]] std::string reasonOf(const std::string& cell, const char* word);

}  // namespace deixis::results
