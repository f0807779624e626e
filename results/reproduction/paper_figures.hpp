// What Deichler, Wang, Alexanderson & Beskow (2023) print of their systems, by this program's names of them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace deixis::results {

struct PaperSystem {
    std::string_view system;
    std::string_view name;                 ///< in the paper
    std::optional<double> equation_2{};    ///< mean over the grid (section 3.2)
    std::optional<double> density_rho{};   ///< Table 2
    std::optional<double> accuracy{};      ///< share of right choices (section 3.1)
    std::optional<double> naturalness{};   ///< mean opinion, 1 to 5 (section 3.1)
    std::optional<double> across{};        ///< Table 1: shares of right choices
    std::optional<double> side_by_side{};  ///< likewise
};

inline constexpr std::array paper_systems{
    PaperSystem{"gt-nn", "GT-nn", {}, -0.118, 0.856, 4.01, 0.84, 0.88},
    PaperSystem{"moglow", "MoGlow", 0.46, 0.718, 0.459, 2.61, 0.50, 0.39},
    PaperSystem{"amp-no-runtime", "AMP base no runtime", 0.56, -0.020},
    PaperSystem{"amp-base", "AMP base", 0.59, -0.128, 0.830, 2.93, 0.83, 0.84},
    PaperSystem{"amp-pfnn-1", "AMP-pfnn 1", {}, -0.043},
    PaperSystem{"amp-pfnn-3", "AMP-pfnn 3", {}, 0.149},
    PaperSystem{"amp-pfnn-8", "AMP-pfnn 8", 0.62, -0.135, 0.955, 3.57, 0.96, 0.95}};

/// Of accuracy, the only pair of systems that does not differ at alpha (section 3.1); of naturalness all do.
inline constexpr std::string_view paper_alike_a = "amp-base";
inline constexpr std::string_view paper_alike_b = "gt-nn";
inline constexpr double paper_alpha = 0.01;

[[nodiscard]] constexpr const PaperSystem* paperSystem(std::string_view system) {
    for (const PaperSystem& one : paper_systems)
        if (one.system == system) return &one;
    return nullptr;
}

}  // namespace deixis::results
