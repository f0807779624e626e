#include "renderer/scene/views.hpp"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/scene/frame.hpp"

namespace deixis::renderer {
namespace {

static_assert(sizeof(ViewBlock) == uniform_alignment);

constexpr std::string_view one_view_glsl = R"(
#define VIEW_COUNT 1
#define VIEW_INDEX 0
)";

constexpr std::string_view both_views_glsl = R"(
#extension GL_OVR_multiview2 : require
#define VIEW_COUNT 2
#define VIEW_INDEX gl_ViewID_OVR
)";

constexpr std::string_view both_views_vertex_glsl = "layout(num_views = 2) in;\n";

constexpr std::string_view view_glsl = R"(
struct View {
    mat4 clip_from_stage;
    mat4 eye_from_stage;
    mat4 clip_from_eye;
    vec4 eye;
    uint side;
    vec4 unused[2];
};
layout(std140, binding = 2) uniform Views { View views[VIEW_COUNT]; };
#define this_view views[VIEW_INDEX]
)";

std::string joined(gl::Parts parts) {
    std::string text;
    for (const std::string_view part : parts) text += part;
    return text;
}

ViewBlock placed(const Pose& stage_from_eye, const glm::mat4& clip_from_eye, double pixel_at_1m) {
    ViewBlock view;
    view.eye_from_stage = matrixFromPose(inverse(stage_from_eye));
    view.clip_from_eye = clip_from_eye;
    view.clip_from_stage = view.clip_from_eye * view.eye_from_stage;
    view.eye = glm::vec4(glm::vec3(stage_from_eye.position), static_cast<float>(pixel_at_1m));
    return view;
}

}  // namespace

ViewBlock viewBlock(const Camera& camera, int width, int height) {
    const double aspect = static_cast<double>(width) / static_cast<double>(height);
    return placed(camera.stage_from_eye,
                  glm::mat4(glm::perspective(camera.vertical_fov_rad, aspect, camera.near_m, camera.far_m)),
                  2.0 * std::tan(0.5 * camera.vertical_fov_rad) / height);
}

ViewBlock viewBlock(const Eye& eye, std::uint32_t side, double near_m, double far_m, int height) {
    const double left = std::tan(eye.fov.left_rad);
    const double right = std::tan(eye.fov.right_rad);
    const double down = std::tan(eye.fov.down_rad);
    const double up = std::tan(eye.fov.up_rad);
    ViewBlock view = placed(
        eye.stage_from_eye,
        glm::mat4(glm::frustum(left * near_m, right * near_m, down * near_m, up * near_m, near_m, far_m)),
        (up - down) / height);
    view.side = side;
    return view;
}

ViewProgram::ViewProgram(std::string_view name, gl::Parts vertex, gl::Parts fragment)
    : name_(name),
      vertex_(joined(vertex)),
      fragment_(joined(fragment)),
      one_(gl::drawProgram(name_, {one_view_glsl, view_glsl, vertex_},
                           {one_view_glsl, view_glsl, fragment_})) {}

void ViewProgram::use(Views views) {
    if (views == Views::both && both_.name() == 0U)
        both_ = gl::drawProgram(name_ + " for both views",
                                {both_views_glsl, both_views_vertex_glsl, view_glsl, vertex_},
                                {both_views_glsl, view_glsl, fragment_});
    glUseProgram((views == Views::both ? both_ : one_).name());
}

}  // namespace deixis::renderer
