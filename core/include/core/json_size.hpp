// How deep and how large a JSON text is, by its brackets and commas alone: to refuse it before anything is
// built.
#pragma once

#include <cstddef>
#include <string_view>

namespace deixis {

struct JsonSize {
    int depth = 0;           ///< most lists and objects within one another
    std::size_t values = 1;  ///< at most so many
};

/// Of any text; what is no JSON has some size, too.
[[nodiscard]] JsonSize jsonSize(std::string_view text);

}  // namespace deixis
