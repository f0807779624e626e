#include "learning/gesture_scores/evaluation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/pose.hpp"
#include "motion/upper_body/upper_body_style.hpp"

namespace deixis::learning {

namespace {

using motion::Style, motion::UpperBodyMotion, motion::UpperBodyPose;

constexpr std::size_t part_frames = scored_frames;
constexpr std::size_t posed_until = posed_first + posed_frames;

std::size_t partsOf(const UpperBodyMotion& motion) {
    return motion.frames.size() / part_frames;
}

/// A row of latents for each part of some motions.
class Latents {
  public:
    Latents(const MotionEncoder& encoder, const UpperBodyPose& mean)
        : encoder_(encoder), mean_(motion::numbersOf(mean)) {}

    void add(const UpperBodyMotion& motion) {
        motion::MatrixXf poses(motion::upper_body_numbers, scored_frames);
        for (std::size_t part = 0; part < partsOf(motion); ++part) {
            for (std::size_t f = 0; f < part_frames; ++f) {
                const auto numbers = motion::numbersOf(motion.frames[part * part_frames + f]);
                for (std::size_t n = 0; n < numbers.size(); ++n)
                    poses(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(f)) =
                        static_cast<float>(numbers[n] - mean_[n]);
            }
            rows_.push_back(encoder_.encode(poses));
        }
    }
    [[nodiscard]] Eigen::MatrixXd matrix() const {
        Eigen::MatrixXd out(static_cast<Eigen::Index>(rows_.size()), MotionEncoder::latents);
        for (std::size_t r = 0; r < rows_.size(); ++r) out.row(static_cast<Eigen::Index>(r)) = rows_[r];
        return out;
    }

  private:
    const MotionEncoder& encoder_;
    std::array<double, motion::upper_body_numbers> mean_;
    std::vector<Eigen::VectorXd> rows_;
};

struct Mean {
    double sum = 0.0;
    std::size_t count = 0;
    void add(double value) {
        sum += value;
        ++count;
    }
    [[nodiscard]] double value() const { return count == 0 ? 0.0 : sum / static_cast<double>(count); }
};

template <typename Each>
void forPosedFrames(const UpperBodyMotion& motion, const Each& each) {
    for (std::size_t part = 0; part < partsOf(motion); ++part)
        for (std::size_t f = posed_first; f < posed_until; ++f) each(part * part_frames + f);
}

double offDeg(const Vec3& wanted, const Vec3& made) {
    return degreesFromRadians(angleBetween(wanted, made));
}

Result<std::vector<Style>> normalisedStylesOf(const UpperBodyMotion& motion, const motion::StyleNorm& norm) {
    auto styles = motion::styleOf(motion);
    if (!styles) return tl::unexpected(styles.error());
    for (Style& one : *styles) one = motion::normalisedStyle(one, norm);
    return std::move(*styles);
}

/// What is asked of the takes, and what came.
class Scoring {
  public:
    Scoring(const motion::SpeechGestureModel& model, const MotionEncoder& encoder)
        : model_(model),
          held_out_(encoder, model.meanPose()),
          plain_(held_out_),
          posed_(held_out_),
          styled_(held_out_) {}

    void addHeldOut(const UpperBodyMotion& motion) {
        held_out_.add(motion);
        parts_ += static_cast<int>(partsOf(motion));
    }
    void addPlain(const UpperBodyMotion& motion) { plain_.add(motion); }
    void addPosed(const UpperBodyMotion& wanted, const UpperBodyMotion& made) {
        posed_.add(made);
        forPosedFrames(wanted, [&](std::size_t f) {
            const auto a = motion::numbersOf(wanted.frames[f]), b = motion::numbersOf(made.frames[f]);
            for (std::size_t n = 0; n < a.size(); ++n) pcs_.add(std::abs(a[n] - b[n]));
            for (std::size_t bone = 0; bone < motion::upper_bone_count; ++bone)
                off_deg_.add(offDeg(wanted.frames[f].directions[bone], made.frames[f].directions[bone]));
        });
    }
    void addExact(const UpperBodyMotion& wanted, const UpperBodyMotion& made) {
        forPosedFrames(wanted, [&](std::size_t f) {
            for (std::size_t bone = 0; bone < motion::upper_bone_count; ++bone)
                exact_off_deg_ = std::max(exact_off_deg_, offDeg(wanted.frames[f].directions[bone],
                                                                 made.frames[f].directions[bone]));
        });
    }
    Result<void> addStyled(const UpperBodyMotion& wanted, const UpperBodyMotion& made) {
        styled_.add(made);
        const auto looked_at = static_cast<std::ptrdiff_t>(partsOf(wanted) * part_frames);
        for (const auto& [motion, styles] :
             {std::pair(&wanted, &wanted_styles_), std::pair(&made, &made_styles_)}) {
            const auto found = normalisedStylesOf(*motion, model_.styleNorm());
            if (!found) return tl::unexpected(found.error());
            styles->insert(styles->end(), found->begin(), found->begin() + looked_at);
        }
        return {};
    }
    [[nodiscard]] Result<GestureEvaluation> result(bool controls) const {
        if (parts_ < 2)
            return fail("takes",
                        fmt::format("found {} parts of 30 frames, expected at least 2: 4 s", parts_));
        const Eigen::MatrixXd held_out = held_out_.matrix();
        GestureEvaluation out;
        out.parts = parts_;
        out.scores.controls = controls;
        out.scores.fgd_no_controls = frechetDistance(held_out, plain_.matrix());
        if (!controls) return out;
        out.scores.fgd_pose_controls = frechetDistance(held_out, posed_.matrix());
        out.scores.fgd_style_controls = frechetDistance(held_out, styled_.matrix());
        out.scores.pcs = pcs_.value();
        const auto scs = motion::styleCompliance(wanted_styles_, made_styles_);
        if (!scs) return tl::unexpected(scs.error());
        out.scores.scs = *scs;
        out.posed_off_deg = off_deg_.value();
        out.exact_off_deg = exact_off_deg_;
        return out;
    }

  private:
    const motion::SpeechGestureModel& model_;
    Latents held_out_, plain_, posed_, styled_;
    Mean pcs_, off_deg_;
    std::vector<Style> wanted_styles_, made_styles_;  ///< normalised
    double exact_off_deg_ = 0.0;
    int parts_ = 0;
};

Result<void> scoreTake(const motion::SpeechGestureModel& model, const GestureTake& take, Scoring& scoring) {
    motion::SpeechGestureRequest request;
    request.samples = take.samples;
    request.utterance = take.utterance;
    request.duration_s = take.utterance.duration_s;
    const auto plain = model.generate(request);
    if (!plain) return tl::unexpected(plain.error());
    if (plain->frames.size() != take.motion.frames.size())
        return fail("take", fmt::format("found {} frames of motion, expected {}, as many as the sound lasts",
                                        take.motion.frames.size(), plain->frames.size()));
    scoring.addHeldOut(take.motion);
    scoring.addPlain(*plain);
    if (!model.takesControls()) return {};
    request.poses = evaluationPoses(take.motion);
    for (const bool exact : {false, true}) {
        request.exact = exact;
        const auto posed = model.generate(request);
        if (!posed) return tl::unexpected(posed.error());
        if (exact)
            scoring.addExact(take.motion, *posed);
        else
            scoring.addPosed(take.motion, *posed);
    }
    request.exact = false;
    request.poses.clear();
    auto styles = evaluationStyles(take.motion, model.styleNorm());
    if (!styles) return tl::unexpected(styles.error());
    request.styles = std::move(*styles);
    const auto styled = model.generate(request);
    if (!styled) return tl::unexpected(styled.error());
    return scoring.addStyled(take.motion, *styled);
}

}  // namespace

std::vector<motion::PoseControl> evaluationPoses(const UpperBodyMotion& motion) {
    std::vector<motion::PoseControl> out;
    forPosedFrames(motion, [&](std::size_t f) { out.push_back({static_cast<int>(f), motion.frames[f]}); });
    return out;
}

Result<std::vector<motion::StyleControl>> evaluationStyles(const UpperBodyMotion& motion,
                                                           const motion::StyleNorm& norm) {
    const auto styles = normalisedStylesOf(motion, norm);
    if (!styles) return tl::unexpected(styles.error());
    std::vector<motion::StyleControl> out;
    for (const Style& one : *styles) out.push_back({one.speed, one.space, one.handedness});
    return out;
}

Result<GestureEvaluation> evaluateGestures(
    const motion::SpeechGestureModel& model, const MotionEncoder& encoder,
    const std::vector<GestureTake>& takes,
    const std::function<void(std::size_t done, std::size_t count)>& progress) {
    Scoring scoring(model, encoder);
    for (std::size_t i = 0; i < takes.size(); ++i) {
        if (const auto scored = scoreTake(model, takes[i], scoring); !scored)
            return tl::unexpected(scored.error());
        if (progress) progress(i + 1, takes.size());
    }
    return scoring.result(model.takesControls());
}

Result<GestureEvaluation> evaluateMeanPose(const motion::SpeechGestureModel& model,
                                           const MotionEncoder& encoder,
                                           const std::vector<GestureTake>& takes) {
    Scoring scoring(model, encoder);
    for (const GestureTake& take : takes) {
        const UpperBodyMotion still{std::vector<UpperBodyPose>(take.motion.frames.size(), model.meanPose())};
        scoring.addHeldOut(take.motion);
        scoring.addPlain(still);
        scoring.addPosed(take.motion, still);
        if (const auto styled = scoring.addStyled(take.motion, still); !styled)
            return tl::unexpected(styled.error());
    }
    return scoring.result(true);
}

}  // namespace deixis::learning
