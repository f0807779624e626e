#include "studies/study_file/stage_kind.hpp"

#include <optional>

namespace deixis::studies {

#define DEIXIS_KIND(name) extern const StageDeclaration name##_declaration;
DEIXIS_STAGE_KINDS(DEIXIS_KIND)
#undef DEIXIS_KIND

namespace {

#define DEIXIS_KIND(name) &name##_declaration,
constexpr const StageDeclaration* declarations[] = {DEIXIS_STAGE_KINDS(DEIXIS_KIND)};
#undef DEIXIS_KIND

}  // namespace

const StageDeclaration& declarationOf(StageKind kind) {
    return *declarations[static_cast<std::size_t>(kind)];
}

std::span<const StageDeclaration* const> allDeclarations() {
    return declarations;
}

const StageDeclaration* findDeclaration(std::string_view name) {
    const std::optional<StageKind> kind = stageKindFromName(name);
    return kind ? &declarationOf(*kind) : nullptr;
}

std::string_view stageKindName(StageKind kind) {
    return declarationOf(kind).name;
}

std::optional<StageKind> stageKindFromName(std::string_view name) {
    for (std::size_t i = 0; i < stage_kinds; ++i)
        if (declarations[i]->name == name) return static_cast<StageKind>(i);
    return {};
}

bool showsClips(StageKind kind) {
    return declarationOf(kind).showsClips();
}

std::vector<std::vector<int>> eachByItself(int systems) {
    std::vector<std::vector<int>> out;
    for (int i = 0; i < systems; ++i) out.push_back({i});
    return out;
}

std::vector<Question> ratingQuestion(const Stage& stage, const LanguageTable& /*words*/) {
    return {{"rating", QuestionKind::scale, stage.question, stage.scale}};
}

}  // namespace deixis::studies
