#include "assets/joints/clip_import.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>

#include "assets/gltf/gltf_clip.hpp"
#include "assets/joints/bvh.hpp"
#include "assets/joints/expmap_rows.hpp"
#include "assets/joints/joint_positions.hpp"
#include "core/number.hpp"
#include "core/text.hpp"
#include "length_unit.hpp"
#include "motion/retarget/retarget.hpp"
#include "number_lines.hpp"
#include "packed_file.hpp"
#include "up_axis.hpp"

namespace deixis::assets {

namespace {

enum class Kind : unsigned char { bvh, joint_csv, kinect, expmap, json, gltf, unknown };

/// The ending without the dot, in small letters; ".gz" does not count.
std::string endingOf(const std::string& name) {
    std::filesystem::path path(name);
    if (lowerCase(path.extension().string()) == ".gz") path = path.stem();
    const std::string ending = lowerCase(path.extension().string());
    return ending.empty() ? ending : ending.substr(1);
}

/// What a line of numbers, or a header of words, is the first of.
Kind kindOfTable(std::string_view line) {
    const CsvForm form = formOfNumbers(line);
    CsvRecord record;
    const auto read = CsvReader(line, "", form).next(record);
    std::vector<std::string>& fields = record.fields;
    while (!fields.empty() && fields.back().empty()) fields.pop_back();
    const bool numbers =
        std::all_of(fields.begin(), fields.end(),
                    [](std::string_view field) {  // also wrong ones, to be told so
                        double value = 0.0;
                        const char* end = field.data() + field.size();
                        return finiteNumber(field) || !hintOfNumber(field).empty() ||
                               (!field.empty() && std::from_chars(field.data(), end, value).ptr == end);
                    });
    if (!read || !numbers)
        return fields.size() >= 4 && form.separator != ' ' ? Kind::joint_csv : Kind::unknown;
    if (fields.size() == 101) return Kind::kinect;
    if (fields.size() == 99 || fields.size() == 117) return Kind::expmap;
    return Kind::unknown;
}

Kind kindOfContent(std::string_view bytes) {
    if (bytes.starts_with("glTF")) return Kind::gltf;
    const std::string_view start = firstLine(bytes);
    if (start.empty()) return Kind::unknown;
    constexpr std::string_view bvh = "hierarchy";
    if (lowerCase(start.substr(0, bvh.size())) == bvh) return Kind::bvh;
    if (start.front() == '{' || start.front() == '[')
        return start.front() == '{' && bytes.find("\"asset\"") != std::string_view::npos ? Kind::gltf
                                                                                         : Kind::json;
    return kindOfTable(start);
}

Kind kindOfEnding(const std::string& ending) {
    if (ending == "bvh") return Kind::bvh;
    if (ending == "csv") return Kind::joint_csv;
    if (ending == "json") return Kind::json;
    if (ending == "glb" || ending == "gltf" || ending == "vrm" || ending == "vrma") return Kind::gltf;
    return Kind::unknown;
}

Kind kindOf(std::string_view bytes, const std::string& name) {
    const Kind kind = kindOfContent(bytes);
    return kind == Kind::unknown ? kindOfEnding(endingOf(name)) : kind;
}

Result<ImportedClip> importBvh(std::string_view bytes, const std::string& name,
                               const ImportOptions& options) {
    auto file = parseBvh(bytes, name, BvhOptions{options.metres_per_unit, options.fps});
    if (!file) return tl::unexpected(file.error());
    ImportedClip out;
    out.format = "BVH";
    out.clip = std::move(file->clip);
    out.unit = file->unit;
    out.remarks = std::move(file->remarks);
    out.rate = options.fps ? FoundRate{*options.fps, Origin::given}
                           : FoundRate{out.clip.framesPerSecond(), Origin::declared};
    out.up = findUp(out.clip, motion::detectHumanoid(out.clip.skeleton), options.up_axis);
    turnUp(out.clip, out.up.axis);
    return out;
}

/// An animation is asked for by its name or, where it is a number and no animation has that name, by its
/// place.
Result<ImportedClip> importGltf(std::string_view bytes, const std::string& name, const ImportOptions& options,
                                const std::optional<std::filesystem::path>& folder) {
    GltfClipOptions how;
    how.animation = options.animation;
    how.fps = options.fps;
    how.metres_per_unit = options.metres_per_unit;
    auto file = parseGltfClip(bytes, name, how, folder);
    const std::string& wanted = options.animation;
    if (const auto place = deixis::wholeNumber(wanted);
        !file && place && std::abs(*place) <= std::numeric_limits<int>::max()) {
        how.animation.clear();
        how.animation_index = static_cast<int>(*place);
        file = parseGltfClip(bytes, name, how, folder);
    }
    if (!file) return tl::unexpected(file.error());
    ImportedClip out;
    out.format = file->humanoid_source.empty() ? "glTF" : "glTF, " + file->humanoid_source;
    out.clip = std::move(file->clip);
    out.humanoid = file->humanoid;
    out.unit = options.metres_per_unit
                   ? FoundUnit{file->metres_per_unit, Origin::given, givenUnitName(file->metres_per_unit)}
                   : FoundUnit{};
    out.rate = {out.clip.framesPerSecond(), options.fps ? Origin::given : Origin::declared};
    if (options.up_axis) out.up = {*options.up_axis, Origin::given};
    turnUp(out.clip, out.up.axis);
    out.remarks = std::move(file->remarks);
    return out;
}

Result<ImportedClip> importAs(Kind kind, std::string_view bytes, const std::string& name,
                              const ImportOptions& options,
                              const std::optional<std::filesystem::path>& folder) {
    switch (kind) {
        case Kind::bvh:
            return importBvh(bytes, name, options);
        case Kind::joint_csv:
            return parseJointCsv(bytes, name, options);
        case Kind::kinect:
            return parseKinectClip(bytes, name, options);
        case Kind::expmap:
            return parseExpmapRows(bytes, name, options);
        case Kind::json:
            return parseSgToolkitJson(bytes, name, options);
        case Kind::gltf:
            return importGltf(bytes, name, options, folder);
        case Kind::unknown:
            break;
    }
    return fail(name, bytes.empty()
                          ? "is empty, expected a clip"
                          : "has no known format: expected BVH, glTF (also VRM), CSV of joint positions with "
                            "a header, a Kinect v2 recording (101 numbers per line), exponential maps (99 or "
                            "117 numbers per line) or SGToolkit JSON");
}

/// Far away values are a wrong unit or damaged data, and make nonsense of every sum.
Result<void> checkPlaces(const ImportedClip& imported, const std::string& name) {
    constexpr double farthest_m = 1e5;
    constexpr double longest_bone_m = 100.0;
    const motion::Clip& clip = imported.clip;
    const auto near = [](const Vec3& p) {
        return std::abs(p.x) < farthest_m && std::abs(p.y) < farthest_m && std::abs(p.z) < farthest_m;
    };
    const auto far = [&](const std::string& where, const motion::Joint& joint) {
        return fail(name, where + ", joint '" + joint.name + "': found a bone of more than 100 km, in unit " +
                              unitWords(imported.unit) + "; expected the motion of a person");
    };
    for (const motion::Joint& joint : clip.skeleton.joints) {
        if (!near(joint.rest.position) || (joint.end_site && !near(*joint.end_site)))
            return far("rest pose", joint);
        const double length_m = joint.parent < 0 ? 0.0 : glm::length(joint.rest.position);
        if (length_m > longest_bone_m)
            return fail(name,
                        fmt::format("rest pose, joint '{}': found a bone of {:.0f} m, in unit {}; expected "
                                    "the bones of a person",
                                    joint.name, length_m, unitWords(imported.unit)),
                        "Correct its offset, or give the file's unit with --unit");
    }
    for (std::size_t f = 0; f < clip.frames.size(); ++f)
        for (std::size_t j = 0; j < clip.skeleton.joints.size(); ++j)
            if (const Pose& pose = clip.frames[f].joints[j]; !near(pose.position))
                return far("frame " + std::to_string(f), clip.skeleton.joints[j]);
            else if (!std::isfinite(glm::dot(pose.orientation, pose.orientation)))
                return fail(name, fmt::format("frame {}, joint '{}': found no rotation, expected one", f,
                                              clip.skeleton.joints[j].name));
    return {};
}

Result<ImportedClip> importFrom(std::string_view bytes, const std::string& name, const ImportOptions& options,
                                const std::optional<std::filesystem::path>& folder) {
    const auto positive = [](const std::optional<double>& value) {
        return !value || (*value > 0.0 && std::isfinite(*value));
    };
    if (!positive(options.fps)) return fail(name, "found a frame rate that is not above 0, expected one");
    if (!positive(options.metres_per_unit))
        return fail(name, "found a unit that is not above 0 metres, expected one");
    auto imported = importAs(kindOf(bytes, name), bytes, name, options, folder);
    if (!imported) return imported;
    if (auto places = checkPlaces(*imported, name); !places) return tl::unexpected(places.error());
    return imported;
}

}  // namespace

std::string_view originName(Origin origin) {
    switch (origin) {
        case Origin::given:
            return "given";
        case Origin::declared:
            return "declared";
        case Origin::detected:
            return "detected";
        case Origin::assumed:
            break;
    }
    return "assumed";
}

Result<ImportedClip> importClipBytes(std::string_view bytes, const std::string& name,
                                     const ImportOptions& options) {
    return importFrom(bytes, name, options, {});
}

Result<ImportedClip> importClip(const std::filesystem::path& path, const ImportOptions& options) {
    const auto bytes = readUnpacked(path);
    if (!bytes) return tl::unexpected(bytes.error());
    return importFrom(*bytes, path.string(), options, path.parent_path());
}

std::vector<std::filesystem::path> partsOfClip(const std::filesystem::path& path) {
    const auto bytes = readUnpacked(path);
    if (!bytes || kindOf(*bytes, path.string()) != Kind::gltf) return {};
    return gltfBufferFiles(*bytes, path);
}

std::string describe(const ImportedClip& imported) {
    return fmt::format("{}, {} joints, {} frames at {:.4g} fps ({}), unit {}, {} up ({})", imported.format,
                       imported.clip.skeleton.size(), imported.clip.frameCount(), imported.rate.fps,
                       originName(imported.rate.origin), unitWords(imported.unit),
                       upAxisName(imported.up.axis), originName(imported.up.origin));
}

}  // namespace deixis::assets
