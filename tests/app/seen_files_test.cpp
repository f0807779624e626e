// Hashes that are remembered are those of the files as they are.
#include "app/study/seen_files.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>

#include "core/hash.hpp"
#include "program.hpp"

using namespace deixis;
using namespace deixis::tests;

namespace {

/// Gives the file back the time of change that it had.
void setChanged(const fs::path& file, const timespec& time) {
    const timespec times[2]{{0, UTIME_OMIT}, time};
    REQUIRE(utimensat(AT_FDCWD, file.c_str(), times, 0) == 0);
}

timespec changed(const fs::path& file) {
    struct stat status {};
    REQUIRE(stat(file.c_str(), &status) == 0);
    return status.st_mtim;
}

}  // namespace

TEST_SUITE("app/seen_files") {
    TEST_CASE("A file that was not touched is not read again; whatever touches it is noticed") {
        const Scratch scratch;
        std::vector<fs::path> files;
        for (const char* name : {"a", "b", "c d"}) {
            files.emplace_back(scratch / name);
            spill(files.back(), name);
        }
        const fs::path memory = scratch / "seen";
        int read = 0;
        const auto hashes = [&] {
            app::SeenFiles seen(memory);
            auto out = seen.hashes(files);
            read = seen.read();
            for (std::size_t i = 0; i < files.size(); ++i) {
                CHECK(out[i].has_value() == fs::exists(files[i]));
                if (out[i]) CHECK(*out[i] == sha256Hex(slurp(files[i])));
            }
        };
        hashes();
        hashes();
        CHECK(read == 3);  // as young as they are, they might change within the same moment
        std::this_thread::sleep_for(std::chrono::milliseconds(2200));
        spill(scratch / "young", "young");
        files.emplace_back(scratch / "young");
        hashes();
        CHECK(read == 4);
        hashes();
        CHECK(read == 1);
        SUBCASE("other bytes, the same size and time of change") {
            const timespec before = changed(files[1]);
            spill(files[1], "B");
            setChanged(files[1], before);
            hashes();
            CHECK(read == 2);
        }
        SUBCASE("another file in its place") {
            spill(scratch / "new", "B");
            setChanged(scratch / "new", changed(files[1]));
            fs::rename(scratch / "new", files[1]);
            hashes();
            CHECK(read == 2);
        }
        SUBCASE("gone") {
            fs::remove(files[1]);
            hashes();
            CHECK(read == 2);
        }
        SUBCASE("what is remembered is damaged") {
            std::string text = slurp(memory);
            text.back() = 'x';
            spill(memory, text);
            hashes();
            CHECK(read == 4);
        }
        SUBCASE("nothing can be remembered") {
            app::SeenFiles seen(scratch / "nowhere/seen");
            CHECK(seen.hashes(files)[0] == sha256Hex("a"));
            CHECK_FALSE(fs::exists(scratch / "nowhere"));
        }
    }
}
