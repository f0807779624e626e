#!/usr/bin/env bash
# clang-tidy's short allow-list over the product's own sources (not the tests), as the dev preset compiles them.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
log=build/test-logs/lint.log
mkdir -p build/test-logs
# The dev preset is GCC's, and clang does not know every one of its warning options.
if ! run-clang-tidy-14 -quiet -p build/dev -j "$(nproc)" -extra-arg=-Wno-unknown-warning-option \
    "$PWD/(core|motion|assets|studies|results|renderer|app)/.*\.cpp$" >"$log" 2>/dev/null; then
    grep -E 'error|warning' "$log" | sort -u
    echo "lint: clang-tidy found the above"
    exit 1
fi
echo "lint: clang-tidy agrees"
