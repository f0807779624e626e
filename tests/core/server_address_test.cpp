#include "core/server_address.hpp"

#include <doctest/doctest.h>

#include <string>

#include "core/error.hpp"

using deixis::withoutPasswords;

TEST_SUITE("core/server_address") {
    TEST_CASE(
        "A server's address is shown without password and without what does not tell which server it is") {
        CHECK(withoutPasswords("postgresql://ann:Sesam@db.lab:5433/pointing") ==
              "postgresql://ann@db.lab:5433/pointing");
        CHECK(withoutPasswords("postgres://ann@db.lab/pointing") == "postgresql://ann@db.lab/pointing");
        CHECK(withoutPasswords("postgresql://db.lab:5433") == "postgresql://db.lab:5433");
        CHECK(withoutPasswords("postgresql://[::1]:5433/x") == "postgresql://[::1]:5433/x");
        CHECK(withoutPasswords("postgresql:///x?host=/run/pg&password=Sesam&port=5&sslpassword=Sesam") ==
              "postgresql:///x?host=/run/pg&port=5");
        CHECK(withoutPasswords("postgresql://db.lab:5433: no answer") ==
              "postgresql://db.lab:5433: no answer");
        CHECK(withoutPasswords("pushed a.sqlite") == "pushed a.sqlite");
        CHECK(withoutPasswords("The following argument was not expected: postgresql://ann:Sesam@h/d") ==
              "The following argument was not expected: postgresql://ann@h/d");
    }

    TEST_CASE("Where a password cannot be told apart nothing of the address is shown, in no error either") {
        for (const char* address :
             {"postgresql://ann:Se@sam@h/d", "postgresql://ann:Se/sam@h/d", "postgresql://ann:Sesam",
              "postgresql://ann:Sesam:1", "postgresql://ann:Se sam@h/d", "postgresql://ann:Se'sam@h/d",
              "postgresql://ann:Se\"s am@h/d", "postgresql://ann:Se@s/am@h?x=y"}) {
            const std::string shown = deixis::Error{address, "found nothing", "Look again"}.text();
            INFO(shown);
            CHECK(shown.rfind("postgresql://...", 0) == 0);
            CHECK(shown.find("Se") == std::string::npos);
            CHECK(shown.find("sam") == std::string::npos);
            CHECK_FALSE(deixis::isPlainServerAddress(address));
        }
    }

    TEST_CASE("An address with a slip in it does not show its password either") {
        for (const char* address :
             {"Postgresql://ann:Sesam@db.lab/pointing", "POSTGRES://ann:Sesam@h/d",
              "postgressql://ann:Sesam@h", "postgresql:/ann:Sesam@h/d", "postgres:ann:Sesam@h",
              "postgre://ann:Se sam@h/d", "psql://ann:Se'sam@h/d", "ann:Sesam@db.lab/pointing",
              "host=h password=Sesam user=ann", "https://ann:Sesam@h/d"}) {
            for (const std::string& text :
                 {std::string(address), "'" + std::string(address) + "': no such file",
                  "--db=" + std::string(address)}) {
                const std::string shown = withoutPasswords(text);
                INFO(shown);
                CHECK(shown.find("Se") == std::string::npos);
                CHECK(shown.find("sam") == std::string::npos);
            }
        }
        CHECK(deixis::looksLikeServerAddress("Postgresql://ann:Sesam@h/d"));
        CHECK(deixis::looksLikeServerAddress("postgre://ann:Sesam@h/d"));
        CHECK_FALSE(deixis::looksLikeServerAddress("study.sqlite"));
        for (const char* text : {"study.toml:12: study.name: found \"a@b\"", "see https://vega.github.io",
                                 "a.csv:3: ann@lab: no"})
            CHECK(withoutPasswords(text) == text);
    }
}
