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

    TEST_CASE("a large file is mapped, a small one read, and both are the same") {
        const auto folder = std::filesystem::temp_directory_path() / "deixis_mapped_test";
        std::string bytes;
        for (int i = 0; i < 3000; ++i) bytes += std::to_string(i);
        REQUIRE(writeFile(folder / "file.bin", bytes));
        auto mapped = openFile(folder / "file.bin", 10000);
        REQUIRE(mapped);
        CHECK(mapped->isMapped());
        const FileBytes moved = std::move(*mapped);
        CHECK(moved.view() == bytes);
        const auto read = openFile(folder / "file.bin", 20000);
        REQUIRE(read);
        CHECK_FALSE(read->isMapped());
        CHECK(read->view() == bytes);
        REQUIRE(writeFile(folder / "empty.bin", ""));
        CHECK(openFile(folder / "empty.bin", 0).value().view().empty());
        std::filesystem::remove_all(folder);
    }

    TEST_CASE("a missing file and a folder are errors that name the path") {
        const auto missing = readFile("/no/such/file.txt");
        REQUIRE_FALSE(missing);
        CHECK(missing.error().text().find("/no/such/file.txt") == 0);
        CHECK(missing.error().text().find("No such file") != std::string::npos);
        CHECK_FALSE(readFile(std::filesystem::temp_directory_path()));
        CHECK_FALSE(openFile(std::filesystem::temp_directory_path(), 0));
        CHECK_FALSE(openFile("/no/such/file.txt", 0));
    }
}
