#include "motion/synthesis/generator.hpp"

#include <fmt/format.h>

#include <algorithm>
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
constexpr System gt_nn{"gt-nn", makeGtNn};

}  // namespace

const std::vector<std::string>& generatorNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out;
        for (const System& system : systems) out.emplace_back(system.name);
        return out;
    }();
    return names;
}

const std::vector<std::string>& learnedNames() {
    static const std::vector<std::string> names{"moglow",     "amp-no-runtime", "amp-base", "amp-pfnn-1",
                                                "amp-pfnn-3", "amp-pfnn-8",     "flow"};
    return names;
}

const std::vector<std::string>& systemNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> out = generatorNames();
        out.emplace_back(gt_nn.name);
        out.insert(out.end(), learnedNames().begin(), learnedNames().end());
        return out;
    }();
    return names;
}

Result<std::unique_ptr<Generator>> makeGenerator(std::string_view name, const Skeleton& avatar,
                                                 const DemonstrationParameters& parameters) {
    const auto is_it = [name](const System& system) { return system.name == name; };
    const auto* found = is_it(gt_nn) ? &gt_nn : std::find_if(systems.begin(), systems.end(), is_it);
    if (found != systems.end()) {
        const auto body = makePointingBody(avatar);
        if (!body) return tl::unexpected(body.error());
        return found->make(*body, parameters);
    }
    const auto& learned = learnedNames();
    if (std::find(learned.begin(), learned.end(), name) != learned.end())
        return fail("", fmt::format("the system '{}' is learned, and made from its weights alone", name),
                    "Train it with 'deixis learn' (docs/learning.md)");
    return fail("", fmt::format("unknown system '{}'", name),
                fmt::format("Expected one of: {}", fmt::join(systemNames(), ", ")));
}

}  // namespace deixis::motion
