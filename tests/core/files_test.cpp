#include "core/files.hpp"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

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

    TEST_CASE("what never ends is rejected, and so is more than the most") {
        for (const char* device : {"/dev/zero", "/dev/urandom", "/dev/null"}) {
            const auto read = readFile(device);
            REQUIRE_FALSE(read);
            CHECK(read.error().text().find(device) == 0);
            CHECK(read.error().text().find("device") != std::string::npos);
        }
        const auto folder = std::filesystem::temp_directory_path() / "deixis_bound_test";
        std::filesystem::remove_all(folder);
        REQUIRE(writeFile(folder / "file.bin", std::string(1001, 'x')));
        CHECK(readFile(folder / "file.bin", 1001).value().size() == 1001);
        CHECK(readFile(folder / "file.bin", 1000).error().text().find("more than 1000 bytes") !=
              std::string::npos);

        // A pipe is read to its end, and no further than the most: whoever still writes then gets an error,
        // not a signal that ends the program.
        const auto signalled = std::signal(SIGPIPE, SIG_IGN);
        const auto pipe = folder / "pipe";
        for (const std::size_t max : {std::size_t{70'000}, std::size_t{60'000}}) {
            REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
            std::thread writer([&] { std::ofstream(pipe) << std::string(70'000, 'y'); });
            const auto read = readFile(pipe, max);
            writer.join();
            CHECK(read.has_value() == (max == 70'000));
            if (read) CHECK(*read == std::string(70'000, 'y'));
            std::filesystem::remove(pipe);
        }
        std::signal(SIGPIPE, signalled);
        std::istringstream stream(std::string(3'000'000, 'z'));
        CHECK(readAll(stream, "standard input").value().size() == 3'000'000);
        std::filesystem::remove_all(folder);
    }

    TEST_CASE("a pipe is written to, not replaced by a file") {
        const auto folder = std::filesystem::temp_directory_path() / "deixis_pipe_test";
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
        const auto pipe = folder / "pipe";
        REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
        std::string got;
        std::thread reader([&] { got = readFile(pipe).value_or("nothing"); });
        const auto written = writeFile(pipe, "words");
        reader.join();
        CHECK(written.has_value());
        CHECK(got == "words");
        CHECK(std::filesystem::is_fifo(pipe));
        std::filesystem::remove_all(folder);
    }
}
