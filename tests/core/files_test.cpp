#include "core/files.hpp"

#include <doctest/doctest.h>

#include <filesystem>

using namespace deixis;

TEST_SUITE("core/files") {
    TEST_CASE("a written file reads back byte for byte and leaves no other file behind") {
        const auto folder = std::filesystem::temp_directory_path() / "deixis_files_test";
        std::filesystem::remove_all(folder);
        const std::string bytes("a\0b\r\n\xff", 6);
        REQUIRE(writeFile(folder / "x" / "file.bin", bytes));
        CHECK(readFile(folder / "x" / "file.bin").value() == bytes);
        int files = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder / "x"))
            files += entry.is_regular_file();
        CHECK(files == 1);
        std::filesystem::remove_all(folder);
    }

    TEST_CASE("a missing file and a folder are errors that name the path") {
        const auto missing = readFile("/no/such/file.txt");
        REQUIRE_FALSE(missing);
        CHECK(missing.error().text().find("/no/such/file.txt") == 0);
        CHECK(missing.error().text().find("No such file") != std::string::npos);
        CHECK_FALSE(readFile(std::filesystem::temp_directory_path()));
    }
}
