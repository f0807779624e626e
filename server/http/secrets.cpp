#include "secrets.hpp"

#include <openssl/crypto.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "core/hash.hpp"
#include "server/http/http_server.hpp"

namespace deixis::server {

bool sameSecret(std::string_view a, std::string_view b) {
    // Of hashes, which are of one length.
    const std::string left = sha256Hex(a);
    const std::string right = sha256Hex(b);
    return CRYPTO_memcmp(left.data(), right.data(), left.size()) == 0;
}

bool canBeToken(std::string_view text) {
    constexpr std::size_t longest = 256;
    return !text.empty() && text.size() <= longest && std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-._~").find(c) != std::string_view::npos;
    });
}

std::string newToken() {
    std::array<unsigned char, 16> bytes{};
    if (::getentropy(bytes.data(), bytes.size()) != 0)
        throw std::system_error(errno, std::generic_category(), "the system's random source");
    constexpr std::string_view digits = "0123456789abcdef";
    std::string out;
    for (const unsigned char byte : bytes) {
        out += digits[byte >> 4U];
        out += digits[byte & 15U];
    }
    return out;
}

}  // namespace deixis::server
