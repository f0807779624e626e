#include "study_structure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace deixis::app {

namespace {

/// A thing in words, without what may differ.
using Parts = std::vector<std::string>;

std::string scaleText(const studies::Scale& scale) {
    return fmt::format("from {} to {}", scale.low, scale.high);
}

std::string questionText(const studies::Question& question) {
    std::string out = fmt::format("question {} (kind {}", question.id, static_cast<int>(question.kind));
    if (question.kind == studies::QuestionKind::scale) out += ", " + scaleText(question.scale);
    if (question.kind == studies::QuestionKind::number)
        out += fmt::format(", from {} to {}", question.low, question.high);
    for (const auto& option : question.options) out += ", " + option.id;
    return out + ")";
}

std::string scoreText(const studies::Score& score) {
    return fmt::format("score {} ({}; reversed {}; mean {}, factor {}, offset {})", score.name,
                       fmt::join(score.items, " "), fmt::join(score.reversed, " "), score.mean, score.factor,
                       score.offset);
}

Parts structureOf(const studies::Study& study) {
    Parts out{"study " + study.name, fmt::format("balls of {} m", study.targets.ball_diameter_m)};
    for (const auto& system : study.systems) {
        std::string levels;
        for (const auto& [factor, level] : system.levels) levels += fmt::format(" {}={}", factor, level);
        out.push_back(fmt::format("system {}{}{}", system.name,
                                  system.generator.empty() ? "" : ", generator " + system.generator, levels));
    }
    for (const auto& layout : study.layouts)
        out.push_back(fmt::format("layout {} at ({}, {}), heading {}", layout.name, layout.viewer_x_m,
                                  layout.viewer_z_m, layout.heading_deg));
    for (const auto& band : study.distances)
        out.push_back(fmt::format("distance {} from {} to {} m, {} distractors", band.name,
                                  band.distance_m.low, band.distance_m.high, band.distractors));
    for (const auto& factor : study.between)
        out.push_back(fmt::format("groups {} ({})", factor.name, fmt::join(factor.levels, ", ")));
    for (const auto& stage : study.stages) {
        out.push_back(fmt::format("stage {} ({}{}, visit {}, measure '{}', {})", stage.name,
                                  studies::stageKindName(stage.kind),
                                  stage.practice ? ", practice of " + stage.practice->of : "", stage.session,
                                  stage.measure, scaleText(stage.scale)));
        for (const auto& question : stage.questionnaire.questions)
            out.push_back(stage.name + ": " + questionText(question));
        for (const auto& score : stage.questionnaire.scores)
            out.push_back(stage.name + ": " + scoreText(score));
        for (const auto* question : {&stage.confidence, &stage.reasons})
            if (*question) out.push_back(stage.name + ": " + questionText(**question));
    }
    return out;
}

}  // namespace

std::string structureDifference(const studies::Study& before, const studies::Study& now) {
    const Parts a = structureOf(before);
    const Parts b = structureOf(now);
    const auto [there, here] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    if (there == a.end() && here == b.end()) return "";
    return fmt::format("it was '{}', is '{}'", there == a.end() ? "nothing" : *there,
                       here == b.end() ? "nothing" : *here);
}

}  // namespace deixis::app
