// What a page's figures are told to draw.
#pragma once

#include <doctest/doctest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace deixis::tests {

/// The Vega-Lite specifications of a page by their figures' ids.
inline std::map<std::string, nlohmann::json> specificationsOf(const std::string& page) {
    std::map<std::string, nlohmann::json> found;
    const std::string begin = "<script type=\"application/json\">";
    std::size_t at = 0;
    while ((at = page.find("\n<figure id=\"", at)) != std::string::npos) {
        const std::size_t name = at + std::string("\n<figure id=\"").size();
        const std::size_t from = page.find(begin, at) + begin.size();
        const std::size_t to = page.find("</script>", from);
        REQUIRE(to != std::string::npos);
        found[page.substr(name, page.find('"', name) - name)] =
            nlohmann::json::parse(page.substr(from, to - from));
        at = to;
    }
    return found;
}

/// The values of the layers whose data have such a field, one after another.
inline std::vector<nlohmann::json> valuesWith(const nlohmann::json& spec, const std::string& field) {
    std::vector<nlohmann::json> found;
    for (const nlohmann::json& layer : spec["layer"])
        if (layer.contains("data"))
            for (const nlohmann::json& value : layer["data"]["values"])
                if (value.contains(field)) found.push_back(value);
    return found;
}

}  // namespace deixis::tests
