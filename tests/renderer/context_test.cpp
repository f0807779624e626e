#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "gl_fixture.hpp"

#include "skipping.hpp"

using namespace deixis;
using namespace deixis::renderer;
using namespace deixis::tests;

namespace {

/// Standard output of a shell command.
std::string outputOf(const std::string& command) {
    std::string output;
    FILE* pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::array<char, 4096> part{};
    while (std::fgets(part.data(), static_cast<int>(part.size()), pipe) != nullptr) output += part.data();
    pclose(pipe);
    return output;
}

}  // namespace

TEST_SUITE("renderer/context") {
    TEST_CASE("Drawing needs neither a window nor an X server, and the driver says what it is") {
        unsetenv("DISPLAY");
        Gl gl;
        CHECK(gl.renderer->driver().find("OpenGL") != std::string::npos);
    }

    TEST_CASE("Two contexts one after the other both draw") {
        for (int i = 0; i < 2; ++i) {
            Gl gl;
            CHECK(gl.renderer->capture(emptyScene(), 32, 32).rgb.size() == 32U * 32U * 3U);
        }
    }

    // Mesa reads its settings once in a process, so the next case runs this one in a process of its own.
    TEST_CASE("[child] print why no context can be made" * doctest::skip()) {
        const auto context = OffscreenContext::create();
        std::puts(context ? "a context was made" : context.error().text().c_str());
    }

    TEST_CASE("A driver with an older OpenGL is rejected, naming 4.5 and the version found") {
        {
            Gl gl;
            if (gl.renderer->driver().find("Mesa") == std::string::npos) {
                deixis::tests::tellSkipped("only Mesa can be told to be older than it is");
                return;
            }
        }
        const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
        const std::string output = outputOf("MESA_GL_VERSION_OVERRIDE=3.3 '" + self +
                                            "' --no-skip --test-case='*print why no context*'");
        INFO(output);
        CHECK(output.find("OpenGL 4.5 core is needed, found \"3.3") != std::string::npos);
        CHECK(output.find("Mesa") != std::string::npos);
        CHECK(output.find("a context was made") == std::string::npos);
    }
}

TEST_SUITE("renderer/png") {
    TEST_CASE("A written picture is a PNG of its size, and bytes that do not fit its size are rejected") {
        const auto path = std::filesystem::temp_directory_path() / "deixis_png_test.png";
        Image image{3, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 1, 2, 3, 4, 5, 6, 7, 8, 9}};
        REQUIRE(writePng(path, image));
        FILE* file = std::fopen(path.c_str(), "rb");
        REQUIRE(file != nullptr);
        std::array<unsigned char, 24> head{};
        CHECK(std::fread(head.data(), 1, head.size(), file) == head.size());
        std::fclose(file);
        std::filesystem::remove(path);
        // Signature and IHDR as the PNG specification (ISO 15948, 5.2 and 11.2.2) has them.
        const std::array<unsigned char, 24> expected{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', 0, 0, 0, 13,
                                                     'I',  'H', 'D', 'R', 0,    0,    0,    3,    0, 0, 0, 2};
        CHECK(head == expected);
        image.rgb.pop_back();
        const auto rejected = writePng(path, image);
        REQUIRE_FALSE(rejected.has_value());
        CHECK(rejected.error().text().find("17 bytes, expected 3 x 2 x 3") != std::string::npos);
    }

    TEST_CASE("A picture that cannot be written says where") {
        const auto rejected = writePng("/proc/nowhere/picture.png", {1, 1, {0, 0, 0}});
        REQUIRE_FALSE(rejected.has_value());
        CHECK(rejected.error().text().find("/proc/nowhere/picture.png") != std::string::npos);
    }
}
