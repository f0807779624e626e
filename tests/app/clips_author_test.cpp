// deixis clips author, the real program: projects of the studio become clips that a study plays.
#include <nlohmann/json.hpp>

#include "motion/upper_body/upper_body.hpp"
#include "program.hpp"
#include "text.hpp"

using namespace deixis;
using namespace deixis::tests;
using nlohmann::json;

namespace {

/// Of 0.5 s of silence, at 8 kHz: 8 frames.
void project(const std::string& file, const std::string& system, int poses) {
    std::string wav =
        "UklGRmQfAABXQVZFZm10IBAAAAABAAEAQB8AAIA+AAACABAAZGF0YUAf";  // the head, and 8000 bytes follow
    wav += "AAA";
    wav.append(4 * 2667 - 3, 'A');
    json frame = json::array();
    for (const double number : motion::numbersOf(motion::relaxedUpperBody())) frame.push_back(number);
    json speech{{"text", "Hello, mall!"}, {"duration_s", 0.5}, {"wav", wav}};
    speech["words"] = json::array({{{"word", "Hello"}, {"start_s", 0.0}, {"end_s", 0.3}},
                                   {{"word", "mall"}, {"start_s", 0.3}, {"end_s", 0.5}}});
    json document{
        {"name", "x"},
        {"speech", speech},
        {"motion", {{"system", system}, {"synthetic", system != "keyframes"}, {"frames", json::array()}}},
        {"poseControls", json::array()},
        {"styleControls", json::array()},
        {"bypass", {{"pose", false}, {"style", false}}}};
    for (int f = 0; f < 8; ++f) document["motion"]["frames"].push_back(frame);
    for (int i = 0; i < poses; ++i) document["poseControls"].push_back(json::object());
    spill(file, json{{"format", "deixis-studio"}, {"version", 2}, {"document", document}}.dump());
}

}  // namespace

TEST_SUITE("app/clips-author") {
    TEST_CASE(
        "Projects of one speech become one item in the paper's conditions, with sound, author and trial") {
        const Scratch scratch;
        project(scratch / "auto.json", "model", 0);
        project(scratch / "sgt.json", "model", 2);
        project(scratch / "manual.json", "keyframes", 3);
        const std::string files =
            (scratch / "auto.json") + " " + (scratch / "sgt.json") + " " + (scratch / "manual.json");
        const auto made =
            program("clips author " + files + " --author A1 --trial 3 -o " + (scratch / "clips"));
        CAPTURE(made.out);
        REQUIRE_MESSAGE(made.status == 0, made.err);
        CHECK(contains(made.out, "3 clips"));
        const std::string manifest = slurp(scratch / "clips/manifest.csv");
        CAPTURE(manifest);
        for (const char* system : {",AUTO,", ",SGT,", ",MANUAL,"}) CHECK(contains(manifest, system));
        CHECK(contains(manifest, "auto-hello-mall-"));
        CHECK(contains(manifest, "learned-from-synthetic"));
        CHECK(contains(manifest, "A1"));
        const auto checked = program("clips check " + (scratch / "clips/auto-hello-mall-*.bvh"));
        CHECK_MESSAGE(checked.status == 0, (checked.out + checked.err));
        int bvh = 0, wav = 0;
        for (const auto& entry : fs::directory_iterator(scratch / "clips")) {
            bvh += entry.path().extension() == ".bvh" ? 1 : 0;
            wav += entry.path().extension() == ".wav" ? 1 : 0;
        }
        CHECK(bvh == 3);
        CHECK(wav == 3);
        CHECK_FAILS_SAYING(program("clips author " + files + " -o " + (scratch / "clips")), "manifest.csv",
                           "--force");
    }

    TEST_CASE("A project without a speech and a text is told, and nothing is written") {
        const Scratch scratch;
        project(scratch / "a.json", "model", 0);
        json file = json::parse(slurp(scratch / "a.json"));
        file["document"]["speech"] = nullptr;
        file["document"]["text"] = " ";
        spill(scratch / "b.json", file.dump());
        CHECK_FAILS_SAYING(program("clips author " + (scratch / "a.json") + " " + (scratch / "b.json") +
                                   " -o " + (scratch / "c")),
                           "b.json.document.speech", "Press Generate");
        CHECK_FALSE(fs::exists(scratch / "c/manifest.csv"));
    }
}
