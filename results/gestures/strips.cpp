#include "strips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "results/page/figure.hpp"
#include "results/page/number_text.hpp"

namespace deixis::results {

namespace {

using motion::UpperJoint;

constexpr double left_px = 118.0, width_px = 860.0, right_px = 16.0;
constexpr double sound_px = 34.0, words_px = 30.0, row_px = 118.0;
constexpr double metre_px = 72.0;
// The page's own, which follows its light and dark looks; arms are seen on both.
constexpr const char* text_colour = "currentColor";
constexpr const char* left_colour = "#2f8fd0";
constexpr const char* right_colour = "#dd6a14";
constexpr std::size_t figures = 15;  ///< of a strip

class Strips {
  public:
    explicit Strips(const GestureEvaluationPage& page)
        : page_(page), duration_s_(std::max(0.1, page.utterance.duration_s)) {}

    [[nodiscard]] std::string svg() const {
        const double height = sound_px + words_px + row_px * static_cast<double>(page_.strips.size()) + 26.0;
        const double all = left_px + width_px + right_px;
        std::string out = fmt::format(
            R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {} {}" role="img" aria-label="{}" )"
            R"(font-family="sans-serif" font-size="11">)",
            all, height, escapeHtml(label()));
        out += sound() + words();
        for (std::size_t i = 0; i < page_.strips.size(); ++i)
            out += row(page_.strips[i], sound_px + words_px + row_px * static_cast<double>(i));
        return out + axis(height - 22.0) + "</svg>";
    }

  private:
    [[nodiscard]] double xOf(double time_s) const { return left_px + width_px * time_s / duration_s_; }
    [[nodiscard]] double xOfFrame(std::size_t frame) const {
        return xOf(static_cast<double>(frame) / motion::upper_body_fps);
    }

    [[nodiscard]] std::string label() const {
        std::string out = "Poses over time. ";
        for (const GestureStrip& strip : page_.strips) out += strip.title + ". ";
        return out;
    }

    [[nodiscard]] std::string sound() const {
        std::string out =
            fmt::format(R"(<text x="4" y="{}" fill="{}">sound</text>)", sound_px / 2 + 8, text_colour);
        std::string path;
        for (std::size_t i = 0; i < page_.loudness.size(); ++i) {
            const double x = left_px + width_px * (static_cast<double>(i) + 0.5) /
                                           static_cast<double>(page_.loudness.size());
            const double half = 0.5 * (sound_px - 8.0) * std::clamp(page_.loudness[i], 0.0, 1.0);
            path += fmt::format("M{:.1f} {:.1f}V{:.1f}", x, sound_px / 2 + 4 - half, sound_px / 2 + 4 + half);
        }
        return out + fmt::format(R"(<path d="{}" stroke="{}" fill="none"/>)", path, even_colour);
    }

    [[nodiscard]] std::string words() const {
        std::string out;
        // In the first of two lines that has room.
        std::array<double, 2> free{};
        for (const SpokenWord& word : page_.utterance.words) {
            const double x = xOf(word.start_s);
            const std::size_t line = x < free[0] && free[1] < free[0] ? 1 : 0;
            const double at = std::max(x, free[line]);
            out += fmt::format(R"(<text x="{:.1f}" y="{:.1f}" fill="{}">{}</text>)", at,
                               sound_px + 12.0 + 12.0 * static_cast<double>(line), text_colour,
                               escapeHtml(word.text));
            free[line] = at + 6.2 * static_cast<double>(word.text.size()) + 5.0;
        }
        return out;
    }

    [[nodiscard]] std::string marks(const std::vector<MarkedFrames>& stretches, double top,
                                    const char* colour) const {
        std::string out;
        for (const MarkedFrames& one : stretches)
            out += fmt::format(
                R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="{}" fill-opacity=".22"/>)",
                xOfFrame(one.first), top + 3, std::max(2.0, xOfFrame(one.last) - xOfFrame(one.first)),
                row_px - 8, colour);
        return out;
    }

    [[nodiscard]] std::string row(const GestureStrip& strip, double top) const {
        std::string out = marks(strip.styled, top, "#d43d2a") + marks(strip.posed, top, "#1f9e55");
        out += fmt::format(R"(<path d="M{} {:.1f}h{}" stroke="currentColor" stroke-opacity=".2"/>)", 0, top,
                           left_px + width_px + right_px);
        double y = top + 20;
        for (const std::string& line : brokenName(strip.title)) {
            out += fmt::format(R"(<text x="4" y="{:.1f}" fill="{}">{}</text>)", y, text_colour,
                               escapeHtml(line));
            y += 14;
        }
        const std::size_t count = strip.motion.frames.size();
        for (std::size_t i = 0; i < figures && count > 0; ++i) {
            const double share = (static_cast<double>(i) + 0.5) / figures;
            const auto frame = static_cast<std::size_t>(share * static_cast<double>(count));
            out += figure(strip.motion.frames[frame], left_px + width_px * share, top + 0.58 * row_px);
        }
        return out;
    }

    /// From the front: the figure's left is on the right.
    [[nodiscard]] std::string figure(const motion::UpperBodyPose& pose, double x, double y) const {
        const motion::UpperBodyJoints joints = motion::jointsOf(pose);
        const auto at = [&](UpperJoint joint) {
            const Vec3& p = joints[static_cast<std::size_t>(joint)];
            return fmt::format("{:.1f} {:.1f}", x + metre_px * p.x, y - metre_px * (p.y - 0.1));
        };
        using enum UpperJoint;
        const auto line = [&](const std::string& path, const char* colour) {
            return fmt::format(
                R"(<path d="{}" stroke="{}" stroke-width="2.4" stroke-linecap="round" stroke-linejoin="round" fill="none"/>)",
                path, colour);
        };
        const Vec3& head = joints[static_cast<std::size_t>(nose)];
        return line("M" + at(spine) + "L" + at(neck) + "M" + at(left_shoulder) + "L" + at(neck) + "L" +
                        at(right_shoulder),
                    text_colour) +
               fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="6.5" fill="{}"/>)", x + metre_px * head.x,
                           y - metre_px * (head.y - 0.08), text_colour) +
               line("M" + at(left_shoulder) + "L" + at(left_elbow) + "L" + at(left_wrist), left_colour) +
               line("M" + at(right_shoulder) + "L" + at(right_elbow) + "L" + at(right_wrist), right_colour);
    }

    [[nodiscard]] std::string axis(double y) const {
        std::string out =
            fmt::format(R"(<path d="M{} {:.1f}h{}" stroke="{}"/>)", left_px, y, width_px, text_colour);
        for (double t = 0.0; t <= duration_s_; t += 1.0)
            out +=
                fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="middle" fill="{}">{:.0f} s</text>)",
                            xOf(t), y + 15, text_colour, t);
        return out;
    }

    const GestureEvaluationPage& page_;
    double duration_s_;
};

}  // namespace

std::string stripsSvg(const GestureEvaluationPage& page) {
    return Strips(page).svg();
}

}  // namespace deixis::results
