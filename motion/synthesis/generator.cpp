#include "motion/synthesis/generator.hpp"

#include <array>

#include "systems.hpp"

namespace deixis::motion {

namespace {

struct System {
    std::string_view name;
    std::unique_ptr<Generator> (*make)(const PointingBody&, const DemonstrationParameters&);
};
constexpr std::array<System, 5> systems{{{"demonstration-nn", makeDemonstrationNn},
                                         {"direct", makeDirect},
                                         {"stiff", makeStiff},
                                         {"drifting", makeDrifting},
                                         {"gp", makeGp}}};

}  // namespace

const std::vector<std::string>& generatorNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const System& system : systems) out.emplace_back(system.name);
        return out;
    }();
    return names;
}

Result<std::unique_ptr<Generator>> makeGenerator(std::string_view name, const Skeleton& avatar,
                                                 const DemonstrationParameters& parameters) {
    for (const System& system : systems) {
        if (system.name != name) continue;
        const auto body = makePointingBody(avatar);
        if (!body) return tl::unexpected(body.error());
        return system.make(*body, parameters);
    }
    if (name == "moglow")
        return fail(
            "", "the system 'moglow' is learned, and no weights of it come with the program",
            "Train it (docs/systems.md, moglow) and give its file: deixis generate moglow --weights FILE");
    std::string known;
    for (const System& system : systems) known += (known.empty() ? "" : ", ") + std::string(system.name);
    return fail("", "unknown system '" + std::string(name) + "'", "Expected one of: " + known);
}

}  // namespace deixis::motion
