// Running a program without a shell: bytes in, bytes out, and no longer than it may take.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace deixis::speech {

struct ProgramOutput {
    std::string out;
    std::string err;  ///< the last 4 KB at the most
    int status = 0;   ///< as waitpid() tells it
};

/// Errors, with `where` before them: it cannot be started, it takes longer than `timeout`, it writes more
/// than `max_bytes`. In the last two it is killed with its process group.
[[nodiscard]] Result<ProgramOutput> runProgram(const std::vector<std::string>& command,
                                               std::string_view input, std::chrono::milliseconds timeout,
                                               std::size_t max_bytes, const std::string& where);

}  // namespace deixis::speech
