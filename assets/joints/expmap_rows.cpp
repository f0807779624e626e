#include "assets/joints/expmap_rows.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "expmap_skeletons.hpp"
#include "length_unit.hpp"
#include "motion/retarget/retarget.hpp"
#include "number_lines.hpp"
#include "up_axis.hpp"

namespace deixis::assets {

namespace {

constexpr double largest = 1e9;  // sums and sines of these are good numbers still

/// The exponential of the negative map, for the data turn row vectors.
Quat rotationOf(const Vec3& map) {
    const double angle = glm::length(map);
    if (!(angle > 1e-12)) return no_rotation;
    const Vec3 axis = -map / angle;
    const double s = std::sin(0.5 * angle);
    return {std::cos(0.5 * angle), s * axis.x, s * axis.y, s * axis.z};
}

}  // namespace

Result<ImportedClip> parseExpmapRows(std::string_view text, const std::string& name,
                                     const ImportOptions& options) {
    CsvReader reader(text, name, formOfNumbers(text));
    CsvRecord row;
    const std::vector<std::string>& fields = row.fields;
    const ExpmapSkeleton* kind = nullptr;
    ImportedClip out;
    motion::LocalPose rest;
    for (;;) {
        const auto more = reader.next(row);
        if (!more) return tl::unexpected(more.error());
        if (!*more) break;
        const std::string where = name + ":" + std::to_string(row.line);
        if (kind == nullptr) {
            kind = expmapSkeleton(fields.size());
            if (kind == nullptr)
                return fail(where, "found " + std::to_string(fields.size()) +
                                       " numbers, expected 99 (Human3.6M) or 117 (CMU)");
            out.clip.skeleton = kind->skeleton;
            out.unit = options.metres_per_unit
                           ? FoundUnit{*options.metres_per_unit, Origin::given,
                                       givenUnitName(*options.metres_per_unit)}
                           : FoundUnit{kind->metres_per_unit, Origin::declared, kind->unit};
            for (motion::Joint& joint : out.clip.skeleton.joints) joint.rest.position *= out.unit.metres;
            rest = motion::restPose(out.clip.skeleton);
        }
        if (fields.size() != kind->columns)
            return fail(where, "found " + std::to_string(fields.size()) + " numbers, expected " +
                                   std::to_string(kind->columns) + " as in the lines before");
        motion::LocalPose pose = rest;
        for (std::size_t triple = 0; 3 * triple < fields.size(); ++triple) {
            Vec3 value(0.0);
            for (int axis = 0; axis < 3; ++axis) {
                const std::size_t column = 3 * triple + static_cast<std::size_t>(axis);
                const auto number = finiteNumber(fields[column]);
                if (!number || std::abs(*number) > largest)
                    return fail(where, "found '" + fields[column].substr(0, 40) + "' in column " +
                                           std::to_string(column + 1) +
                                           ", expected a number from -1e9 to 1e9");
                value[axis] = *number;
            }
            if (triple == 0)
                pose.joints[0].position += out.unit.metres * value;
            else
                pose.joints[triple - 1].orientation = rotationOf(value);
        }
        out.clip.frames.push_back(std::move(pose));
    }
    if (kind == nullptr) return fail(name, "found no lines, expected rows of exponential maps");
    out.format = kind->name;
    out.rate = options.fps ? FoundRate{*options.fps, Origin::given} : FoundRate{kind->fps, Origin::assumed};
    if (!options.fps)
        out.remarks.emplace_back(std::string("the rows do not give their rate: ") + kind->fps_remark);
    out.clip.frame_time_s = 1.0 / out.rate.fps;
    out.up = findUp(out.clip, motion::detectHumanoid(out.clip.skeleton), options.up_axis);
    turnUp(out.clip, out.up.axis);
    return out;
}

}  // namespace deixis::assets
