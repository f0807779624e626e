#include "blas_kernels.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace deixis::app {

namespace {

/// A processor that OpenBLAS knows and whose vectors this one has; none where it has only old ones.
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

void restartWithFastBlas() {
    constexpr const char* variable = "OPENBLAS_CORETYPE";
    const char* const kind = kindOfProcessor();
    if (kind == nullptr || std::getenv(variable) != nullptr) return;
    std::ifstream in("/proc/self/cmdline", std::ios::binary);
    std::string line{std::istreambuf_iterator<char>(in), {}};  // each argument ends with a 0
    if (line.empty() || line.back() != '\0') return;
    std::vector<char*> arguments;
    for (std::size_t at = 0; at < line.size(); at = line.find('\0', at) + 1) arguments.push_back(&line[at]);
    arguments.push_back(nullptr);
    if (::setenv(variable, kind, 0) == 0) (void)::execv("/proc/self/exe", arguments.data());
}

}  // namespace deixis::app
