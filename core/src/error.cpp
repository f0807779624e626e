#include "core/error.hpp"

#include "core/server_address.hpp"

namespace deixis {

std::string Error::text() const {
    std::string out;
    if (!where.empty()) out += where + ": ";
    out += message;
    if (!hint.empty()) out += ". " + hint;
    return withoutPasswords(out);
}

}  // namespace deixis
