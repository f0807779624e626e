#include "core/json_size.hpp"

#include <algorithm>

namespace deixis {

JsonSize jsonSize(std::string_view text) {
    JsonSize out;
    int depth = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                in_string = false;
        } else if (c == '"') {
            in_string = true;
        } else if (c == '[' || c == '{') {
            out.depth = std::max(out.depth, ++depth);
            ++out.values;
        } else if (c == ']' || c == '}') {
            --depth;
        } else if (c == ',') {
            ++out.values;
        }
    }
    return out;
}

}  // namespace deixis
