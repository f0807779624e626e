#!/usr/bin/env bash
# clang-tidy's short allow-list over the product's own sources (not the tests), as the asan preset compiles them:
# several files at once, which takes a quarter of the time.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
log=build/test-logs/lint.log
mkdir -p build/test-logs
if ! run-clang-tidy-14 -quiet -p build/asan -j "$(nproc)" -checks=-bugprone-suspicious-include \
    "$PWD/(build/asan/)?(core|motion|assets|studies|results|renderer|app)/.*\.c(pp|xx)$" >"$log" 2>/dev/null; then
    grep -E 'error|warning' "$log" | sort -u
    echo "lint: clang-tidy found the above"
    exit 1
fi
echo "lint: clang-tidy agrees"
