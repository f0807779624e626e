// Texts that millions of values share: names of participants, systems, targets.
#pragma once

#include <fmt/format.h>

#include <compare>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace deixis {

/// A text that is kept once, for as long as the program runs: copying it and asking whether two are equal
/// cost as little as with a pointer. For names that occur again and again, not for texts that are seen once.
/// Making one may be done from any thread.
class Name {
  public:
    Name() = default;  ///< empty
    // Texts and names stand for each other, so that tables of names are read and filled like tables of texts.
    Name(std::string_view text);                                     // NOLINT(google-explicit-constructor)
    Name(const std::string& text) : Name(std::string_view(text)) {}  // NOLINT(google-explicit-constructor)
    Name(const char* text) : Name(std::string_view(text)) {}         // NOLINT(google-explicit-constructor)

    [[nodiscard]] const std::string& text() const { return text_ != nullptr ? *text_ : emptyText(); }
    operator const std::string&() const { return text(); }  // NOLINT(google-explicit-constructor)
    [[nodiscard]] bool empty() const { return text_ == nullptr; }

    friend bool operator==(Name a, Name b) { return a.text_ == b.text_; }
    friend bool operator==(Name a, std::string_view b) { return a.text() == b; }
    friend bool operator==(Name a, const std::string& b) { return a.text() == b; }
    friend bool operator==(Name a, const char* b) { return a.text() == b; }
    /// As the texts.
    friend std::strong_ordering operator<=>(Name a, Name b) {
        return a.text_ == b.text_ ? std::strong_ordering::equal : a.text().compare(b.text()) <=> 0;
    }

  private:
    friend std::hash<Name>;
    static const std::string& emptyText();

    const std::string* text_ = nullptr;  ///< null: empty
};

}  // namespace deixis

template <>
struct std::hash<deixis::Name> {
    std::size_t operator()(deixis::Name name) const noexcept {
        return std::hash<const std::string*>()(name.text_);
    }
};

template <>
struct fmt::formatter<deixis::Name> : fmt::formatter<std::string_view> {
    template <typename Context>
    auto format(deixis::Name name, Context& context) const {
        return fmt::formatter<std::string_view>::format(name.text(), context);
    }
};
