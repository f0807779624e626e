#include "assets/tables/humanoid_file.hpp"

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
    std::size_t min = std::max<std::size_t>(2, found.size() / 3) + 1;
    for (const std::string_view name : names)
        if (const std::size_t d = distance(found, name); d < min) {
            min = d;
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

}  // namespace

std::filesystem::path humanoidFileOf(const std::filesystem::path& clip) {
    std::filesystem::path name = clip;
    if (name.extension() == ".gz") name.replace_extension();
    return name.replace_extension(".humanoid.toml");
}

Result<HumanoidWords> parseHumanoidText(std::string_view text, const std::string& name) {
    toml::table table;
    try {
        table = toml::parse(text, name);
    } catch (const toml::parse_error& error) {
        return fail(fmt::format("{}:{}", name, error.source().begin.line), std::string(error.description()));
    }
    HumanoidWords said{name};
    said.text = text;
    for (const auto& [key, node] : table) {
        const auto line = static_cast<int>(node.source().begin.line);
        const std::string where = fmt::format("{}:{}: {}", name, line, key.str());
        if (key.str() == "height_m") {
            const auto height_m = node.value<double>();
            if (!height_m || !(*height_m >= min_height_m && *height_m <= max_height_m))
                return fail(where, fmt::format("expected an avatar's height from {:g} to {:g} metres",
                                               min_height_m, max_height_m));
            said.height_m = height_m;
            continue;
        }
        const auto bone = motion::boneFromName(key.str());
        if (!bone)
            return fail(where, "unknown bone, expected a bone of VRM 1.0, such as leftUpperArm",
                        proposal(key.str(), allBones()));
        const auto joint = node.value_exact<std::string>();
        if (!joint) return fail(where, "found no text, expected a joint's name in quotes, or \"\" for none");
        const auto before = std::find_if(said.words.begin(), said.words.end(), [&](const auto& word) {
            return !joint->empty() && word.joint == *joint;
        });
        if (before != said.words.end())
            return fail(
                where,
                fmt::format(
                    "found \"{}\", which {} on line {} already has, expected a separate joint for each bone",
                    *joint, motion::boneName(before->bone), before->line));
        said.words.push_back({*bone, *joint, line});
    }
    return said;
}

Result<std::optional<HumanoidWords>> humanoidWordsBeside(const std::filesystem::path& clip) {
    const auto file = humanoidFileOf(clip);
    std::error_code code;
    if (!std::filesystem::is_regular_file(file, code)) return std::nullopt;
    const auto text = readFile(file);
    if (!text) return tl::unexpected(text.error());
    auto said = parseHumanoidText(*text, file.string());
    if (!said) return tl::unexpected(said.error());
    return std::move(*said);
}

Result<void> applyHumanoidWords(const HumanoidWords& said, const motion::Skeleton& skeleton,
                                motion::HumanoidMapping& mapping) {
    for (const auto& word : said.words) {
        const int joint = word.joint.empty() ? -1 : skeleton.find(word.joint);
        if (!word.joint.empty() && joint < 0) {
            std::vector<std::string_view> joints;
            for (const auto& known : skeleton.joints) joints.push_back(known.name);
            return fail(fmt::format("{}:{}: {}", said.file, word.line, motion::boneName(word.bone)),
                        fmt::format("found \"{}\", expected one of the figure's {} joints", word.joint,
                                    joints.size()),
                        proposal(word.joint, joints));
        }
        for (std::size_t b = 0; b < motion::bone_count; ++b)  // whatever else the joint was taken for
            if (joint >= 0 && mapping.map.joint[b] == joint) {
                mapping.map.joint[b] = -1;
                mapping.found[b] = motion::FoundBy::nothing;
            }
        mapping.map[word.bone] = joint;
        mapping.found[static_cast<std::size_t>(word.bone)] =
            joint < 0 ? motion::FoundBy::nothing : motion::FoundBy::override_;
    }
    return {};
}

Result<motion::HumanoidMapping> mapClip(const std::filesystem::path& clip, const motion::Skeleton& skeleton,
                                        const motion::HumanoidMap* given) {
    const auto said = humanoidWordsBeside(clip);
    if (!said) return tl::unexpected(said.error());
    auto mapping = motion::mapHumanoid(skeleton, given);
    if (!*said) return mapping;
    if (auto applied = applyHumanoidWords(**said, skeleton, mapping); !applied)
        return tl::unexpected(applied.error());
    mapping.remarks.push_back("bones as " + (*said)->file + " says");
    if ((*said)->height_m)
        mapping.remarks.emplace_back("its height_m is for avatars: a clip's size comes from its unit");
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
