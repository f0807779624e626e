// Tests that cannot be done here say so in a line of their own, "SKIPPED: <case>: <reason>", which
// scripts/test.sh counts in CTest's log: a test case that was left early has passed for doctest.
#pragma once

#include <string>

namespace deixis::tests {

/// Of the test case that runs; call it before leaving, or before leaving something out.
void tellSkipped(const std::string& reason);

}  // namespace deixis::tests
