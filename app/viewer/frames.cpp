#include "frames.hpp"

#include <fmt/format.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "app/program/progress_line.hpp"
#include "core/staging.hpp"

namespace deixis::app {

namespace {

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

}  // namespace

Result<void> drawFrames(const assets::Avatar& avatar, WindowSize size, int count, const SceneOf& scene_of,
                        const TakeImage& take) {
    const ElapsedOnTerminal told("drawing");
    auto context = renderer::OffscreenContext::create();
    if (!context) return tl::unexpected(context.error());
    auto renderer = renderer::Renderer::create(avatar, {});
    if (!renderer) return tl::unexpected(renderer.error());
    for (int frame = 0; frame < count; ++frame)
        if (auto taken = take(renderer->capture(scene_of(frame), size.width, size.height)); !taken)
            return taken;
    return {};
}

Result<void> writeFilm(const std::string& mp4_file, double frames_per_s, const assets::Avatar& avatar,
                       WindowSize size, int count, const SceneOf& scene_of) {
    if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0)
        return fail("--mp4", "ffmpeg, which makes the film, is not installed",
                    "Install it (Debian: apt install ffmpeg), or write pictures instead");
    std::error_code code;
    std::filesystem::create_directories(std::filesystem::path(mp4_file).parent_path(), code);
    // Written beside and renamed at the end: no half film.
    PartialFile partial(mp4_file, ".partial.mp4");
    const std::string command = fmt::format(
        "ffmpeg -y -loglevel error -f rawvideo -pixel_format rgb24 -video_size {}x{} -framerate {} -i - "
        "-vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2' -pix_fmt yuv420p {}",
        size.width, size.height, frames_per_s, quoted(partial.path().string()));
    std::FILE* ffmpeg = popen(command.c_str(), "w");
    if (ffmpeg == nullptr) return fail("--mp4", "ffmpeg cannot be started");
    // Where ffmpeg ends early, writing to it fails, and it has said why.
    const auto otherwise = std::signal(SIGPIPE, SIG_IGN);
    const auto drawn =
        drawFrames(avatar, size, count, scene_of, [&](const renderer::Image& image) -> Result<void> {
            if (std::fwrite(image.rgb.data(), 1, image.rgb.size(), ffmpeg) != image.rgb.size())
                return fail(mp4_file, "ffmpeg stopped taking frames");
            return {};
        });
    const int status = pclose(ffmpeg);
    (void)std::signal(SIGPIPE, otherwise);
    if (status != 0) return fail(mp4_file, "ffmpeg could not write the film; see its message above");
    if (!drawn) return drawn;
    if (auto moved = partial.finish(); !moved) return moved;
    fmt::print("{} frames: {}\n", count, mp4_file);
    return {};
}

Result<void> writeFilm(const std::string& mp4_file, const assets::Avatar& avatar, WindowSize size,
                       double duration_s, const std::function<renderer::Scene(double)>& scene_at) {
    constexpr double frames_per_s = 30.0;
    const int count = static_cast<int>(std::floor(duration_s * frames_per_s + 1e-6)) + 1;
    return writeFilm(mp4_file, frames_per_s, avatar, size, count,
                     [&](int frame) { return scene_at(frame / frames_per_s); });
}

}  // namespace deixis::app
