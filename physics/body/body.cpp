#include "physics/body/body.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>
#include <utility>

#include "mujoco_library.hpp"
#include "physics/figure/mjcf.hpp"

namespace deixis::physics {

namespace {

using Model = std::shared_ptr<const mjModel>;
using Data = std::unique_ptr<mjData, decltype(&mj_deleteData)>;

/// A text as a file that is nowhere on a disk: MuJoCo reads files, and how it reads from memory differs from
/// version to version.
class FileInMemory {
  public:
    explicit FileInMemory(const std::string& text) : descriptor_(memfd_create("body.xml", MFD_CLOEXEC)) {
        if (descriptor_ < 0 ||
            write(descriptor_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
            throw std::runtime_error("the body's description cannot be written to memory");
    }
    ~FileInMemory() { close(descriptor_); }
    FileInMemory(const FileInMemory&) = delete;
    FileInMemory& operator=(const FileInMemory&) = delete;
    [[nodiscard]] std::string path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

  private:
    int descriptor_;
};

Vec3 vectorAt(const mjtNum* numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

Pose poseAt(const mjtNum* position, const mjtNum* quaternion) {
    return {vectorAt(position), Quat(quaternion[0], quaternion[1], quaternion[2], quaternion[3])};
}

void put(const Pose& pose, mjtNum* position, mjtNum* quaternion) {
    for (int i = 0; i < 3; ++i) position[i] = pose.position[i];
    const Quat q = glm::normalize(pose.orientation);
    const std::array<double, 4> numbers{q.w, q.x, q.y, q.z};
    std::copy(numbers.begin(), numbers.end(), quaternion);
}

}  // namespace

struct Body::Simulation {
    const MujocoLibrary* mujoco;
    std::shared_ptr<const Figure> figure;
    Model model;
    Data data;

    [[nodiscard]] bool pinned() const { return figure->stance == Stance::pinned; }
    [[nodiscard]] std::size_t hinges() const { return figure->hinges.size(); }
    /// A free pelvis has the first 7 positions and the first 6 speeds.
    [[nodiscard]] mjtNum* angles() const { return data->qpos + (pinned() ? 0 : 7); }
    [[nodiscard]] mjtNum* speeds() const { return data->qvel + (pinned() ? 0 : 6); }

    void moveRoot(const Pose& root) const {
        if (pinned())
            put(root, data->mocap_pos, data->mocap_quat);
        else
            put(root, data->qpos, data->qpos + 3);
    }

    [[nodiscard]] Pose root() const {
        return pinned() ? poseAt(data->mocap_pos, data->mocap_quat) : poseAt(data->qpos, data->qpos + 3);
    }

    /// Segments are bodies 1, 2, ... and hinges joints in the same order, after a free pelvis' own.
    void checkOrder() const {
        const int first = pinned() ? 0 : 1;
        bool same = model->nbody == static_cast<int>(figure->segments.size()) + 1 &&
                    model->njnt == first + static_cast<int>(hinges()) &&
                    model->nu == static_cast<int>(hinges());
        for (std::size_t i = 0; same && i < hinges(); ++i)
            same = figure->hinges[i].name ==
                   mujoco->id_to_name(model.get(), mjOBJ_JOINT, first + static_cast<int>(i));
        for (std::size_t i = 0; same && i < figure->segments.size(); ++i)
            same = figure->segments[i].name ==
                   mujoco->id_to_name(model.get(), mjOBJ_BODY, static_cast<int>(i) + 1);
        if (!same) throw std::logic_error("MuJoCo has the body's parts in another order");
    }
};

Result<Body> Body::make(const Figure& figure, const std::string& library) {
    const auto mujoco = loadMujoco(library);
    if (!mujoco) return tl::unexpected(mujoco.error());
    const FileInMemory text(mjcf(figure));
    std::array<char, 1000> problem{};
    mjModel* model = (*mujoco)->load_xml(text.path().c_str(), nullptr, problem.data(), problem.size());
    if (model == nullptr)
        return fail("", fmt::format("MuJoCo rejects the body: {}", problem.data()),
                    "The avatar's bones may have unusual lengths");
    Model kept(model, [delete_model = (*mujoco)->delete_model](const mjModel* m) {
        delete_model(const_cast<mjModel*>(m));
    });
    auto simulation = std::make_unique<Simulation>(
        Simulation{*mujoco, std::make_shared<const Figure>(figure), std::move(kept),
                   Data((*mujoco)->make_data(model), (*mujoco)->delete_data)});
    simulation->checkOrder();
    simulation->mujoco->forward(simulation->model.get(), simulation->data.get());
    return Body(std::move(simulation));
}

Body::Body(std::unique_ptr<Simulation> simulation) : simulation_(std::move(simulation)) {}

Body::Body(const Body& other)
    : simulation_(std::make_unique<Simulation>(
          Simulation{other.simulation_->mujoco, other.simulation_->figure, other.simulation_->model,
                     Data(other.simulation_->mujoco->copy_data(nullptr, other.simulation_->model.get(),
                                                               other.simulation_->data.get()),
                          other.simulation_->mujoco->delete_data)})) {}

Body::Body(Body&&) noexcept = default;
Body& Body::operator=(Body&&) noexcept = default;
Body::~Body() = default;

const Figure& Body::figure() const {
    return *simulation_->figure;
}

void Body::setState(const BodyState& state) {
    const Simulation& s = *simulation_;
    if (state.angles_rad.size() != s.hinges() || state.speeds_rad_s.size() != s.hinges())
        throw std::invalid_argument("a body's state has an angle and a speed for each hinge");
    // With it goes what the solver would begin its next step from.
    s.mujoco->reset_data(s.model.get(), s.data.get());
    s.moveRoot(state.root.pose);
    std::copy(state.angles_rad.begin(), state.angles_rad.end(), s.angles());
    std::copy(state.speeds_rad_s.begin(), state.speeds_rad_s.end(), s.speeds());
    if (!s.pinned()) {
        const Vec3 turning =
            glm::conjugate(glm::normalize(state.root.pose.orientation)) * state.root.angular_velocity_rad_s;
        for (int i = 0; i < 3; ++i) {
            s.data->qvel[i] = state.root.velocity_m_s[i];
            s.data->qvel[3 + i] = turning[i];
        }
    }
}

BodyState Body::state() const {
    const auto angles = angles_rad();
    const auto speeds = speeds_rad_s();
    return {root(), {angles.begin(), angles.end()}, {speeds.begin(), speeds.end()}};
}

std::span<const double> Body::angles_rad() const {
    return {simulation_->angles(), simulation_->hinges()};
}

std::span<const double> Body::speeds_rad_s() const {
    return {simulation_->speeds(), simulation_->hinges()};
}

RootState Body::root() const {
    const Simulation& s = *simulation_;
    RootState out;
    out.pose = s.root();
    if (s.pinned()) return out;
    out.velocity_m_s = vectorAt(s.data->qvel);
    out.angular_velocity_rad_s = out.pose.orientation * vectorAt(s.data->qvel + 3);
    return out;
}

void Body::moveRoot(const Pose& root) {
    simulation_->moveRoot(root);
}

void Body::step(std::span<const double> targets_rad, int steps) {
    const Simulation& s = *simulation_;
    if (targets_rad.size() != s.hinges()) throw std::invalid_argument("a body has a target for each hinge");
    std::copy(targets_rad.begin(), targets_rad.end(), s.data->ctrl);
    for (int i = 0; i < steps; ++i) s.mujoco->step(s.model.get(), s.data.get());
}

std::vector<double> Body::biasTorques_nm() {
    const Simulation& s = *simulation_;
    s.mujoco->forward(s.model.get(), s.data.get());
    const mjtNum* first = s.data->qfrc_bias + (s.pinned() ? 0 : 6);
    return {first, first + s.hinges()};
}

std::vector<Vec3> Body::jointPositions_m() {
    const Simulation& s = *simulation_;
    s.mujoco->kinematics(s.model.get(), s.data.get());
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < s.figure->segments.size(); ++i)
        out.push_back(vectorAt(s.data->xpos + 3 * (i + 1)));
    return out;
}

}  // namespace deixis::physics
