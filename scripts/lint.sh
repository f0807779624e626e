#!/usr/bin/env bash
# clang-tidy's short allow-list over the product's own sources (not the tests), a room at once: most of the time goes
# into the headers of libraries.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
log=build/test-logs/lint.log
mkdir -p build/test-logs
cmake --preset asan -B build/lint -Wno-dev -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=24 -DDEIXIS_PCH=OFF \
    -DDEIXIS_TESTS=OFF >"$log"
cmake --build build/lint --target deixis_commit >>"$log" # the one source that is made
if ! run-clang-tidy-14 -quiet -p build/lint -j "$(nproc)" -checks=-bugprone-suspicious-include \
    "$PWD/(build/lint/)?(core|motion|physics|learning|assets|studies|results|renderer|speech|server|app)/.*\.c(pp|xx)$" >"$log" 2>/dev/null; then
    grep -E 'error|warning' "$log" | sort -u
    echo "lint: clang-tidy found the above"
    exit 1
fi
echo "lint: clang-tidy agrees"
