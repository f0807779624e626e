#include "assets/humanoid_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <numeric>
#include <sstream>
#include <vector>

#include "core/files.hpp"

namespace deixis::assets {

namespace {

/// Letters to change, add or take away to come from one name to the other (Levenshtein).
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, changed});
        }
    }
    return row.back();
}

/// "Did you mean x?", or nothing where no name is near.
std::string proposal(std::string_view found, const std::vector<std::string_view>& names) {
    std::string_view nearest;
    std::size_t least = std::max<std::size_t>(2, found.size() / 3) + 1;
    for (const std::string_view name : names)
        if (const std::size_t d = distance(found, name); d < least) {
            least = d;
            nearest = name;
        }
    return nearest.empty() ? "" : fmt::format("Did you mean {}?", nearest);
}

std::vector<std::string_view> allBones() {
    std::vector<std::string_view> names;
    for (std::size_t b = 0; b < motion::bone_count; ++b)
        names.push_back(motion::boneName(static_cast<motion::Bone>(b)));
    return names;
}

/// Where the two words of a joint's bones were found, to tell of a joint named twice.
struct Word {
    std::string bone;
    std::uint32_t line;
};

}  // namespace

std::filesystem::path humanoidFileOf(const std::filesystem::path& clip) {
    std::filesystem::path name = clip;
    if (name.extension() == ".gz") name.replace_extension();
    return name.replace_extension(".humanoid.toml");
}

Result<void> applyHumanoidText(std::string_view text, const std::string& name,
                               const motion::Skeleton& skeleton, motion::HumanoidMapping& mapping) {
    toml::table table;
    try {
        table = toml::parse(text, name);
    } catch (const toml::parse_error& error) {
        return fail(fmt::format("{}:{}", name, error.source().begin.line), std::string(error.description()));
    }
    std::vector<std::optional<Word>> words(skeleton.joints.size());
    std::vector<std::string_view> joints;
    for (const auto& joint : skeleton.joints) joints.push_back(joint.name);
    for (const auto& [key, node] : table) {
        const auto line = node.source().begin.line;
        const std::string where = fmt::format("{}:{}: {}", name, line, key.str());
        const auto bone = motion::boneFromName(key.str());
        if (!bone)
            return fail(where, "unknown bone, expected a bone of VRM 1.0, such as leftUpperArm",
                        proposal(key.str(), allBones()));
        const auto joint_name = node.value_exact<std::string>();
        if (!joint_name)
            return fail(where, "found no text, expected a joint's name in quotes, or \"\" for none");
        int joint = -1;
        if (!joint_name->empty()) {
            joint = skeleton.find(*joint_name);
            if (joint < 0)
                return fail(where,
                            fmt::format("found \"{}\", expected one of the clip's {} joints", *joint_name,
                                        joints.size()),
                            proposal(*joint_name, joints));
            auto& word = words[static_cast<std::size_t>(joint)];
            if (word)
                return fail(where,
                            fmt::format("found \"{}\", which {} on line {} has already, expected a joint for "
                                        "each bone",
                                        *joint_name, word->bone, word->line));
            word = Word{std::string(key.str()), line};
        }
        for (std::size_t b = 0; b < motion::bone_count; ++b)  // whatever else the joint was taken for
            if (joint >= 0 && mapping.map.joint[b] == joint) {
                mapping.map.joint[b] = -1;
                mapping.found[b] = motion::FoundBy::nothing;
            }
        mapping.map[*bone] = joint;
        mapping.found[static_cast<std::size_t>(*bone)] =
            joint < 0 ? motion::FoundBy::nothing : motion::FoundBy::override_;
    }
    return {};
}

Result<void> applyHumanoidFile(const std::filesystem::path& file, const motion::Skeleton& skeleton,
                               motion::HumanoidMapping& mapping) {
    const auto text = readFile(file);
    if (!text) return tl::unexpected(text.error());
    return applyHumanoidText(*text, file.string(), skeleton, mapping);
}

Result<motion::HumanoidMapping> mapClip(const std::filesystem::path& clip, const motion::Skeleton& skeleton,
                                        const motion::HumanoidMap* given) {
    auto mapping = motion::mapHumanoid(skeleton, given);
    std::error_code code;
    if (const auto file = humanoidFileOf(clip); std::filesystem::is_regular_file(file, code)) {
        if (auto applied = applyHumanoidFile(file, skeleton, mapping); !applied)
            return tl::unexpected(applied.error());
        mapping.remarks.push_back("bones as " + file.string() + " says");
    }
    return mapping;
}

std::string humanoidToml(const motion::HumanoidMapping& mapping, const motion::Skeleton& skeleton) {
    std::string out;
    for (std::size_t b = 0; b < motion::bone_count; ++b) {
        const int joint = mapping.map.joint[b];
        std::ostringstream value;  // quoted as TOML asks
        value << toml::value<std::string>(joint < 0 ? std::string()
                                                    : skeleton.joints[static_cast<std::size_t>(joint)].name);
        out += fmt::format("{} = {}\n", motion::boneName(static_cast<motion::Bone>(b)), value.str());
    }
    return out;
}

}  // namespace deixis::assets
