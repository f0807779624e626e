#include "core/hash.hpp"

#include <doctest/doctest.h>

TEST_SUITE("core/hash") {
    TEST_CASE("the hash is SHA-256 as FIPS 180-4 gives it") {
        // Test vectors: NIST, Secure Hash Standard, examples for SHA-256.
        CHECK(deixis::sha256Hex("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
        CHECK(deixis::sha256Hex("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    }
}
