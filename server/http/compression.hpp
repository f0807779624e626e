// Content codings of HTTP (RFC 9110, 8.4): gzip and Brotli.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace deixis::server {

enum class Coding : unsigned char { none, gzip, brotli };
[[nodiscard]] const char* codingName(Coding coding);  ///< "gzip", "br"; of none ""

/// What an Accept-Encoding header allows; what is no such header allows none.
struct AcceptedCodings {
    bool gzip = false;
    bool brotli = false;

    [[nodiscard]] Coding smallest() const;
    [[nodiscard]] Coding quickest() const;  ///< to compress to
};
[[nodiscard]] AcceptedCodings acceptedCodings(std::string_view header);

enum class Effort : unsigned char {
    quick,     ///< for one answer: some 100 MB a second
    thorough,  ///< for what is sent many times
};
/// None where the bytes do not become fewer.
[[nodiscard]] std::optional<std::string> compressed(std::string_view bytes, Coding coding, Effort effort);

/// Whether content of that type is worth it: texts and figures are, sounds and pictures are compressed
/// already.
[[nodiscard]] bool isCompressible(std::string_view content_type);

}  // namespace deixis::server
