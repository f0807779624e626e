#include "headset_picture.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "app/window/frame_scene.hpp"
#include "motion/skeleton/skeleton.hpp"

namespace deixis::app {

namespace {

constexpr double notice_distance_m = 1.1;
constexpr double notice_line_m = 0.046;
constexpr double notice_above_eyes_m = 0.30;  // over the avatar's head and any page
constexpr double notice_follows_rad = radiansFromDegrees(45.0);

// As large as pages come, in the sizes of their texts.
renderer::Board pageLikeBoard() {
    renderer::Board board;
    board.stage_from_board = {{-0.7, 0.8, 1.8}, no_rotation};
    board.width_m = 1.4;
    board.height_m = 1.3;
    board.progress = 0.5;
    board.texts = {{{0.07, 1.1, 1.2, 0.1}, "Title", 0.066, true},
                   {{0.07, 0.9, 1.2, 0.1}, "Text", 0.046},
                   {{0.07, 0.7, 1.2, 0.1}, "Emphasis", 0.046, true}};
    board.buttons = {{{0.5, 0.1, 0.3, 0.13}, "Continue"}};
    return board;
}

renderer::Board ratingLikeBoard() {
    renderer::Board board;
    board.stage_from_board = {{-0.78, 0.9, 1.8}, no_rotation};
    board.width_m = 1.55;
    board.height_m = 0.42;
    board.texts = {{{0.07, 0.28, 1.4, 0.07}, "Question", 0.05, true, true}};
    board.buttons = {{{0.07, 0.07, 0.25, 0.17}, "1", "caption"},
                     {{0.4, 0.07, 0.25, 0.17}, "2", "caption", true, true}};
    return board;
}

// Upright before the head, above the eyes.
Pose noticePose(const renderer::Board& board, const Pose& tracking_from_head) {
    const Pose stand = studies::anchorFromHead(tracking_from_head).tracking_from_anchor;
    const Vec3 corner(-board.width_m / 2.0,
                      tracking_from_head.position.y + notice_above_eyes_m - board.height_m / 2.0,
                      -notice_distance_m);
    return stand * Pose{corner, no_rotation};
}

}  // namespace

HeadsetPicture::HeadsetPicture(renderer::Renderer renderer, XrSessionLoop& session)
    : renderer_(std::move(renderer)),
      session_(session),
      mode_(renderer_.hasMultiview() ? renderer::StereoMode::multiview : renderer::StereoMode::two_passes) {}

Result<std::unique_ptr<HeadsetPicture>> HeadsetPicture::create(const assets::Avatar& avatar,
                                                               XrSessionLoop& session) {
    auto made = renderer::Renderer::create(avatar, {});
    if (!made) return tl::unexpected(made.error());
    std::unique_ptr<HeadsetPicture> picture(new HeadsetPicture(std::move(*made), session));
    picture->updateHiddenArea();
    return picture;
}

void HeadsetPicture::updateHiddenArea() {
    renderer_.setHiddenArea(session_.hiddenArea());
}

void HeadsetPicture::warmUp(const assets::Avatar& avatar) {
    renderer::Scene scene;
    motion::worldPose(avatar.skeleton, motion::restPose(avatar.skeleton), scene.avatars.emplace_back());
    const Pose head{{0.0, 1.6, 3.0}, no_rotation};
    scene.balls.push_back({{0.5, 1.2, 1.0}});
    scene.balls.back().rings = 2;
    scene.beams.push_back({{{0.2, 1.2, 2.8}, {0.0, 0.0, -1.0}}});
    constexpr double side_rad = radiansFromDegrees(45.0);
    XrEyes eyes;
    eyes.tracking_from_eye = {head, head};
    eyes.fov.fill({-side_rad, side_rad, side_rad, -side_rad});
    setNotice("Warming up", head);
    for (const renderer::Board& board : {pageLikeBoard(), ratingLikeBoard()}) {
        scene.boards = {board, pageLikeBoard()};
        (void)draw(scene, [&] { return std::optional<XrEyes>(eyes); }, {});
    }
    drawMirror(scene, session_.eyeSize().width, session_.eyeSize().height);
    setNotice("", head);
}

XrBoardLayer HeadsetPicture::layerOf(const renderer::Board& board, Shown& shown,
                                     const studies::Placement& placement) {
    if (!shown.painted || !renderer::sameContent(shown.board, board)) {
        const auto [width, height] = renderer_.boardSize(board);
        if (!shown.chain || shown.chain.size().width < width || shown.chain.size().height < height)
            shown.chain = session_.boardPicture(std::max(width, shown.chain.size().width),
                                                std::max(height, shown.chain.size().height));
        const unsigned int texture = shown.chain.acquire();
        renderer_.copyBoard(board, texture);
        shown.chain.release();
        shown.board = board;
        shown.painted = true;
        shown.width = width;
        shown.height = height;
    }
    const renderer::BoardRect extent = renderer_.boardExtent(board);
    const Pose board_from_centre{{extent.x + extent.width / 2.0, extent.y + extent.height / 2.0, 0.0},
                                 no_rotation};
    XrBoardLayer layer;
    layer.picture = &shown.chain;
    layer.width = shown.width;
    layer.height = shown.height;
    layer.tracking_from_centre = placement.toTracking(board.stage_from_board * board_from_centre);
    layer.width_m = extent.width / placement.scale;
    layer.height_m = extent.height / placement.scale;
    return layer;
}

void HeadsetPicture::setNotice(const std::string& text, const Pose& tracking_from_head) {
    if (text.empty()) {
        notice_.reset();
        return;
    }
    if (!notice_ || notice_text_ != text) {
        notice_text_ = text;
        notice_ = noticeBoard(text, notice_line_m);
        notice_->stage_from_board = noticePose(*notice_, tracking_from_head);
    }
    const Vec3 middle =
        transformPoint(notice_->stage_from_board, {notice_->width_m / 2.0, notice_->height_m / 2.0, 0.0});
    const Vec3 looking = tracking_from_head.orientation * Vec3(0, 0, -1);
    if (angleBetween(looking, middle - tracking_from_head.position) > notice_follows_rad)
        notice_->stage_from_board = noticePose(*notice_, tracking_from_head);
}

XrLayers HeadsetPicture::draw(const renderer::Scene& scene, const LocateEyes& locate_eyes,
                              const studies::Placement& placement) {
    XrLayers layers;
    if (notice_) layers.above = layerOf(*notice_, notice_picture_, {});
    if (!scene.boards.empty()) layers.beneath = layerOf(scene.boards.front(), page_, placement);
    renderer::StereoTarget target;
    target.width = session_.eyeSize().width;
    target.height = session_.eyeSize().height;
    const bool depth = session_.hasDepth();
    for (std::size_t i = 0; i < 2; ++i) {
        target.colour[i] = session_.colour()[i].acquire();
        if (depth) target.depth[i] = session_.depth()[i].acquire();
    }
    // As late as can be: what is shown is fixed, the eyes still move.
    const std::optional<XrEyes> eyes = locate_eyes();
    if (eyes) {
        renderer::Eyes views;
        for (std::size_t i = 0; i < 2; ++i)
            views[i] = {placement.toStage(eyes->tracking_from_eye[i]), eyes->fov[i]};
        left_ = views[0];
        renderer_.drawStereo(scene, views, target, mode_);
    }
    for (std::size_t i = 0; i < 2; ++i) {
        session_.colour()[i].release();
        if (depth) session_.depth()[i].release();
    }

    if (!eyes) return {};
    layers.eyes = eyes;
    layers.has_depth = depth;
    layers.near_m = scene.camera.near_m / placement.scale;
    layers.far_m = scene.camera.far_m / placement.scale;
    return layers;
}

XrLayers HeadsetPicture::drawUnplaced(const std::string& text) {
    renderer::Board board = noticeBoard(text, notice_line_m);
    board.stage_from_board.position = {-board.width_m / 2.0, -board.height_m / 2.0, -notice_distance_m};
    XrLayers layers;
    layers.above = layerOf(board, notice_picture_, {});
    layers.above->before_face = true;
    return layers;
}

void HeadsetPicture::drawMirror(const renderer::Scene& scene, int width, int height) {
    renderer_.drawMirror(scene, left_, width, height);
}

}  // namespace deixis::app
