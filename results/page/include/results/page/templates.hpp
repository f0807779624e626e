// The HTML templates: the files of results/page/templates, which are compiled into the program.
#pragma once

#include <string>
#include <string_view>

#include "results/tables/table.hpp"

namespace deixis::results {

/// The text of one of the files; throws std::logic_error if there is none of that name.
[[nodiscard]] std::string templateText(std::string_view file);

/// A Mustache template with its values: {{texts}} are escaped, {{{HTML}}} is not. Numbers stand as JSON has
/// them; what is empty or null is not there.
[[nodiscard]] std::string filled(std::string_view file, const Json& values);

/// Safe as text and as an attribute's value, in HTML and XML.
[[nodiscard]] std::string escapeHtml(std::string_view text);

/// A text in bold.
[[nodiscard]] std::string strongHtml(const std::string& text);

}  // namespace deixis::results
