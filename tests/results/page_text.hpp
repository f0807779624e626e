// What a page says to who reads it: its text without its marks, cells divided by "|".
#pragma once

#include <string>
#include <utility>

namespace deixis::tests {

[[nodiscard]] inline std::string pageText(const std::string& html) {
    std::string out;
    for (std::size_t at = 0; at < html.size();) {
        const char ends_at = html[at] == '<' ? '>' : ';';
        if (html[at] != '<' && html[at] != '&') {
            out += html[at++];
            continue;
        }
        const std::size_t end = html.find(ends_at, at);
        const std::string mark = html.substr(at, end - at + 1);
        for (const auto& [written, text] : {std::pair{"</td>", "|"},
                                            {"</th>", "|"},
                                            {"</tr>", "\n"},
                                            {"&#160;", "\u00a0"},
                                            {"&amp;", "&"},
                                            {"&lt;", "<"},
                                            {"&gt;", ">"},
                                            {"&quot;", "\""},
                                            {"&apos;", "'"}})
            if (mark == written) out += text;
        at = end == std::string::npos ? html.size() : end + 1;
    }
    return out;
}

}  // namespace deixis::tests
