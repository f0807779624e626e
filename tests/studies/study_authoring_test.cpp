// Study files: stages of authoring, and questions that rate systems.
#include <doctest/doctest.h>

#include "study_file_fixture.hpp"

using namespace deixis;
using namespace deixis::studies;

TEST_SUITE("studies/study_authoring") {
    TEST_CASE("What a file says of authoring is what the stage holds") {
        const Folder folder;
        const Study study = loaded(folder.write(readText(fixtures / "full.toml")));
        const Stage* stage = study.findStage("author");
        REQUIRE(stage != nullptr);
        CHECK(stage->kind == StageKind::authoring);
        CHECK(stage->authoring.limit_s == 600.0);
        CHECK(stage->authoring.practice_limit_s == 120.0);
        CHECK(stage->authoring.may_end_early);
        CHECK_FALSE(stage->authoring.practice_may_end_early);
        CHECK(stage->authoring.practice_per_block == 1);
        CHECK(stage->authoring.keyframes_only == std::vector<std::string>{"begun"});
        const Question& tired = study.findStage("about")->questionnaire.questions.front();
        REQUIRE(tired.rates.has_value());
        CHECK(tired.rates->measure == "tiredness");
        CHECK(tired.rates->system == "begun");
    }

    TEST_CASE("What they cannot be is told") {
        checkEdits("full.toml",
                   {{"keyframes_only = [\"begun\"]",
                     "keyframes_only = [\"begn\"]",
                     "keyframes_only",
                     "stages.keyframes_only",
                     {"begn", "Did you mean begun?"}},
                    {"practice_per_block = 1",
                     "practice_per_block = 4",
                     "practice_per_block",
                     "stages.practice_per_block",
                     {"found 4", "less than the 4 trials"}},
                    {"practice_per_block = 1\npractice_limit_s = 120\npractice_may_end_early = false\n",
                     "practice_limit_s = 120\n",
                     "practice_limit_s",
                     "stages.practice_limit_s",
                     {"without practice_per_block"}},
                    {"limit_s = 600",
                     "limit_s = 600\nmuted = false",
                     "muted = false",
                     "stages.muted",
                     {"shows no clips"}},
                    {"measure = \"tiredness\", system = \"begun\"",
                     "measure = \"tiredness\", system = \"begn\"",
                     "rates = ",
                     "stages.questions.rates.system",
                     {"begn", "Did you mean begun?"}},
                    {"measure = \"tiredness\"",
                     "measure = \"accuracy\"",
                     "rates = ",
                     "stages.questions.rates.measure",
                     {"report's name"}}});
    }
}
