#include "start_trainers.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace deixis::app {

namespace {

std::optional<Trainers> in_use;

/// A processor that OpenBLAS knows and whose vectors this one has; none where it has only old ones. OpenBLAS
/// takes slow kernels on processors that are newer than itself, and looks for them only when a program
/// starts.
const char* kindOfProcessor() {
#if defined(__x86_64__) && defined(__GNUC__)
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
        __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
        __builtin_cpu_supports("avx512vl"))
        return "SKYLAKEX";
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return "HASWELL";
#endif
    return nullptr;
}

}  // namespace

void useTrainers(const Trainers& trainers) {
    in_use = trainers;
}

const Trainers* trainersHere() {
    return in_use ? &*in_use : nullptr;
}

tl::unexpected<Error> startTrainers() {
    std::error_code code;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", code).parent_path() / "deixis-train";
    std::ifstream in("/proc/self/cmdline", std::ios::binary);
    std::string line{std::istreambuf_iterator<char>(in), {}};  // each argument ends with a 0
    if (!code && !line.empty() && line.back() == '\0' && std::filesystem::exists(program, code)) {
        std::vector<char*> arguments;
        for (std::size_t at = 0; at < line.size(); at = line.find('\0', at) + 1)
            arguments.push_back(&line[at]);
        arguments.push_back(nullptr);
        if (const char* const kind = kindOfProcessor()) (void)::setenv("OPENBLAS_CORETYPE", kind, 0);
        (void)::execv(program.c_str(), arguments.data());
    }
    return fail("learn", "this program was built without what trains",
                "Run scripts/install.sh learning, and build with the preset learning (docs/learning.md)");
}

}  // namespace deixis::app
