#include "studies/station/session_status.hpp"

#include <fmt/core.h>

namespace deixis::studies {

SessionStatus SessionStatus::with(const std::string& more) const {
    SessionStatus out = *this;
    if (!out.remark.empty() && !more.empty()) out.remark += ", ";
    out.remark += more;
    return out;
}

std::string sessionStatusText(const SessionStatus& status) {
    std::string out = status.part;
    if (status.trials > 0) out += fmt::format(" {}/{}", status.trial, status.trials);
    if (!status.remark.empty()) out += ", " + status.remark;
    return out;
}

}  // namespace deixis::studies
