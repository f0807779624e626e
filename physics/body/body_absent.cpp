// Body in a program that was built without MuJoCo: none can be made.
#include <stdexcept>

#include "physics/body/body.hpp"

namespace deixis::physics {

struct Body::Simulation {};

namespace {

[[noreturn]] void neverMade() {
    throw std::logic_error("a body without MuJoCo");
}

}  // namespace

Result<Body> Body::make(const Figure& /*figure*/, const std::string& /*library*/) {
    return fail("", "this program was built without MuJoCo, which simulates the body",
                "Build it with libmujoco-dev installed and without -DDEIXIS_PHYSICS=OFF. All that does not "
                "simulate a body works without it");
}

Body::Body(const Body& /*other*/) {
    neverMade();
}
Body::Body(std::unique_ptr<Simulation> simulation) : simulation_(std::move(simulation)) {}
Body::Body(Body&&) noexcept = default;
Body& Body::operator=(Body&&) noexcept = default;
Body::~Body() = default;

const Figure& Body::figure() const {
    neverMade();
}
void Body::setState(const BodyState& /*state*/) {
    neverMade();
}
BodyState Body::state() const {
    neverMade();
}
std::span<const double> Body::angles_rad() const {
    neverMade();
}
std::span<const double> Body::speeds_rad_s() const {
    neverMade();
}
RootState Body::root() const {
    neverMade();
}
void Body::moveRoot(const Pose& /*root*/) {
    neverMade();
}
void Body::step(std::span<const double> /*targets_rad*/, int /*steps*/) {
    neverMade();
}
std::vector<double> Body::biasTorques_nm() {
    neverMade();
}
std::vector<Vec3> Body::jointPositions_m() {
    neverMade();
}

std::string mujocoLibraryName() {
    return "";
}

}  // namespace deixis::physics
