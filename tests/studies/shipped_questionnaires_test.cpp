#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <map>
#include <set>

#include "core/files.hpp"
#include "paths.hpp"
#include "studies/study_file/questionnaire.hpp"
#include "studies/study_file/study.hpp"

namespace fs = std::filesystem;
using namespace deixis;
using namespace deixis::studies;

namespace {

const fs::path shipped_data = deixis::tests::sourceDir() / "assets/data";
constexpr std::array languages{"en", "de", "sv", "ko"};

using Answers = std::map<std::string, double>;

/// A folder of its own; gone with the test.
class OneStudyFolder {
  public:
    OneStudyFolder() {
        std::string name = (fs::temp_directory_path() / "deixis_questionnaire_XXXXXX").string();
        REQUIRE(mkdtemp(name.data()) != nullptr);
        path_ = name;
    }
    ~OneStudyFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    OneStudyFolder(const OneStudyFolder&) = delete;
    OneStudyFolder& operator=(const OneStudyFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// The questionnaire as a study that names it gets it.
Questionnaire shippedQuestionnaire(const std::string& name, const std::string& language = "en") {
    const OneStudyFolder folder;
    const fs::path file = folder.path() / "study.toml";
    REQUIRE(writeFile(file, fmt::format(R"([study]
name = "one-questionnaire"
title = "One questionnaire"
seed = 1
languages = ["{}"]

[[stages]]
name = "questions"
kind = "questionnaire"
file = "{}"
)",
                                        language, name))
                .has_value());
    const auto study =
        loadStudy(file, {shipped_data / "languages", shipped_data / "questionnaires"}, language);
    if (!study) FAIL(study.error().front().text());
    REQUIRE(study->stages.size() == 1);
    return study->stages.front().questionnaire;
}

std::optional<double> score(const Questionnaire& questionnaire, const std::string& name,
                            const Answers& answers) {
    for (const Score& candidate : questionnaire.scores) {
        if (candidate.name == name) return computeScore(questionnaire, candidate, answers);
    }
    FAIL("no score " << name);
    return {};
}

void checkScore(const Questionnaire& questionnaire, const std::string& name, const Answers& answers,
                double expected) {
    CAPTURE(name);
    const std::optional<double> found = score(questionnaire, name, answers);
    REQUIRE(found.has_value());
    CHECK(*found == doctest::Approx(expected).epsilon(1e-12));
}

Answers all(const Questionnaire& questionnaire, double value) {
    Answers answers;
    for (const Question& question : questionnaire.questions) answers[question.id] = value;
    return answers;
}

std::vector<std::string> ids(const Questionnaire& questionnaire) {
    std::vector<std::string> found;
    for (const Question& question : questionnaire.questions) found.push_back(question.id);
    return found;
}

/// Kennedy et al. 1993: the symptoms in the order of the form, and whether each counts for nausea, oculomotor
/// and disorientation.
struct Symptom {
    const char* text;  ///< how the English text begins
    const char* id;
    bool nausea, oculomotor, disorientation;
};
constexpr std::array<Symptom, 16> symptoms{{
    {"General discomfort", "general_discomfort", true, true, false},
    {"Fatigue", "fatigue", false, true, false},
    {"Headache", "headache", false, true, false},
    {"Eyestrain", "eyestrain", false, true, false},
    {"Difficulty focusing", "difficulty_focusing", false, true, true},
    {"Increased salivation", "increased_salivation", true, false, false},
    {"Sweating", "sweating", true, false, false},
    {"Nausea", "nausea", true, false, true},
    {"Difficulty concentrating", "difficulty_concentrating", true, true, false},
    {"Fullness of head", "fullness_of_head", false, false, true},
    {"Blurred vision", "blurred_vision", false, true, true},
    {"Dizzy (eyes open)", "dizzy_eyes_open", false, false, true},
    {"Dizzy (eyes closed)", "dizzy_eyes_closed", false, false, true},
    {"Vertigo", "vertigo", false, false, true},
    {"Stomach awareness", "stomach_awareness", true, false, false},
    {"Burping", "burping", true, false, false},
}};

}  // namespace

TEST_SUITE("studies/shipped_questionnaires") {
    TEST_CASE("SSQ: the 16 symptoms stand in the published order on a scale from none to severe.") {
        const Questionnaire ssq = shippedQuestionnaire("ssq");
        REQUIRE(ssq.questions.size() == symptoms.size());
        for (std::size_t i = 0; i < symptoms.size(); ++i) {
            const Question& question = ssq.questions[i];
            CHECK(question.id == symptoms[i].id);
            CHECK(question.text.starts_with(symptoms[i].text));
            CHECK(question.kind == QuestionKind::scale);
            CHECK(question.scale.low == 0);
            CHECK(question.scale.high == 3);
            CHECK(question.scale.labels == std::vector<std::string>{"none", "slight", "moderate", "severe"});
        }
    }

    TEST_CASE("SSQ: all symptoms slight, and all severe, give the scores worked out by hand.") {
        // Seven symptoms in each scale: 7 x 9.54, 7 x 7.58, 7 x 13.92, and (7 + 7 + 7) x 3.74.
        const Questionnaire ssq = shippedQuestionnaire("ssq");
        const Answers slight = all(ssq, 1);
        checkScore(ssq, "nausea", slight, 66.78);
        checkScore(ssq, "oculomotor", slight, 53.06);
        checkScore(ssq, "disorientation", slight, 97.44);
        checkScore(ssq, "total", slight, 78.54);
        // Three times as much: the highest scores there are.
        const Answers severe = all(ssq, 3);
        checkScore(ssq, "nausea", severe, 200.34);
        checkScore(ssq, "oculomotor", severe, 159.18);
        checkScore(ssq, "disorientation", severe, 292.32);
        checkScore(ssq, "total", severe, 235.62);
        for (const char* name : {"nausea", "oculomotor", "disorientation", "total"}) {
            checkScore(ssq, name, all(ssq, 0), 0.0);
        }
    }

    TEST_CASE("SSQ: a single symptom counts for its own scales, and for the total once in each of them.") {
        const Questionnaire ssq = shippedQuestionnaire("ssq");
        for (const Symptom& symptom : symptoms) {
            CAPTURE(symptom.id);
            Answers answers = all(ssq, 0);
            answers[symptom.id] = 2;
            checkScore(ssq, "nausea", answers, symptom.nausea ? 2 * 9.54 : 0.0);
            checkScore(ssq, "oculomotor", answers, symptom.oculomotor ? 2 * 7.58 : 0.0);
            checkScore(ssq, "disorientation", answers, symptom.disorientation ? 2 * 13.92 : 0.0);
            checkScore(ssq, "total", answers,
                       2 * 3.74 * (symptom.nausea + symptom.oculomotor + symptom.disorientation));
        }
    }

    TEST_CASE("SSQ: a mixed sheet gives the scores worked out by hand.") {
        const Questionnaire ssq = shippedQuestionnaire("ssq");
        Answers answers = all(ssq, 0);
        answers["general_discomfort"] = 1;
        answers["fatigue"] = 2;
        answers["eyestrain"] = 1;
        answers["nausea"] = 1;
        answers["vertigo"] = 3;
        // N: 1 + 1 = 2; O: 1 + 2 + 1 = 4; D: 1 + 3 = 4; total (2 + 4 + 4) x 3.74. The sum of the 16 symptoms
        // is 8: who takes that for the total, a frequent mistake, gets 29.92.
        checkScore(ssq, "nausea", answers, 19.08);
        checkScore(ssq, "oculomotor", answers, 30.32);
        checkScore(ssq, "disorientation", answers, 55.68);
        checkScore(ssq, "total", answers, 37.40);
    }

    TEST_CASE("NASA-TLX: six ratings from 0 to 100, and their plain mean.") {
        const Questionnaire tlx = shippedQuestionnaire("nasa-tlx-raw");
        CHECK(ids(tlx) == std::vector<std::string>{"mental_demand", "physical_demand", "temporal_demand",
                                                   "performance", "effort", "frustration"});
        for (const Question& question : tlx.questions) {
            CAPTURE(question.id);
            CHECK(question.scale.kind == ScaleKind::slider);
            CHECK(question.scale.low == 0);
            CHECK(question.scale.high == 100);
            // More is more load: performance alone runs the other way in words, from perfect to failure.
            const bool performance = question.id == "performance";
            CHECK(question.scale.labels == (performance ? std::vector<std::string>{"perfect", "failure"}
                                                        : std::vector<std::string>{"very low", "very high"}));
        }
        // (70 + 20 + 55 + 35 + 60 + 30) / 6 = 270 / 6.
        checkScore(tlx, "raw_tlx",
                   {{"mental_demand", 70},
                    {"physical_demand", 20},
                    {"temporal_demand", 55},
                    {"performance", 35},
                    {"effort", 60},
                    {"frustration", 30}},
                   45.0);
        // Nothing demanded and perfect success is the least load there is.
        checkScore(tlx, "raw_tlx", all(tlx, 0), 0.0);
        Answers failed = all(tlx, 0);
        failed["performance"] = 100;
        checkScore(tlx, "raw_tlx", failed, 100.0 / 6.0);
    }

    TEST_CASE("IPQ: the 14 items stand in the order of the English form, with ends of their own.") {
        const Questionnaire ipq = shippedQuestionnaire("ipq");
        CHECK(ids(ipq) == std::vector<std::string>{"inv1", "real1", "sp4", "real2", "real3", "sp3", "inv2",
                                                   "g1", "sp1", "sp5", "inv3", "real4", "sp2", "inv4"});
        for (const Question& question : ipq.questions) {
            CHECK(question.scale.low == 0);
            CHECK(question.scale.high == 6);
            REQUIRE(question.scale.labels.size() >= 2);
        }
        const auto ends = [&](const std::string& id) {
            const std::vector<std::string>& labels = ipq.find(id)->scale.labels;
            return std::pair(labels.front(), labels.back());
        };
        CHECK(ends("inv1") == std::pair<std::string, std::string>("extremely aware", "not aware at all"));
        CHECK(ends("real1") == std::pair<std::string, std::string>("completely real", "not real at all"));
        CHECK(ends("sp3") == std::pair<std::string, std::string>("did not feel", "felt present"));
        CHECK(ends("sp2") == std::pair<std::string, std::string>("fully disagree", "fully agree"));
    }

    TEST_CASE("IPQ: scores follow igroup.org's syntax, in which sp2, inv3 and real1 alone are reversed.") {
        const Questionnaire ipq = shippedQuestionnaire("ipq");
        const Answers answers{{"g1", 5},    {"sp1", 4},   {"sp2", 1},   {"sp3", 3},  {"sp4", 6},
                              {"sp5", 2},   {"inv1", 2},  {"inv2", 4},  {"inv3", 5}, {"inv4", 3},
                              {"real1", 1}, {"real2", 3}, {"real3", 2}, {"real4", 0}};
        checkScore(ipq, "general_presence", answers, 5.0);
        checkScore(ipq, "spatial_presence", answers, 4.0);     // (4 + (6 - 1) + 3 + 6 + 2) / 5
        checkScore(ipq, "involvement", answers, 2.5);          // (2 + 4 + (6 - 5) + 3) / 4
        checkScore(ipq, "experienced_realism", answers, 2.5);  // ((6 - 1) + 3 + 2 + 0) / 4

        // The largest presence that can be told: the upper end of all but the three.
        Answers max = all(ipq, 6);
        for (const char* id : {"sp2", "inv3", "real1"}) max[id] = 0;
        for (const char* name :
             {"general_presence", "spatial_presence", "involvement", "experienced_realism"}) {
            checkScore(ipq, name, max, 6.0);
        }
    }

    TEST_CASE("A score is there only where all its items were answered, and does not need the others.") {
        for (const char* name : {"ssq", "nasa-tlx-raw", "ipq"}) {
            const Questionnaire questionnaire = shippedQuestionnaire(name);
            REQUIRE(!questionnaire.scores.empty());
            for (const Score& one : questionnaire.scores) {
                CAPTURE(one.name);
                const std::set<std::string> needed(one.items.begin(), one.items.end());
                for (const Question& question : questionnaire.questions) {
                    CAPTURE(question.id);
                    Answers answers = all(questionnaire, 1);
                    answers.erase(question.id);
                    CHECK(computeScore(questionnaire, one, answers).has_value() !=
                          needed.contains(question.id));
                }
            }
        }
    }

    TEST_CASE("Demographics: age may be left out, and every other question has a way not to say.") {
        const Questionnaire about = shippedQuestionnaire("demographics");
        CHECK(ids(about) ==
              std::vector<std::string>{"age", "gender", "handedness", "vision", "vr_experience"});
        for (const Question& question : about.questions) {
            CAPTURE(question.id);
            if (question.id == "age") {
                CHECK(question.kind == QuestionKind::number);
                CHECK_FALSE(question.required);
            } else {
                CHECK(question.kind == QuestionKind::choice);
                REQUIRE(!question.options.empty());
                CHECK(question.options.back().id == "not_said");
            }
        }
        CHECK(about.scores.empty());
    }

    TEST_CASE("A questionnaire is the same in every language but for its words.") {
        for (const char* name : {"ssq", "nasa-tlx-raw", "ipq", "demographics"}) {
            const Questionnaire english = shippedQuestionnaire(name);
            CHECK_FALSE(english.reference.empty());
            for (const std::string language : languages) {
                if (language == "en") continue;
                CAPTURE(name);
                CAPTURE(language);
                const Questionnaire other = shippedQuestionnaire(name, language);
                CHECK(other.name == english.name);
                CHECK(other.per_page == english.per_page);
                CHECK(other.text != english.text);
                REQUIRE(ids(other) == ids(english));
                for (std::size_t i = 0; i < english.questions.size(); ++i) {
                    const Question& one = english.questions[i];
                    const Question& two = other.questions[i];
                    CAPTURE(one.id);
                    CHECK(two.kind == one.kind);
                    CHECK(two.text != one.text);
                    CHECK(two.scale.kind == one.scale.kind);
                    CHECK(two.scale.low == one.scale.low);
                    CHECK(two.scale.high == one.scale.high);
                    CHECK(two.scale.labels.size() == one.scale.labels.size());
                    REQUIRE(two.options.size() == one.options.size());
                    for (std::size_t j = 0; j < one.options.size(); ++j) {
                        CHECK(two.options[j].id == one.options[j].id);
                    }
                }
                REQUIRE(other.scores.size() == english.scores.size());
                for (std::size_t i = 0; i < english.scores.size(); ++i) {
                    CHECK(computeScore(other, other.scores[i], all(other, 2)) ==
                          computeScore(english, english.scores[i], all(english, 2)));
                }
            }
        }
    }

    TEST_CASE("No two questions or answers of a questionnaire read alike by mistake.") {
        // The IPQ asks one question twice in English and Swedish, told apart by its ends; German tells
        // environment and world apart.
        for (const char* name : {"ssq", "nasa-tlx-raw", "ipq", "demographics"}) {
            for (const std::string language : languages) {
                CAPTURE(name);
                CAPTURE(language);
                std::set<std::pair<std::string, std::vector<std::string>>> seen;
                for (const Question& question : shippedQuestionnaire(name, language).questions) {
                    CAPTURE(question.id);
                    CHECK(seen.emplace(question.text, question.scale.labels).second);
                    const std::set<std::string> labels(question.scale.labels.begin(),
                                                       question.scale.labels.end());
                    CHECK(labels.size() == question.scale.labels.size());
                    std::set<std::string> options;
                    for (const QuestionOption& option : question.options) options.insert(option.text);
                    CHECK(options.size() == question.options.size());
                }
            }
        }
    }
}
