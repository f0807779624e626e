#include "core/error.hpp"

namespace deixis {

std::string Error::text() const {
    std::string out;
    if (!where.empty()) out += where + ": ";
    out += message;
    if (!mend.empty()) out += ". " + mend;
    return out;
}

}  // namespace deixis
