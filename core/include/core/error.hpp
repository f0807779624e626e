// Expected errors, as values. Every error that a user can see says where it is (file, line or key), what
// was found, what was expected and, if that is not obvious, how to correct it.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace deixis {

/// One problem, ready to print. `where` may be empty, "FILE", "FILE:LINE" or "FILE:LINE: key".
struct Error {
    std::string where;
    std::string message;  ///< what was found and what was expected; one sentence, no full stop needed
    std::string hint{};   ///< what the user can do about it; may be empty

    /// "WHERE: MESSAGE. HINT" on one line; servers' addresses in it without their passwords.
    [[nodiscard]] std::string text() const;
};

template <typename T>
using Result = tl::expected<T, Error>;

/// Shorthand for returning an error from a function that returns a Result.
[[nodiscard]] inline tl::unexpected<Error> fail(std::string where, std::string message,
                                                std::string hint = {}) {
    return tl::unexpected<Error>(Error{std::move(where), std::move(message), std::move(hint)});
}

}  // namespace deixis
