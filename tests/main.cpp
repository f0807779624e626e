#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <iostream>

#include "skipping.hpp"

void deixis::tests::tellSkipped(const std::string& reason) {
    const auto* const test = doctest::getContextOptions()->currentTest;
    std::cout << "\nSKIPPED: " << (test == nullptr ? "?" : test->m_name) << ": " << reason << std::endl;
}
