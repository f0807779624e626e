#include "core/name.hpp"

#include <doctest/doctest.h>

#include <map>
#include <thread>
#include <vector>

using deixis::Name;

TEST_SUITE("core/name") {
    TEST_CASE("Names are equal, ordered and printed as their texts") {
        const std::string text = "direct";
        CHECK(Name(text) == Name("direct"));
        CHECK(Name(text) == "direct");
        CHECK(Name("a") != Name("b"));
        CHECK(Name("b") > Name("a"));
        CHECK(Name("a") < Name("ab"));
        CHECK(Name() < Name("a"));
        CHECK(Name("") == Name());
        CHECK(Name().empty());
        CHECK(Name() == "");
        CHECK(fmt::format("{:>7}", Name("P1")) == "     P1");
        std::map<std::string, int> by_text;
        by_text[Name("x")] = 3;
        CHECK(by_text["x"] == 3);
    }

    TEST_CASE("Threads that make the same names get the same") {
        std::vector<std::vector<Name>> made(4);
        {
            std::vector<std::jthread> threads;
            for (auto& names : made)
                threads.emplace_back([&names] {
                    for (int i = 0; i < 2000; ++i) names.emplace_back(std::to_string(i));
                });
        }
        for (const auto& names : made) CHECK(names == made.front());
        CHECK(made.front()[1999] == "1999");
    }
}
