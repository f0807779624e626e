#include "physics/figure/mjcf.hpp"

#include <fmt/format.h>

#include <glm/geometric.hpp>

namespace deixis::physics {

namespace {

std::string numbers(const Vec3& v) {
    return fmt::format("{} {} {}", v.x, v.y, v.z);
}

class Writer {
  public:
    explicit Writer(const Figure& figure) : figure_(figure) {}

    std::string text() {
        const bool pinned = figure_.stance == Stance::pinned;
        out_ = fmt::format(
            "<mujoco model=\"deixis\">\n"
            "  <compiler angle=\"radian\"/>\n"
            "  <option timestep=\"{}\" gravity=\"0 -9.81 0\" integrator=\"Euler\">{}</option>\n"
            "  <size nconmax=\"{}\" njmax=\"{}\"/>\n"
            "  <default><geom contype=\"0\" conaffinity=\"{}\" friction=\"1 0.005 0.0001\"/></default>\n"
            "  <worldbody>\n",
            step_s, pinned ? "<flag contact=\"disable\"/>" : "", contacts(), constraints(), pinned ? 0 : 1);
        if (!pinned)
            out_ +=
                "    <geom name=\"floor\" type=\"plane\" size=\"10 10 1\" zaxis=\"0 1 0\" contype=\"1\" "
                "conaffinity=\"0\"/>\n";
        body(0);
        out_ += "  </worldbody>\n  <actuator>\n";
        for (const Hinge& hinge : figure_.hinges)
            out_ += fmt::format(
                "    <position name=\"{0}\" joint=\"{0}\" kp=\"{1}\" forcelimited=\"true\" "
                "forcerange=\"-{2} {2}\"/>\n",
                hinge.name, hinge.stiffness_nm_rad, hinge.max_torque_nm);
        return out_ + "  </actuator>\n</mujoco>\n";
    }

  private:
    /// The most points at which the segments touch the floor. MuJoCo's own guess at this and at the
    /// constraints takes megabytes a body, which a reset clears.
    [[nodiscard]] std::size_t contacts() const {
        constexpr std::size_t of_box = 8, of_capsule = 2;
        std::size_t out = 1;
        if (figure_.stance == Stance::free)
            for (const Segment& one : figure_.segments) out += isBox(one.shape) ? of_box : of_capsule;
        return out;
    }
    [[nodiscard]] std::size_t constraints() const {
        constexpr std::size_t edges = 4;  // of the pyramid that stands for a point's friction cone
        return figure_.hinges.size() + edges * contacts();
    }
    [[nodiscard]] static bool isBox(const Shape& shape) { return shape.half_box_m != Vec3(0.0); }

    void body(std::size_t index) {
        const Segment& segment = figure_.segments[index];
        const bool root = segment.parent < 0;
        const bool pinned = figure_.stance == Stance::pinned;
        out_ += fmt::format("<body name=\"{}\" pos=\"{}\"{}>\n", segment.name, numbers(segment.joint_m),
                            root && pinned ? " mocap=\"true\"" : "");
        if (root && !pinned) out_ += "<freejoint/>\n";
        for (std::size_t i = segment.first; i < segment.first + segment.count; ++i) {
            const Hinge& hinge = figure_.hinges[i];
            out_ += fmt::format(
                "<joint name=\"{}\" type=\"hinge\" axis=\"{}\" limited=\"true\" range=\"{} {}\" "
                "damping=\"{}\" armature=\"{}\"/>\n",
                hinge.name, numbers(hinge.axis), hinge.min_rad, hinge.max_rad, hinge.damping_nms_rad,
                hinge.armature_kg_m2);
        }
        const MassProperties& mass = segment.mass;
        const glm::dmat3& i = mass.inertia_kg_m2;
        out_ += fmt::format("<inertial pos=\"{}\" mass=\"{}\" fullinertia=\"{} {} {} {} {} {}\"/>\n",
                            numbers(mass.centre_m), mass.mass_kg, i[0][0], i[1][1], i[2][2], i[1][0], i[2][0],
                            i[2][1]);
        shape(segment.shape);
        for (std::size_t child = index + 1; child < figure_.segments.size(); ++child)
            if (figure_.segments[child].parent == static_cast<int>(index)) body(child);
        out_ += "</body>\n";
    }

    void shape(const Shape& shape) {
        if (isBox(shape))
            out_ += fmt::format("<geom type=\"box\" pos=\"{}\" size=\"{}\"/>\n",
                                numbers(0.5 * (shape.from_m + shape.to_m)), numbers(shape.half_box_m));
        else
            out_ += fmt::format("<geom type=\"capsule\" fromto=\"{} {}\" size=\"{}\"/>\n",
                                numbers(shape.from_m), numbers(shape.to_m), shape.radius_m);
    }

    const Figure& figure_;
    std::string out_;
};

}  // namespace

std::string mjcf(const Figure& figure) {
    return Writer(figure).text();
}

}  // namespace deixis::physics
