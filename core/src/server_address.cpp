#include "core/server_address.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"

namespace deixis {

namespace {

constexpr std::array<std::string_view, 2> server_schemes{"postgresql://", "postgres://"};
constexpr std::string_view unknown_address = "postgresql://...";
constexpr std::string_view address_ends = " \t\n\"'";

std::size_t schemeLength(std::string_view text) {
    for (const std::string_view scheme : server_schemes)
        if (text.starts_with(scheme)) return scheme.size();
    return 0;
}

bool beginsLike(std::string_view text, std::string_view word) {
    return sameLetters(text.substr(0, word.size()), word);
}

/// "scheme" of "scheme://..."; empty: there is none.
std::string_view schemeOf(std::string_view text) {
    const auto end = std::find_if_not(text.begin(), text.end(), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '+' || c == '.' || c == '-';
    });
    const auto length = static_cast<std::size_t>(end - text.begin());
    return text.substr(length).starts_with(":/") ? text.substr(0, length) : std::string_view();
}

std::string_view wordOf(std::string_view text) {
    return text.substr(0, text.find_first_of(address_ends));
}

/// What may be an address with a slip in it, or another way to write one, begins the text: how long it is,
/// and what may be shown of it.
struct Mistyped {
    std::size_t length = 0;  ///< 0: nothing of the kind
    std::string shown{};
};
Mistyped mistypedAddress(std::string_view text) {
    const std::string_view word = wordOf(text);
    constexpr std::string_view password = "password=";
    if (beginsLike(text, password))
        return {word.size(), std::string(text.substr(0, password.size())) + "..."};
    const auto colon = word.find(':');
    if (colon == std::string_view::npos) return {};
    const std::string before(word.substr(0, colon));
    if (!schemeOf(text).empty() || beginsLike(text, "postgres")) {
        // The password may hold a space or quote.
        const auto at = text.substr(0, text.find('\n')).rfind('@');
        if (at == std::string_view::npos || at < colon) return {};
        return {at + wordOf(text.substr(at)).size(), before + "://..."};
    }
    const auto at = word.rfind('@');
    if (at == std::string_view::npos || at < colon + 2) return {};
    return {word.size(), before + ":..." + std::string(word.substr(at))};
}

bool allDigits(std::string_view text) {
    return std::all_of(text.begin(), text.end(), isDigit);
}

std::string shownServerAddress(std::string_view address) {
    const std::string_view rest = address.substr(schemeLength(address));
    if (!isPlainServerAddress(address)) return std::string(unknown_address);
    const auto at = rest.find('@');
    std::string out = "postgresql://";
    std::string_view place = rest;
    if (at != std::string_view::npos) {
        const std::string_view user = rest.substr(0, at);
        out += std::string(user.substr(0, user.find(':'))) + "@";
        place = rest.substr(at + 1);
    }
    const auto question = place.find('?');
    out += place.substr(0, question);
    if (question == std::string_view::npos) return out;
    char before = '?';
    for (std::string_view left = place.substr(question + 1); !left.empty();) {
        const std::string_view parameter = left.substr(0, left.find('&'));
        left.remove_prefix(std::min(left.size(), parameter.size() + 1));
        const std::string_view name = parameter.substr(0, parameter.find('='));
        if (name != "host" && name != "hostaddr" && name != "port" && name != "user" && name != "dbname")
            continue;
        out += before + std::string(parameter);
        before = '&';
    }
    return out;
}

}  // namespace

bool isServerAddress(std::string_view text) {
    return schemeLength(text) > 0;
}

bool looksLikeServerAddress(std::string_view text) {
    if (isServerAddress(text)) return true;
    if (beginsLike(text, "postgres") && text.find(":/") != std::string_view::npos) return true;
    return !schemeOf(text).empty() && text.find('@') != std::string_view::npos;
}

bool isPlainServerAddress(std::string_view address) {
    const std::string_view rest = address.substr(schemeLength(address));
    if (rest.find_first_of(address_ends) != std::string_view::npos) return false;
    const auto at = rest.find('@');
    if (at != std::string_view::npos)
        return rest.find('@', at + 1) == std::string_view::npos && rest.find('/') > at;
    const std::string_view host = rest.substr(0, rest.find_first_of("/?"));
    const auto port = host.find(':');
    return host.starts_with('[') || port == std::string_view::npos || allDigits(host.substr(port + 1));
}

std::string withoutPasswords(std::string_view text) {
    std::string out;
    bool word_begins = true;
    while (!text.empty()) {
        if (!isServerAddress(text)) {
            if (word_begins)
                if (const Mistyped found = mistypedAddress(text); found.length > 0) {
                    out += found.shown;
                    text.remove_prefix(found.length);
                    continue;
                }
            word_begins = address_ends.find(text.front()) != std::string_view::npos || text.front() == '=';
            out += text.front();
            text.remove_prefix(1);
            continue;
        }
        // A password may hold a space or quote: an @ that comes later, before another address, may end it.
        const std::string_view nearby = text.substr(0, text.find("postgres", 1));
        const auto at = nearby.rfind('@');
        std::string_view address = text.substr(0, text.find_first_of(address_ends, at == text.npos ? 0 : at));
        while (address.ends_with(':') || address.ends_with(',') || address.ends_with('.'))
            address.remove_suffix(1);  // the sentence's
        out += shownServerAddress(address);
        text.remove_prefix(address.size());
    }
    return out;
}

}  // namespace deixis
