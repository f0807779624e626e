#!/usr/bin/env bash
# Installs what the tests need, builds, runs the tests, and ends with the counts.
#   scripts/test.sh          style, and every test once, by Clang with address and undefined-behaviour sanitizers
#   scripts/test.sh all      the same, and: the program by GCC, file by file; by Clang without graphics, compared with
#                            GCC's; sessions at the desktop in real time; lint; and the program once more on Debian 13,
#                            where the headset's tests run (needs root)
#   scripts/test.sh dev      one preset's tests only
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install.sh tests
[ -d tests/assets/gltf_validator/node_modules ] || npm ci --silent --prefix tests/assets/gltf_validator
[ -d tests/browser/node_modules ] || npm ci --silent --prefix tests/browser

mkdir -p build/test-logs
counts=()
status=0
say() { echo "== $* ($((SECONDS / 60)) min)"; }
build() {
    say "$1: configure and build"
    local preset=$1 log=build/test-logs/$1-build.log
    shift
    cmake --preset "$preset" -Wno-dev >/dev/null
    if ! cmake --build --preset "$preset" "$@" >"$log" 2>&1; then
        tail -n 60 "$log"
        counts+=("$preset: the build failed")
        return 1
    fi
    tail -n 1 "$log"
}
run_preset() {
    build "$1" || return 1
    say "$1: tests"
    local log=build/test-logs/$1.log result=0
    ctest --preset "$1" -j2 --timeout 1200 2>&1 | tee "$log" || result=$?
    counts+=("$1: $(grep -E 'tests passed' "$log" || echo 'no result')")
    return "$result"
}
run_rest() {
    build dev --target deixis || status=1
    build offline --target deixis || status=1
    say "compare"
    scripts/compare_builds.sh build/dev/deixis build/offline/deixis || status=1
    say "install"
    cmake --install build/offline --prefix build/test-logs/installed >/dev/null || status=1
    if grep -aoE "$PWD/(app|assets|build|core|motion|renderer|results|studies)[ -~]*" build/test-logs/installed/bin/deixis; then
        echo "install: the installed program names the above"
        status=1
    fi
    say "sessions at the desktop"
    ctest --preset dev -R '^desktop/' || status=1
    say "lint"
    scripts/lint.sh || status=1
    say "headset"
    scripts/test_headset.sh --scenarios-only 2>&1 | tee build/test-logs/headset.log || status=1
    counts+=("$(grep -E '^headset: [0-9]+ passed' build/test-logs/headset.log || echo 'headset: no result')")
}

case ${1:-} in
"" | all)
    scripts/check_style.sh
    run_preset asan || status=1
    [ $# -eq 0 ] || run_rest
    ;;
*)
    for preset in "$@"; do run_preset "$preset" || status=1; done
    ;;
esac

echo
printf '%s\n' "${counts[@]}"
say "end"
[ "$status" -eq 0 ] && echo "All passed." || echo "Something failed: see above."
exit "$status"
