// The script that draws the figures, made from results/page/figures; the assembler takes it in, since
// compilers are slow with so long a text.
#include "results/page/figure.hpp"

__asm__(
    ".pushsection .rodata\n"
    ".global deixis_figure_script\n"
    ".global deixis_figure_script_end\n"
    "deixis_figure_script:\n"
    ".incbin \"" DEIXIS_FIGURE_SCRIPT
    "\"\n"
    "deixis_figure_script_end:\n"
    ".byte 0\n"
    ".popsection\n");

extern "C" {
extern const char deixis_figure_script[];
extern const char deixis_figure_script_end[];
}

namespace deixis::results {

std::string_view figureScript() {
    return {deixis_figure_script, static_cast<std::size_t>(deixis_figure_script_end - deixis_figure_script)};
}

}  // namespace deixis::results
