// All the files that a lab's clips and avatar are made of are locked, and compared at each session.
#include <cstring>

#include "lab_study.hpp"
#include "text.hpp"

using namespace deixis::tests;

namespace {

using nlohmann::json;

/// A .glb as a .gltf with its buffer in NAME.bin beside it; `more` is joined to the text.
void splitGlb(const fs::path& glb, const fs::path& gltf, const json& more = json::object()) {
    const std::string bytes = slurp(glb);
    const auto wordAt = [&](std::size_t at) {
        std::uint32_t word = 0;
        REQUIRE(bytes.size() >= at + sizeof(word));
        std::memcpy(&word, bytes.data() + at, sizeof(word));
        return static_cast<std::size_t>(word);
    };
    const std::size_t text_bytes = wordAt(12);
    json text = json::parse(bytes.substr(20, text_bytes));
    text.update(more);
    const fs::path bin = fs::path(gltf).replace_extension(".bin");
    text["buffers"][0]["uri"] = bin.filename().string();
    spill(gltf, text.dump());
    spill(bin, bytes.substr(28 + text_bytes, wordAt(20 + text_bytes)));
}

/// Moves the figure aside in all keys of the first translation.
void moveAside(const fs::path& gltf) {
    const json text = json::parse(slurp(gltf));
    const json& animation = text["animations"][0];
    for (const json& channel : animation["channels"]) {
        if (channel["target"]["path"] != "translation") continue;
        const json& accessor =
            text["accessors"]
                [animation["samplers"][channel["sampler"].get<std::size_t>()]["output"].get<std::size_t>()];
        const json& view = text["bufferViews"][accessor["bufferView"].get<std::size_t>()];
        const fs::path bin = fs::path(gltf).replace_extension(".bin");
        std::string bytes = slurp(bin);
        const std::size_t begin =
            view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
        for (std::size_t key = 0; key < accessor["count"].get<std::size_t>(); ++key) {
            float x = 0.0F;
            char* const at = bytes.data() + begin + 12 * key;
            std::memcpy(&x, at, sizeof(x));
            x += 0.05F;
            std::memcpy(at, &x, sizeof(x));
        }
        spill(bin, bytes);
        return;
    }
    FAIL("the clip moves nowhere");
}

void checkRejected(const LabFolder& lab, const std::string& change) {
    CHECK_FAILS_SAYING(lab.run("P02"), "study.sqlite", "locked", change, "--accept-changes");
}

/// The set beside the database with this hash, as the database tells.
std::string lockedClip(const LabFolder& lab, const std::string& clip) {
    const std::string hash =
        shell("sqlite3 -readonly " + lab.path("study.sqlite") + " 'SELECT locked_hash FROM study'").out;
    return slurp(lab.path("study.locked/" + hash.substr(0, 16) + "/clips/ours/" + clip));
}

}  // namespace

TEST_SUITE("app/lab_files") {
    TEST_CASE(
        "A glTF clip's buffer, and a new word on its bones, are told; the new clip is made from the new "
        "buffer") {
        const LabFolder lab;
        REQUIRE(program("clips convert " + lab.path("clips/direct_T002.bvh") + " " + lab.path("T002.glb"))
                    .status == 0);
        splitGlb(lab.path("T002.glb"), lab.path("clips/moved.gltf"));
        lab.change("clips/manifest.csv", "direct_T002.bvh", "moved.gltf");
        const auto made = lab.simulate();
        REQUIRE_MESSAGE(made.status == 0, made.err);
        const std::string before = lockedClip(lab, "T002.bvh");
        CHECK(before.size() > 1000);
        for (const char* words : {"clips/moved.humanoid.toml", "clips/direct_T003.humanoid.toml"}) {
            lab.write(words, "jaw = \"\"\n");
            checkRejected(lab, std::string(words) + " is new");
            fs::remove(lab.path(words));
        }
        const std::string buffer = lab.read("clips/moved.bin");
        fs::remove(lab.path("clips/moved.bin"));
        checkRejected(lab, "clips/moved.bin is missing");
        lab.write("clips/moved.bin", buffer);
        moveAside(lab.path("clips/moved.gltf"));
        checkRejected(lab, "clips/moved.bin has changed");
        const auto accepted = lab.run("P02", "--accept-changes 'it stood aside'");
        REQUIRE_MESSAGE(accepted.status == 0, accepted.err);
        CHECK(contains(accepted.out, "clips/moved.bin has changed"));
        CHECK(lockedClip(lab, "T002.bvh").size() > 1000);
        CHECK(lockedClip(lab, "T002.bvh") != before);
    }

    TEST_CASE("An avatar's buffer, picture and NAME.humanoid.toml are locked, and a change is told") {
        const LabFolder lab;
        const std::string png("\x89PNG\r\n\x1a\n", 8);
        splitGlb(buildDir() / "share/deixis/avatar.glb", lab.path("figure.gltf"),
                 {{"images", {{{"uri", "skin.png"}}}}});
        lab.write("skin.png", png);
        lab.write("figure.humanoid.toml", "height_m = 1.75\n");
        lab.change("study.toml", "seed = 7", "seed = 7\navatar = \"figure.gltf\"");
        const auto made = lab.simulate();
        REQUIRE_MESSAGE(made.status == 0, made.err);
        const fs::path set = onlySetIn(lab.path("study.locked"));
        for (const std::string name : {"figure.gltf", "figure.bin", "skin.png", "figure.humanoid.toml"}) {
            INFO(name);
            const std::string bytes = lab.read(name);
            CHECK(slurp(set / "avatar" / name) == bytes);
            lab.write(name, bytes + "\n");
            checkRejected(lab, name + " has changed");
            fs::remove(lab.path(name));
            checkRejected(lab, name + " is missing");
            lab.write(name, bytes);
        }
        const auto ran = lab.run("P02");
        CHECK_MESSAGE(ran.status == 0, ran.err);
    }
}
